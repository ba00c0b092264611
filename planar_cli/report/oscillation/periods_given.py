"""Small oscillations in their order: where a period picks a constant, its formula comes first, then what it must be.

T = 2 π/ω_0 = 2 π √((k² + a²)/(g a)); the period is T_A: k = …
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Line, line
from planar_cli.report.oscillation.equilibrium_places import place_blocks
from planar_cli.report.oscillation.oscillation import (
    oscillation_blocks,
    period_line,
    periods_told,
    tells_formula,
    tells_ratio,
)
from planar_cli.report.oscillation.small_deviations import is_of_small_deviations
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import OscillationTrace
from planar_cli.solve.between.trace.trace import MotionTrace, RouteStep

ASKS = re.compile(r"\b(?:period|frequency)\((\w+)\)")
LONGEST = 16
"""A quantity of more operations is not differentiated on the page."""


def held_by_periods(found: MotionTrace) -> dict[str, list[RouteStep]]:
    """The steps in which a period or frequency picks a constant, by the state about which it is; none where something
    else of the route needs that constant before.
    """
    told = {o.state for o in found.oscillations if tells_formula(o, found.value)}
    held: dict[str, list[RouteStep]] = {}
    for leg in found.route.steps:
        states = {m[1] for e in leg.relations for m in [ASKS.search(e.words)] if m}
        if len(states) == 1 and states <= told:
            held.setdefault(states.pop(), []).append(leg)
    picked = {s for legs in held.values() for leg in legs for s in leg.unknowns}
    steps = [leg for legs in held.values() for leg in legs]
    rests = any(leg.needs & picked for leg in found.route.steps if leg not in steps)
    return {} if rests else held


def swings(found: MotionTrace, phrases: Phrases, leg_of: Callable[[RouteStep], Iterator[Block]]) -> Iterator[Block]:
    """Places of equilibrium, and all small oscillations. `leg_of`: how a step of the route is told."""
    periods, held = periods_told(found), held_by_periods(found)
    linear = any(is_of_small_deviations(found, r.solution) for r in found.regimes)
    yield from place_blocks(found, phrases)
    for swing in found.oscillations:
        name, legs = periods.get(swing.state, "T"), held.get(swing.state, [])
        ratio = tells_ratio(found, swing.state)
        if not legs:
            yield from oscillation_blocks(swing, found.value, phrases, phrases.symbolic, name, (), linear, ratio)
            continue
        general = _as_function(name, legs, phrases)
        yield from oscillation_blocks(swing, found.value, phrases, phrases.symbolic, name, general, linear, ratio)
        for leg in legs:
            yield from _derived(leg, swing, phrases, general)
            yield from leg_of(leg)
        if swing.state in periods and not phrases.symbolic:
            yield period_line(swing, found.value, phrases, name)


def _as_function(name: str, legs: Sequence[RouteStep], phrases: Phrases) -> Line:
    """What the period is called before its constant is known: T(b) where the name is that of its smallest value."""
    if not any(e.kind == "extreme" for leg in legs for e in leg.relations):
        return line(phrases.math(sp.Symbol(name)))
    of = sorted({x for leg in legs for x in leg.unknowns}, key=str)
    letters = [part for x in of for part in (", ", phrases.math(x))][1:]
    return line(phrases.math(sp.Symbol("T")), "(", *letters, ")")


def _derived(leg: RouteStep, swing: OscillationTrace, phrases: Phrases, name: Line) -> Iterator[Block]:
    """Where a period is smallest: what of it depends on the constant, and its derivative."""
    (e, *more) = leg.relations
    if more or e.kind != "extreme" or len(leg.unknowns) != 1 or not e.words.startswith("period("):
        return
    (x,) = leg.unknowns
    depends = sp.factor_terms(sp.together(simplified(swing.period**2))).as_independent(x, as_Add=False)[1]
    inside = expanded(depends)
    rate = sp.diff(inside, x)
    if not inside.has(x) or longer(inside, LONGEST) or longer(rate, LONGEST):
        return
    least = factored(depends) if not longer(depends, LONGEST) else inside
    how = "smallest" if "smallest" in e.words else "largest"
    lead = line(*name, f" is {how} where this is:")
    yield Equation((phrases.math(least), phrases.math(inside)), None, lead)
    slope = line("d/d", phrases.math(x), ":")
    yield Equation((phrases.math(rate), phrases.math(sp.S.Zero)), None, slope)
