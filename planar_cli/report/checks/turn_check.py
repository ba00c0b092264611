"""A check of the times between dead positions: those of both ways, by a crank that turns at a constant rate, are that
of one turn together.

first_way + second_way = 0.3352 + 0.2931 = 0.6283 s,  one turn: 2 π/ω = 2 π / 10 = 0.6283 s
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.motion_phrases import settled_phrases
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.units import TIME

ZERO = Decimal(0)


def turn_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """Of two ways that are asked; empty where they are no whole turn together."""
    dead = [s.in_line.dead for s in motion.route.steps if s.in_line is not None and s.in_line.dead is not None]
    turned = [d.turned for d in dead if d.turned is not None]
    if len(turned) != 2:
        return ()
    one, other = turned
    if sp.sympify(other.formula) != 2 * sp.pi - one.unknown:
        return ()
    asked = {r.parts[0]: r.find.name for r in motion.requests if len(r.parts) == 1}
    angles = {one.unknown, other.unknown}
    rated = [
        (p, name, simplified(d.unknown / p)) for d in turned for p, name in asked.items() if d.unknown in p.free_symbols
    ]
    ways = [(p, name, rate) for p, name, rate in rated if not rate.free_symbols & angles]
    if len(ways) != 2 or ways[0][2] != ways[1][2]:
        return ()
    told = settled_phrases(motion, phrases)
    times = [told.value(p) for p, _, _ in ways]
    figures = figures_of(times, lambda x: sum(x, ZERO), phrases.figures)
    whole = told.of_dimension(sum(times, ZERO), TIME)
    sides = line(Name(ways[0][1]), " + ", Name(ways[1][1]), " = ", " + ".join(significant(x, figures) for x in times))
    turn = 2 * sp.pi / ways[0][2]
    put = (p for m in told.substituted(turn, whole) for p in line(" = ", m))
    return line(*sides, " = ", whole, ", one turn: ", told.math(turn), *put, " = ", whole)
