"""A check that a person can make of two bodies that meet with a constant relative velocity: the distance between them
at first over the size of that velocity is the time.

relative speed √(43.30² + 25²) = 50 m/s, distance at first D:  D/(50 m/s) = t_meet
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.report.document.blocks import Inline, Line, Math, line
from planar_cli.report.given.given_vectors import size_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation
from planar_cli.solve.law import RELATIVE
from planar_cli.units import LENGTH, VELOCITY

SHORT = 6
"""Operations of a distance in letters."""


def meeting_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """Of the first meeting along both axes; empty where there is none, or the relative speed has no number."""
    found = [e for leg in motion.route.steps for e in leg.relations if e.kind == RELATIVE]
    for one in found:
        other = next((e for e in found if e is not one and (e.since, e.stop) == (one.since, one.stop)), None)
        if other is not None:
            return _told((one, other), motion, phrases)
    return ()


def _told(both: tuple[Relation, Relation], motion: MotionTrace, phrases: Phrases) -> Line:
    time = phrases.ledger.symbols["t"]
    ends = {s.name.rpartition("__")[2]: s for s, own in motion.general.items() if own == time}
    stop = ends.get(both[0].stop)
    if stop is None or not motion.value.is_zero(ends.get(both[0].since, sp.S.Zero)):
        return ()
    speeds = [_closed(-e.residual.diff(stop), motion) for e in both]
    gaps = [_closed(e.residual.xreplace({stop: sp.S.Zero}), motion) for e in both]
    distance, elapsed = simplified(sp.sqrt(simplified(gaps[0] ** 2 + gaps[1] ** 2))), _closed(stop, motion)
    size = sp.sqrt(speeds[0] ** 2 + speeds[1] ** 2)
    if not size.is_number or 0 in speeds or longer(distance, SHORT):
        return ()
    if not identically_zero(size * elapsed - distance):
        return ()
    numbers = [abs(phrases.certain(s)) for s in speeds]
    value = phrases.of_dimension(phrases.certain(size), VELOCITY)
    apart: Inline = phrases.of_dimension(phrases.certain(distance), LENGTH) if distance.is_number else Math(distance)
    head = line("relative speed ", size_of(numbers, VELOCITY, phrases), " = ", value, ", distance at first ", apart)
    return line(*head, ": ", apart, "/(", value, ") = ", Math(stop))


def _closed(expr: sp.Expr, motion: MotionTrace) -> sp.Expr:
    """In the letters of the file."""
    for _ in range(len(motion.route.steps) + 1):
        expr = expr.xreplace(dict(motion.route.plain)).xreplace(dict(motion.route.formulas))
    return simplified(expr)
