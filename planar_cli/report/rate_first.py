"""A constant acceleration that two states tell, before the force that causes it: a = v_2²/(2 s), then F by its law."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.expansion import expanded
from planar_cli.equation.plain import longer, simplified
from planar_cli.report.blocks import Block, Equation, Math, Paragraph
from planar_cli.report.laws import rate_value
from planar_cli.report.origins import head, is_steady
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import Relation, RouteStep, RouteTrace

MOST = 30
"""A longer formula of the force is told by the relation itself."""


def rate_first(e: Relation, leg: RouteStep, route: RouteTrace, phrases: Phrases, number: int) -> Iterator[Block]:
    """The acceleration as equation `number`, and the last result by it; nothing where the unknown of the relation is no
    constant of the law, or a formula gets long.
    """
    law, (r, *more) = e.law, leg.results
    if law is None or law.order != 2 or not is_steady(e) or more:
        return
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
    yield Equation((Math(r.unknown), phrases.math(force), *(() if numbers is None else (numbers,)), shown))
