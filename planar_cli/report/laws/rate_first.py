"""A constant acceleration that two states tell, before the force that causes it: a = v_2²/(2 s), then F by its law."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, line
from planar_cli.report.laws.laws import rate_value
from planar_cli.report.words.origins import balanced, head, is_steady
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Relation, Result, RouteStep, RouteTrace
from planar_cli.solve.law import Law

MOST, FEW = 30, 12
"""A longer formula of the force is told by the relation itself; what holds an acceleration that was told is shorter."""


@record
class ToldRate:
    """A constant acceleration that was told by its letter."""

    rate: sp.Symbol
    law: Law
    unknown: sp.Symbol
    """The force that the law gives by it."""
    force: sp.Expr
    """Its formula."""
    value: Decimal
    """The number of the acceleration, SI."""

    def numbers(self, formula: sp.Expr, phrases: Phrases) -> tuple[Any, ...]:
        """The numbers in a formula that holds the letter; the formula may be the letter itself."""
        others = formula.free_symbols - {self.rate}
        if formula.is_Symbol or any(phrases.value.known(s) is None for s in others):
            return ()
        put = phrases.numbers(formula, {self.rate: self.value, **{s: phrases.value(s) for s in others}})
        return () if put is None else (put,)


def by_told_rate(formula: sp.Expr, rates: Iterable[ToldRate]) -> tuple[ToldRate, sp.Expr] | None:
    """A multiple of an acceleration that was told, by its letter: α_2 = θ̈ r_1/r_2."""
    for told in rates:
        ratio = simplified(formula / told.law.f) if told.unknown in formula.free_symbols else sp.S.NaN
        if ratio is not sp.S.NaN and not ratio.has(told.unknown) and not longer(ratio, FEW):
            return told, ratio * told.rate
    return None


def rate_first(
    e: Relation, leg: RouteStep, route: RouteTrace, phrases: Phrases, number: int, rates: list[ToldRate]
) -> Iterator[Block]:
    """The acceleration as equation `number`, and the last result by it; nothing where the unknown of the relation is no
    constant of the law, or a formula gets long. `rates`: those that were told, to which it is added.
    """
    law, (r, *more) = e.law, leg.results
    if law is None or law.order != 2 or not is_steady(e) or more:
        return
    if known := next((x for x in rates if (x.law.coordinate, x.law.f) == (law.coordinate, law.f)), None):
        return (yield from _by_known(known, e, r, route, phrases, number))
    rate = sp.Symbol(f"{law.coordinate.symbol.name}_ddot", real=True)
    slope = sp.diff(law.f, r.unknown)
    if slope.is_number or slope.has(r.unknown):
        return
    force = simplified((rate - law.f.xreplace({r.unknown: sp.S.Zero})) / slope)
    residual = e.residual.xreplace({r.unknown: force})
    change = simplified(sp.diff(residual, rate))
    above, below = sp.fraction(simplified(-residual.xreplace({rate: sp.S.Zero}) / change).xreplace(dict(route.plain)))
    told = expanded(above) / below
    if told.free_symbols & (law.f.free_symbols | {rate}) or longer(told, MOST) or longer(force, MOST):
        return
    if not phrases.has_numbers(told) or phrases.value.known(told) is None:
        return
    value = rate_value(law, phrases.value(told), phrases)
    yield Paragraph(head(e, phrases.ledger.symbols))
    yield Equation((Math(rate), phrases.math(told), *phrases.substituted(told, value), value), number)
    shown = phrases.shown(r.unknown, r.value)
    sizes = {rate: value.number, **{s: phrases.value(s) for s in force.free_symbols - {rate}}}
    numbers = phrases.numbers(force, sizes)
    rates.append(ToldRate(rate, law, r.unknown, force, value.number))
    yield Equation((Math(r.unknown), phrases.math(force), *(() if numbers is None else (numbers,)), shown))


def _by_known(
    told: ToldRate, e: Relation, r: Result, route: RouteTrace, phrases: Phrases, number: int
) -> Iterator[Block]:
    """A relation by an acceleration that is known, and what follows from it: ω_2 = θ̈ t_2, t_2 = ω_2/θ̈."""
    residual = simplified(e.residual.xreplace({told.unknown: told.force}).xreplace(dict(route.plain)))
    slope = sp.diff(residual, r.unknown)
    if told.unknown in residual.free_symbols or slope == 0 or slope.has(r.unknown):
        return
    formula = simplified(-residual.xreplace({r.unknown: sp.S.Zero}) / slope)
    numbers = told.numbers(formula, phrases)
    if not formula.has(told.rate) or longer(formula, FEW) or not numbers:
        return
    yield Paragraph(head(e, phrases.ledger.symbols))
    yield Equation(tuple(map(phrases.math, balanced(e, residual))), number)
    sides = (phrases.math(r.unknown), phrases.math(formula), *numbers, phrases.shown(r.unknown, r.value))
    yield Equation(sides, None, line(f"({number}):"))
