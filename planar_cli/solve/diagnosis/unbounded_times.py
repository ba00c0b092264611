"""Times and places that grow beyond all bounds: what rests on them is not told, as from an unstable equilibrium."""

from __future__ import annotations

import sympy as sp

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.span_quantities import SpanQuantity
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime import number_function

OVER_TIME = ("mean", "impulse")
NOTICEABLE = 1e-6
"""A place is reached in the end where its rate, in all that time, would change it by less than this part."""


class Endless(NoSolution):
    """The time is asked that a slight touch takes."""


def without_times(course: MotionEquations) -> tuple[Equation, ...]:
    """The equations that hold in the limit: none in which the time of a later state stands."""
    times = {stop.t for stop in course.stops.values()} - {course.first.t}
    return tuple(e for e in course.equations if not e.residual.free_symbols & times)


def without_endless_places(course: MotionEquations, followed: Followed) -> tuple[Equation, ...]:
    """The equations without places that grow beyond all bounds in states which are only approached: what still moves
    there noticeably, beside how far it has ever come in all that time.
    """
    endless: set[sp.Symbol] = set()
    for state in course.states:
        stop, regime = course.stops[state.name], course.readers[state.name].regime
        here = {s: followed.tends[stop.letters[s]] for s in regime.letters if stop.letters[s] in followed.tends}
        if len(here) < len(regime.letters):
            continue
        rates = number_function(list(regime.rates.values()), list(here), course.base())(*here.values())
        for place, rate in zip(regime.rates, rates, strict=True):
            before = [followed.values.get(other.letters[place], 0.0) for other in course.stops.values()]
            if abs(rate * here[regime.time]) > NOTICEABLE * max(map(abs, (here[place], *before))):
                endless.add(stop.letters[place])
    return tuple(e for e in course.equations if not e.residual.free_symbols & endless)


def demand_no_times(course: StatedMotion, finds: tuple[AskedFind, ...]) -> None:
    """Endless: something is asked that grows beyond all bounds with the time."""
    times = {stop.t for stop in course.stops.values()} - {course.first.t}
    for asked in finds:
        parts = asked.parts()
        spans = {s for p in parts for s in p.free_symbols if s in course.spanned}
        lasting = any(_lasts(course, course.spanned[s]) for s in spans)
        if lasting or any(p.free_symbols & times for p in parts):
            text = f"{asked.find.name}: it begins at rest in an unstable equilibrium, and takes longer without bound"
            hint = "ask for places, velocities and forces, or give the touch: a small angle or speed in the first state"
            raise Endless([Diagnostic(asked.find.mark, "PL621", text, hint)])


def _lasts(course: StatedMotion, asked: SpanQuantity) -> bool:
    """Does it rest on how long the span takes? A blow takes no time, however late it comes."""
    a, b = sorted(next(i for i, s in enumerate(course.states) if s.name == n) for n in asked.span)
    return asked.quantity.word in OVER_TIME and not all(i in course.blows for i in range(a, b))
