"""Syntax trees to exact expressions in the base units of the file, with their time derivatives."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import sympy as sp

from planar_cli.equation.values.jets import Jet, constant
from planar_cli.equation.values.ledger import Kind, Ledger, exact
from planar_cli.errors import FileProblem, Mark, refuse
from planar_cli.problem.language.evaluation import evaluated
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Name,
    Number,
    Quantity,
    Scaled,
    Side,
)
from planar_cli.problem.language.no_number import quantity_misplaced, state_misplaced
from planar_cli.records import record
from planar_cli.units import parse_unit

FUNCTIONS = {
    "sin": sp.sin,
    "cos": sp.cos,
    "tan": sp.tan,
    "asin": sp.asin,
    "acos": sp.acos,
    "atan": sp.atan,
    "sqrt": sp.sqrt,
    "exp": sp.exp,
    "log": sp.log,
    "abs": sp.Abs,
}


def demand_time(ledger: Ledger, expr: sp.Expr, mark: Mark, what: str) -> None:
    """FileProblem: `expr`, which is `what` in words, uses the time, and the time of this instant is not known."""
    time = ledger.symbols["t"]
    if time in expr.free_symbols and time not in ledger.letters and time not in ledger.values:
        text = f"{what} has a value only at a time that is known"
        raise refuse(mark, "PL590", text, "say at which time: `t = 2 s`")


def no_quantity(quantity: Quantity) -> Jet:
    raise quantity_misplaced(quantity)


@record
class Evaluator:
    """Evaluates sides. `motions`: rate and second derivative of symbols that vary (coordinates), by symbol.

    `quantity`: what to do with v(P), omega(b), …; `earlier`: finds of earlier cases by `case.find`.
    """

    ledger: Ledger
    motions: dict[sp.Symbol, tuple[sp.Expr | None, sp.Expr | None]]
    quantity: Callable[[Quantity], Jet] = no_quantity
    at_state: Callable[[str], Callable[[Side], Jet]] | None = None

    @property
    def speeds(self) -> list[sp.Symbol]:
        """The rates of coordinates that `motion` leaves open. One that it gives may be a symbol too: t, of θ = t²/2."""
        return [r for r, _ in self.motions.values() if isinstance(r, sp.Symbol) and self._is_open(r)]

    @property
    def second_rates(self) -> list[sp.Symbol]:
        """The rates of these."""
        return [a for _, a in self.motions.values() if isinstance(a, sp.Symbol) and self._is_open(a)]

    def _is_open(self, rate: sp.Symbol) -> bool:
        role = self.ledger.roles.get(rate)
        return role is None or role.kind not in (Kind.TIME, Kind.GIVEN, Kind.LETTER, Kind.SOUGHT, Kind.COORDINATE)

    def value(self, side: Side) -> sp.Expr:
        """The value alone."""
        return self.jet(side).value

    def jet(self, side: Side) -> Jet:
        """The value with its derivatives."""
        found: Jet = evaluated(side, self)
        return found

    # --- the numbers of which formulas are made (problem/language/evaluation.py) --------------------------------------

    def number(self, number: Number) -> Jet:
        unit = parse_unit(number.unit) if number.unit else None
        return constant(number.sense * exact(number.value, unit, self.ledger.us))

    def scaled(self, side: Scaled) -> Jet:
        return self.jet(side.operand) * constant(side.sense * exact(_ONE, parse_unit(side.unit), self.ledger.us))

    def asked(self, quantity: Quantity) -> Jet:
        return self.quantity(quantity)

    def at(self, state: str, side: Side) -> Jet:
        if self.at_state is None:
            raise state_misplaced(side.mark)
        return self.at_state(state)(side)

    def named(self, name: Name) -> Jet:
        if name.name == "pi":
            return constant(sp.pi)
        if name.name == "infinity":
            return constant(sp.oo)
        symbol = self.ledger.symbols.get(name.name)
        if symbol is None:
            raise refuse(
                name.mark, "PL504", f"{name.name} has no value here", "give it in `given`, or seek it in `unknowns`"
            )
        rate, second = self.motions.get(symbol, (sp.S.Zero, sp.S.Zero))
        return Jet(symbol, rate, second)

    def combined(self, side: Binary) -> Jet:
        left, right = self.jet(side.left), self.jet(side.right)
        if side.operator == "+":
            return left + right
        if side.operator == "-":
            return left - right
        if side.operator == "*":
            return left * right
        if side.operator == "/":
            if right.value == 0:
                raise divided_by_zero(side)
            return left / right
        if right.rate != 0:
            raise refuse(side.mark, "PL506", "an exponent that varies with time")
        if left.value == 0 and right.value.is_negative:
            raise refuse(side.mark, "PL505", "division by zero")
        return left.power(right.value)

    def called(self, function: Function) -> Jet:
        return self.jet(function.argument).through(FUNCTIONS[function.name])


_ONE = Fraction(1)


def divided_by_zero(side: Binary) -> FileProblem:
    """What is divided by a name or quantity that is zero there."""
    below, name = side.right, ""
    if isinstance(below, Name):
        name = below.name
    if isinstance(below, Quantity) and below.things and all(p.direction is None for p in below.parts):
        name = f"{below.word}({'/'.join(below.things)}){''.join(f'.{p.kind}' for p in below.parts)}"
    text = f"division by zero: {name} is 0 here" if name else "division by zero"
    return refuse(side.mark, "PL505", text, "ask for what is above and below the line apart, or where it is not zero")
