"""Times that nobody needs: integrals for them are left out, as the motion followed step by step tells the order."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.solve.between.equations.asked_finds import AskedFind, asked_letters
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.regimes.equations import Equation

ONLY_TIMES = ("t(q)", "t(v)")


def without_unneeded_times(course: MotionEquations, finds: tuple[AskedFind, ...]) -> tuple[Equation, ...]:
    """The equations without those that only tell a time which is not asked, and on which nothing else rests."""
    times = {course.stops[s.name].t for s in course.states}
    needed = needed_letters(course, finds) & times
    instants = {b.stop.t: b.since.t for b in course.blows.values()}
    for e in course.equations:
        inside = e.residual.free_symbols & times
        if e.kind in (*ONLY_TIMES, "start") or not inside or _same_time(e, instants):
            continue
        needed |= inside
    known = {course.first.t}
    for blow in course.blows.values():
        known |= {blow.stop.t} if blow.since.t in known else set()
    links = [{blow.since.t, blow.stop.t} for blow in course.blows.values()]
    while True:
        telling = [e for e in course.equations if e.kind in ONLY_TIMES and course.stops[e.stop].t in needed - known]
        more = {t for e in telling for t in e.residual.free_symbols & times}
        more |= {t for pair in links if needed & pair for t in pair}
        if more <= needed:
            return tuple(e for e in course.equations if e.kind not in ONLY_TIMES or e in telling)
        needed |= more


def needed_letters(course: StatedMotion, finds: tuple[AskedFind, ...]) -> set[sp.Symbol]:
    """Letters that finds ask for, and times on which quantities over spans rest."""
    found = asked_letters(finds)
    order = {s.name: i for i, s in enumerate(course.states)}
    for asked in course.spanned.values():
        a, b = (order[n] for n in asked.span)
        low, high = min(a, b), max(a, b)
        if not all(i in course.blows for i in range(low, high)):
            found |= {course.stops[s.name].t for s in course.states[: high + 1]}
    return found


def _same_time(e: Equation, instants: dict[sp.Symbol, sp.Symbol]) -> bool:
    """Does it say no more than that a blow takes no time?"""
    return e.kind == "link" and any(expanded(e.residual - (t - s)) == 0 for t, s in instants.items())
