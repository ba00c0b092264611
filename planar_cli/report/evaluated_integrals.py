"""What an integral over time of a law in numbers comes to, as a function of the time at its end:

y_L,one = 0.6 (t_one - 4 sin(π t_one/4)/π)   in m
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.plain import longer, simplified
from planar_cli.report.blocks import Block, Equation
from planar_cli.report.laws import integral_note, running
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace, Relation, RouteTrace

LONGEST = 24
"""A longer function is left to its numbers."""


def evaluated(e: Relation, route: RouteTrace, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """A place at the end of an integral that is told with numbers; nothing of a polynomial, or where no term goes with
    the time itself.
    """
    if e.span is None or e.span.kind != "q(t)" or e.span.explicit is None or phrases.symbolic:
        return
    times = {own for own, general in found.general.items() if general.name == "t"}
    letter = next((s for s, general in found.general.items() if _is_end(s, general, e, found)), None)
    formula = sp.expand(simplified(e.span.explicit.xreplace(dict(route.plain))))
    ends = formula.free_symbols & times
    if letter is None or len(ends) != 1 or formula.is_polynomial(*ends) or longer(formula, LONGEST):
        return
    (end,) = ends
    steady = formula.coeff(end, 1)
    if steady == 0:
        return
    shown = running(
        sp.Mul(steady, sp.expand(formula / steady), evaluate=False), {*ends, *found.unknowns}, phrases, e.law
    )
    if shown.values:
        yield Equation((phrases.math(letter), shown), None, (), integral_note(e.law, e.kind, [shown], phrases))


def _is_end(own: sp.Symbol, general: sp.Symbol, e: Relation, found: MotionTrace) -> bool:
    """Is it the letter of the coordinate of the law at the end of the relation?"""
    return e.law is not None and general == e.law.coordinate.symbol and found.ledger.roles[own].at == e.stop
