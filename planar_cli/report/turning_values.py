"""Largest and smallest values over time: where the derivative is zero, one kind of root is the largest, the other the
smallest value.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.report.blocks import Line, Math, Paragraph, line
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace, Relation, Result
from planar_cli.solve.instant.roots import Root

LARGEST, SMALLEST = " is largest", " is smallest"
DERIVATIVE = "where its derivative is zero"


def over_time(e: Relation) -> bool:
    """Is it the condition of a largest or smallest value over time?"""
    return e.kind == "extreme" and e.words.endswith((LARGEST, SMALLEST))


def other_kind(found: MotionTrace, r: Result, left: list[Root], phrases: Phrases) -> Paragraph | None:
    """`not 3 T/4: there it is smallest`, where that is true of all other roots; None: it is not, or no such value."""
    relations = [e for leg in found.route.steps if r in leg.results for e in leg.relations]
    if len(relations) != 1 or not over_time(relations[0]) or not left:
        return None
    slope = sp.diff(relations[0].residual, r.unknown)
    if any(found.value.known(s) is None for s in slope.free_symbols):
        return None

    def sense(at: Decimal) -> Decimal:
        return found.value.extended({r.unknown: at})(slope)

    own = sense(r.value)
    if not own or not all(own * sense(x.value) < 0 for x in left):
        return None
    parts: list[str | Math | Line] = []
    for i, x in enumerate(left):
        letters = x.expression is not None and not x.expression.is_number
        shown = phrases.math(x.expression) if letters else phrases.shown(r.unknown, x.value)
        parts += [*([", "] if i else []), line(shown)]
    kind = "smallest" if relations[0].words.endswith(LARGEST) else "largest"
    return Paragraph(line("not ", *parts, f": there it is {kind}"))
