"""What is asked of a motion, in the letters of its states: name = formula = numbers = value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.ledger import display
from planar_cli.equation.plain import longer, simplified
from planar_cli.problem.outermost import is_energy
from planar_cli.records import record
from planar_cli.report.blocks import Block, Equation, Name, Paragraph, Value, line
from planar_cli.report.words import Phrases, told_unit
from planar_cli.solve.between.trace import MotionTrace, Request

HENCE = Paragraph(line("Hence:"))
LONGEST = 90
"""A longer formula is not told."""


@record
class AskedTelling:
    """Tells the finds of one motion that are more than a letter. `numeric`: in which is told what rests on no letter
    without a number; `wanted`: names of letters whose derivation is told (None: all).
    """

    found: MotionTrace
    phrases: Phrases
    numeric: Phrases
    wanted: frozenset[str] | None

    def blocks(self) -> Iterator[Block]:
        """A heading, and a line for each component."""
        zeros = {s: f for s, f in self.found.route.formulas.items() if f == 0}
        told = False
        for asked in self.found.requests:
            if asked.find.name in self.found.passing or (self.wanted is not None and not self.wanted):
                continue
            parts = [self._signed(_without(p, zeros)) for p in asked.parts]
            if asked.unit is None or not all(self._is_formula(p) for p in parts):
                continue
            if not told:
                yield HENCE
                told = True
            for axis, part in zip(("x", "y") if len(parts) > 1 else ("",), parts, strict=True):
                yield self._line(asked, axis, part)

    def _is_formula(self, p: sp.Expr) -> bool:
        return not (p.is_Symbol or p.is_number or longer(p, LONGEST) or p.free_symbols & self.found.varying)

    def _line(self, asked: Request, axis: str, part: sp.Expr) -> Equation:
        sides: list[Any] = [line(Name(asked.find.name), f", {axis}" if axis else ""), self.phrases.math(part)]
        phrases = self.numeric if self.numeric.has_numbers(part) else self.phrases
        if phrases.symbolic or asked.unit is None:
            return Equation(tuple(sides))
        unit, energy = asked.unit, is_energy(asked.find.found.what)
        value = Decimal(0) if self.found.value.is_zero(part) else self.found.value(part)
        shown = Value(display(value, unit), told_unit(unit, energy), self.phrases.figures)
        own = self.phrases.page_unit(unit)
        kept = unit.text == "deg" or display(Decimal(1), unit) == display(Decimal(1), own)
        first = shown if kept else Value(display(value, own), told_unit(own, energy), self.phrases.figures)
        return Equation((*sides, *phrases.substituted(part, first), first, *([] if kept else [shown])))

    def _signed(self, expr: sp.Expr) -> sp.Expr:
        """|a| and sign a by the number that a has at its state; the direction of (a cos x, a sin x) where it is x."""
        if self.phrases.symbolic or not expr.has(sp.Abs, sp.sign, sp.atan2):
            return expr
        expr = expr.replace(lambda x: isinstance(x, sp.atan2), self._direction)

        def sense(a: sp.Expr) -> int:
            return int(self.found.value.known(sp.sign(a)) or 0)

        def put(x: Any) -> Any:
            s = sense(x.args[0])
            return x if not s else (s * x.args[0] if isinstance(x, sp.Abs) else sp.Integer(s))

        if not expr.has(sp.Abs, sp.sign):
            return expr
        return simplified(expr.replace(lambda x: isinstance(x, sp.Abs | sp.sign), put))

    def _direction(self, found: sp.Expr) -> sp.Expr:
        y, x = found.args
        for sine in y.atoms(sp.sin):
            angle = sine.args[0]
            if y / sine == x / sp.cos(angle) and self.found.value.is_zero(found - angle):
                return angle
        return found


def _without(expr: sp.Expr, zeros: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """An expression without letters that are zero."""
    found = expr.xreplace(dict(zeros))
    return expr if found.has(sp.nan, sp.zoo) else found
