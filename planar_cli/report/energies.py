"""A balance of energies told as the course writes it: T of every body, U of every force, each with its number.

v_G and ω by the unknown speed, T = m v_G²/2 + I ω²/2;  U = m g (y_1 - y_2);  stretches, U = k (s_1² - s_2²)/2
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.ledger import display
from planar_cli.equation.plain import longer, simplified
from planar_cli.principles.base import Moving, Storage
from planar_cli.records import record
from planar_cli.report.alike import told_of_each, weights_of_each
from planar_cli.report.blocks import Block, Equation, Line, Math, Name, Value, line
from planar_cli.report.clean import is_clean
from planar_cli.report.in_numbers import SMALL
from planar_cli.report.notation import plain
from planar_cli.report.numbers import quantity, significant
from planar_cli.report.ordering import NUMBER
from planar_cli.report.page_units import coherent_unit
from planar_cli.report.put_in import Writer, partly
from planar_cli.report.words import Phrases, told_unit
from planar_cli.solve.between.trace import BalanceTrace
from planar_cli.units import (
    ENERGY,
    FORCE,
    INERTIA,
    LENGTH,
    MASS,
    RATE,
    STIFFNESS,
    VELOCITY,
    Dimension,
    Unit,
    parse_unit,
    pretty_unit,
)

SHORT = 16
"""With more operations a formula of an energy is told by what it is made of."""
FEW = 8
"""With more operations a speed is told in numbers."""
WIDE = 88
"""So many characters of a chain fit into a line."""
STATE = "__"
UNITS = {"v": ("m/s", VELOCITY), "omega": ("rad/s", RATE)}


@record
class EnergyTelling:
    """Tells the parts of one balance. `unknowns`: what it is solved for; `plain`: letters that are data, with what they
    are. All else has a number.
    """

    balance: BalanceTrace
    unknowns: Collection[sp.Symbol]
    phrases: Phrases
    plain: Mapping[sp.Symbol, sp.Expr]
    told: set[tuple[sp.Symbol, sp.Expr]]
    """The stretches that were told before."""

    def lines(self) -> Iterator[Block]:
        """T at the beginning and at the end, and what every source brings."""
        b = self.balance
        first, last = f"{b.law.letter}_{b.since}", f"{b.law.letter}_{b.stop}"
        yield self._line(line(Name(first)), *self._chain(self._put(b.before)))
        amounts = [(body, put) for body, e in b.amounts if not self._vanishes(put := self._put(e))]
        bodies = told_of_each(amounts)
        for i, (body, put) in enumerate(amounts):
            if i in bodies:
                each = f" of {bodies[i]}" if len(amounts) > 1 else ""
                yield from self._amount(body, put, line(Name(last), each))
        if not amounts:
            yield Equation((line(Name(last)), self.phrases.math(sp.S.Zero)))
        elif len(amounts) > 1:
            yield self._line(line(Name(last)), *self._summed(self._put(b.after)))
        springs = sum(s.power == 2 for s in b.parts.storages) if b.parts is not None else 0
        sources = [(words, put) for words, e in b.brought if not self._vanishes(put := self._put(e))]
        told = weights_of_each(sources)
        for i, (words, put) in enumerate(sources):
            if i in told:
                yield from self._brought(words, put, springs > 1, told[i])

    def _put(self, expr: sp.Expr) -> sp.Expr:
        put = sp.sympify(expr).xreplace(dict(self.plain))
        return put if longer(put, SHORT * 4) else simplified(put)

    def _vanishes(self, put: sp.Expr) -> bool:
        """Is it nothing, whatever is sought?"""
        if put == 0 or put.free_symbols & set(self.unknowns):
            return bool(put == 0 or self._summed(put)[0].expr == 0)
        return self.phrases.value.is_zero(put)

    # --- kinetic energies --------------------------------------------------------------------------------------------

    def _amount(self, body: str, put: sp.Expr, lead: Line) -> Iterator[Block]:
        """T of one body at the end: from the speed of its mass centre and of turning, in a line before."""
        made = next((m for m in self.balance.parts.moving if m.body == body), None) if self.balance.parts else None
        speeds = [] if made is None else list(self._speeds(made))
        if made is None or not speeds or (len(speeds) == 1 and self._short(put) and not self._by_others(speeds[0][2])):
            yield self._line(lead, *self._chain(put))
            return
        told: list[Any] = []
        for kind, own, expr in speeds:
            if own != expr:
                told += [",  ", Math(own)] if told else [Math(own)]
                told += [x for side in self._speed(expr, kind) for x in (" = ", side)]
        if told:
            yield Equation((line(told[0]), line(*told[2:])))
        masses, texts = {"v": made.mass, "omega": made.inertia}, {}
        for kind, dimension in (("v", MASS), ("omega", INERTIA)):
            if not is_clean(self.phrases.ledger, masses[kind], dimension=dimension):
                number = sp.Symbol(f"{NUMBER}{kind}", positive=True)
                texts[number] = significant(self.phrases.value(masses[kind]), self.phrases.figures)
                masses[kind] = number
        terms = (masses[kind] * own**2 / 2 for kind, own, _ in speeds)
        formula = sp.Add(*(simplified(t) if not longer(t, SHORT) else t for t in terms), evaluate=False)
        yield self._line(lead, *self._fitting(Math(formula, texts) if texts else self.phrases.math(formula), put))

    def _by_others(self, expr: sp.Expr) -> bool:
        """Is a speed more than the size of the one that is sought or known?"""
        return not (expr.is_Symbol or (isinstance(expr, sp.Abs) and expr.args[0].is_Symbol))

    def _speeds(self, made: Moving) -> Iterator[tuple[str, sp.Symbol, sp.Expr]]:
        """The speed of the mass centre and that of turning, those that are not zero."""
        stop = self.balance.stop
        square = self._put(made.vx) ** 2 + self._put(made.vy) ** 2
        v = sp.sqrt(square if longer(square, SHORT * 4) else simplified(square))
        for kind, mass, name, expr in (
            ("v", made.mass, f"v_{self._centre(made)}", v),
            ("omega", made.inertia, f"omega_{made.body}", self._put(made.omega)),
        ):
            if mass != 0 and not self._vanishes(expr):
                own = expr if expr.is_Symbol else sp.Symbol(f"{name}{STATE}{stop}", real=True)
                yield kind, *self._named(own, expr, made.body)

    def _centre(self, made: Moving) -> str:
        """The mass centre as an index: its point, of a particle its name, else G with the body's name."""
        if made.center != made.body or made.inertia == 0:
            return made.center
        moving = self.balance.parts.moving if self.balance.parts is not None else ()
        return "G" if sum(m.inertia != 0 for m in moving) == 1 else f"G,{made.body}"

    def _named(self, own: sp.Symbol, expr: sp.Expr, body: str) -> tuple[sp.Symbol, sp.Expr]:
        """A speed with the sign of the letter that the motion has for it; where that letter is something else, another
        name.
        """
        known = self.phrases.value.known(own)
        if known is None:
            return own, expr
        size = self.phrases.value(expr)
        if abs(abs(known) - abs(size)) > abs(size) * SMALL:
            return sp.Symbol(f"{own.name[0]}_G_{body}{STATE}{self.balance.stop}", real=True), expr
        return own, expr if known * size >= 0 else -expr

    def _speed(self, expr: sp.Expr, kind: str) -> tuple[Any, ...]:
        """A speed in letters where they are few, else in numbers; the root of c u² is √c u, with the sign that makes
        it positive.
        """
        moving = [s for s in expr.free_symbols if s in self.unknowns]
        if len(moving) == 1 and self._linear(expr, moving[0]):
            u = moving[0]
            factor = (expr / u).xreplace({u: sp.Integer(1 if self.phrases.value(u) >= 0 else -1)})
            expr = factor * u if longer(factor, SHORT) else simplified(factor) * u
        unit, dimension = UNITS[kind]
        few = not longer(expr, FEW) and self._short(expr, dimension) and not expr.has(sp.Abs)
        letters = (self.phrases.math(expr),) if few else ()
        if few and moving:
            return letters
        last = self._summed(expr, unit)
        return (*letters, *(self.phrases.substituted(expr, last[0]) if few else ()), *last)

    def _linear(self, expr: sp.Expr, u: sp.Symbol) -> bool:
        """Is it |u| or u times something without u?"""
        ratio, own = expr / u, sp.Rational(str(self.phrases.value(u)))
        if own == 0:
            return False
        here = [self.phrases.value(ratio.xreplace({u: own * k})) for k in (1, 2)]
        return abs(here[0] - here[1]) <= abs(here[0]) * SMALL

    # --- work --------------------------------------------------------------------------------------------------------

    def _brought(self, words: str, put: sp.Expr, several: bool, each: str) -> Iterator[Block]:
        """U of one source. `several`: springs, whose stretches need names of their own; `each`: of which it is said."""
        lead = line(Name(self.balance.law.bring), f" of the {each}")
        storages = self.balance.parts.storages if self.balance.parts is not None else ()
        made = next((s for s in storages if s.words == words), None)
        if made is None or (made.power == 2 and self._short(put)):
            yield self._line(lead, *self._chain(put))
        elif made.power == 1:
            yield self._line(lead, *self._height(made, put))
        else:
            yield from self._spring(made, put, lead, several)

    def _height(self, made: Storage, put: sp.Expr) -> tuple[Any, ...]:
        """m g (y_1 - y_2)."""
        ends = [self._put(e) for e in (made.first, made.last)]
        if self._short(put) and all(e.is_Symbol or e == 0 for e in ends):
            return self._chain(put)
        own = [sp.Symbol(f"{made.letter}{STATE}{n}", real=True) for n in (self.balance.since, self.balance.stop)]
        factor, texts = self._factor(made, FORCE)
        told = sp.Mul(factor, sp.Add(own[0], -own[1], evaluate=False), evaluate=False)
        numbers = self._with(told, dict(zip(own, ends, strict=True)), texts)
        return self._fitting(Math(told, texts) if texts else self.phrases.math(told), put, numbers)

    def _factor(self, made: Storage, dimension: Dimension) -> tuple[sp.Expr, dict[sp.Symbol, str]]:
        """m g or k; a number, where letters alone do not make it."""
        if is_clean(self.phrases.ledger, made.factor, dimension=dimension):
            return made.factor, {}
        number = sp.Symbol(f"{NUMBER}factor", positive=True)
        return number, {number: significant(self.phrases.value(made.factor), self.phrases.figures)}

    def _spring(self, made: Storage, put: sp.Expr, lead: Line, several: bool) -> Iterator[Block]:
        """k (s_1² - s_2²)/2, the stretches in lines of their own, each once."""
        letter = "delta" if made.letter in self.phrases.ledger.symbols else made.letter
        name = made.words.rpartition(" ")[2]
        ends = {}
        for state, expr in ((self.balance.since, made.first), (self.balance.stop, made.last)):
            own = sp.Symbol(f"{letter}_{name}{STATE}{state}" if several else f"{letter}{STATE}{state}", real=True)
            ends[own] = self._put(expr)
            if (own, ends[own]) not in self.told:
                self.told.add((own, ends[own]))
                yield Equation((line(f"stretch of the {made.words}, ", Math(own)), *self._length(ends[own])))
        one, two = ends
        inside = sp.Add(one**2, -(two**2), evaluate=False)
        factor, texts = self._factor(made, STIFFNESS)
        told = sp.Mul(sp.Rational(1, 2), factor, inside, evaluate=False)
        formula = Math(told, texts) if texts else self.phrases.math(told)
        yield self._line(lead, formula, *self._numbers(put, self._with(told, ends, texts)))

    def _line(self, *sides: Any) -> Equation:
        """One energy, with its unit where numbers stand beside unknowns."""
        mixed = isinstance(sides[-1], Math) and sides[-1].values
        unit = coherent_unit(ENERGY, us=self.phrases.ledger.us)
        return Equation(sides, None, (), line(f"in {pretty_unit(told_unit(unit, True))}") if mixed else ())

    # --- pieces ------------------------------------------------------------------------------------------------------

    def _short(self, put: sp.Expr, dimension: Dimension = ENERGY) -> bool:
        return not longer(put, SHORT) and is_clean(self.phrases.ledger, put, dimension=dimension)

    def _fitting(self, formula: Math, put: sp.Expr, numbers: tuple[Any, ...] = ()) -> tuple[Any, ...]:
        """A formula of what an energy is made of, then as much of its letters and numbers as one line holds.
        `numbers`: the formula with its numbers.
        """
        last = self._numbers(put, ())
        letters = (self.phrases.math(put),) if self._short(put) and not put.is_number else ()
        value = last[0]
        substituted = tuple(self.phrases.substituted(put, value)) if letters and isinstance(value, Value) else ()
        whole = (formula, *letters, *substituted, *last)
        if letters and _fits(whole):
            return whole
        if letters and not isinstance(value, Value) and _fits(short := (formula, *letters, *last)):
            return short
        return (formula, *(numbers if isinstance(value, Value) else ()), *last)

    def _numbers(self, put: sp.Expr, numbers: tuple[Any, ...]) -> tuple[Any, ...]:
        """What it is by the unknowns; or its value, after the numbers put in."""
        if put.free_symbols & set(self.unknowns):
            return self._summed(put)
        return (*numbers, self._joule(put))

    def _chain(self, put: sp.Expr) -> tuple[Any, ...]:
        """A formula, its numbers, and its value or what it is by the unknowns."""
        if put == 0:
            return (self.phrases.math(put),)
        about = self._about_axis(put)
        if put.free_symbols & set(self.unknowns):
            if about is not None:
                return (self.phrases.math(about), *self._summed(put))
            shown = self._summed(put)
            formula = self.phrases.math(put)
            return (formula, *(s for s in shown if s != formula)) if self._short(put) else shown
        value = self._joule(put)
        if about is not None:
            return (self.phrases.math(about), *self.phrases.substituted(about, value), value)
        if not put.is_number and not is_clean(self.phrases.ledger, put, dimension=ENERGY):
            part = partly(put, [s for s in put.free_symbols if STATE in s.name], self.phrases)
            if part is not None:
                return part, value
        formulas = (self.phrases.math(put),) if not put.is_number and not longer(put, 2 * SHORT) else ()
        return (*formulas, *(self.phrases.substituted(put, value) if formulas else ()), value)

    def _about_axis(self, put: sp.Expr) -> sp.Expr | None:
        """I_A ω²/2 of a body that turns about a fixed point A, where lengths are numbers of the file; None: it does
        not, or nothing on the page has defined I_A.
        """
        ledger = self.phrases.ledger
        speeds = [s for s in put.free_symbols if s in ledger.units and ledger.units[s].dimension == RATE]
        if len(speeds) != 1 or is_clean(ledger, put, dimension=ENERGY):
            return None
        factor = 2 * put / speeds[0] ** 2
        if simplified(factor).free_symbols & {speeds[0]}:
            return None
        for symbol in ledger.definitions:
            title = ledger.titles.get(symbol, "")
            fixed = title.startswith("moment of inertia") and " about " in title
            if fixed and self.phrases.value.is_zero(simplified(factor) - symbol):
                return symbol * speeds[0] ** 2 / 2
        return None

    def _summed(self, expr: sp.Expr, unit: str = "J") -> tuple[Any, ...]:
        """A formula with numbers for all but the unknowns. `unit`: of one that has none of these."""
        if not expr.free_symbols & set(self.unknowns):
            return (self._value(expr, parse_unit(unit)),)
        writer = Writer(self.unknowns, self.phrases)
        found = writer.written(expr)
        return (self.phrases.math(expr) if found is None else Math(found, writer.texts),)

    def _joule(self, expr: sp.Expr) -> Value:
        return self._value(expr, parse_unit("J"))

    def _length(self, expr: sp.Expr) -> tuple[Any, ...]:
        """A stretch: its formula where that is short, its number."""
        if expr.free_symbols & set(self.unknowns):
            return self._summed(expr)
        value = self._value(expr, parse_unit("m"))
        clean = expr.free_symbols and self._short(expr, LENGTH)
        return (self.phrases.math(expr), *self.phrases.substituted(expr, value), value) if clean else (value,)

    def _value(self, expr: sp.Expr, unit: Unit) -> Value:
        own = self.phrases.page_unit(unit)
        text = told_unit(own, unit.dimension == ENERGY)
        zero = self.phrases.value.is_zero(expr)
        number = display(self.phrases.value(sp.S.Zero if zero else expr), own, self.phrases.ledger.us)
        return Value(number, text, self.phrases.figures)

    def _with(
        self, told: sp.Expr, ends: Mapping[sp.Symbol, sp.Expr], numbers: Mapping[sp.Symbol, str]
    ) -> tuple[Any, ...]:
        """A formula with heights or stretches as numbers. `numbers`: what is one already."""
        rest = sp.Add(*(told.free_symbols - set(ends) - set(numbers)))
        known = self.phrases.numbers(rest) if rest != 0 else None
        if rest != 0 and (known is None or known.values is None):
            return ()
        texts = {**(known.values or {} if known is not None else {}), **numbers}
        for own, expr in ends.items():
            texts[own] = significant(self._value(expr, parse_unit("m")).number, self.phrases.figures)
        return (Math(told, texts),)


def _fits(sides: tuple[Any, ...]) -> bool:
    """Does a chain of formulas stand in one line?"""
    texts = (plain(s.expr, s.values) if isinstance(s, Math) else quantity(s.number, s.unit, s.figures) for s in sides)
    return sum(len(t) + 3 for t in texts) <= WIDE
