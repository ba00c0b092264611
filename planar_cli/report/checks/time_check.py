"""A check of a time that was found by a velocity: the place at that time, by constant acceleration, is the one stated.

y_ball,half = h + v0 t_half - 1/2 g t_half² = h/2
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.in_numbers.with_units import with_units
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.motion_phrases import settled_phrases
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation

SHORT = 10


def time_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """In letters, with the units of numbers among them, or in numbers alone; empty where the page goes over the place
    at that time itself, or it is long.
    """
    relations = [e for leg in motion.route.steps for e in leg.relations]
    for e in relations:
        gone = any((o.since, o.stop, o.kind, o.law) == (e.since, e.stop, "q(t)", e.law) for o in relations)
        if motion.symbolic and e.kind == "v(t)" and not gone and (told := _told(e, motion, phrases)):
            return told
    return ()


def _told(e: Relation, motion: MotionTrace, phrases: Phrases) -> Line:
    law = e.law
    if law is None or law.order != 2 or law.factor != 1 or law.speed is None or law.f == 0:
        return ()
    t = phrases.ledger.symbols["t"]
    if law.f.free_symbols & {law.coordinate.symbol, law.v, law.speed, t}:
        return ()
    ends = {(g, s.name.rpartition("__")[2]): s for s, g in motion.general.items()}
    wanted = [(law.coordinate.symbol, e.since), (law.speed, e.since), (t, e.stop), (law.coordinate.symbol, e.stop)]
    if any(w not in ends for w in wanted) or not motion.value.is_zero(ends.get((t, e.since), sp.S.Zero)):
        return ()
    q, v, time = (motion.route.plain.get(ends[w], ends[w]) for w in wanted[:3])
    formula = q + v * time + law.f * time**2 / 2
    closed = [_closed(x, motion) for x in (formula, ends[wanted[3]])]
    if not identically_zero(closed[0] - closed[1]) or longer(formula, SHORT) or longer(closed[1], SHORT):
        return ()
    if ends[wanted[3]] not in motion.route.formulas or not time.free_symbols & set(motion.general):
        return ()
    place, result = ends[wanted[3]], simplified(closed[1])
    if is_clean(phrases.ledger, place, result):
        return line(Math(place), " = ", phrases.math(formula), " = ", phrases.math(result))
    numeric = settled_phrases(motion, phrases)
    if not numeric.has_numbers(formula + place):
        spelled = with_units(result, phrases.ledger.units[place].dimension, phrases)
        clean = is_clean(phrases.ledger, place, formula)
        return line(Math(place), " = ", phrases.math(formula), " = ", spelled) if spelled and clean else ()
    value = numeric.shown(place)
    put = numeric.substituted(formula, value)
    return line(Math(place), " = ", phrases.math(formula), *(p for m in put for p in line(" = ", m)), " = ", value)


def _closed(expr: sp.Expr, motion: MotionTrace) -> sp.Expr:
    """In the letters of the file."""
    for _ in motion.route.steps:
        expr = expr.xreplace(dict(motion.route.formulas))
    return expr
