"""A start at rest in an unstable equilibrium: times grow beyond all bounds, and nothing that rests on them is told."""

from __future__ import annotations

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.solve.course.asked_finds import AskedFind
from planar_cli.solve.course.equations import Equation
from planar_cli.solve.course.motion_equations import MotionEquations
from planar_cli.solve.course.stated_motion import StatedMotion

OVER_TIME = ("mean", "impulse")


class Endless(NoSolution):
    """The time is asked that a slight touch takes."""


def without_times(course: MotionEquations) -> tuple[Equation, ...]:
    """The equations that hold in the limit: none in which the time of a later state stands."""
    times = {stop.t for stop in course.stops.values()} - {course.first.t}
    return tuple(e for e in course.equations if not e.residual.free_symbols & times)


def demand_no_times(course: StatedMotion, finds: tuple[AskedFind, ...]) -> None:
    """Endless: something is asked that grows beyond all bounds with the time."""
    times = {stop.t for stop in course.stops.values()} - {course.first.t}
    for asked in finds:
        parts = asked.parts()
        spans = {s for p in parts for s in p.free_symbols if s in course.spanned}
        lasting = any(course.spanned[s].quantity.word in OVER_TIME for s in spans)
        if lasting or any(p.free_symbols & times for p in parts):
            text = f"{asked.find.name}: it begins at rest in an unstable equilibrium, and takes longer without bound"
            hint = "ask for places, velocities and forces, or give the touch: a small angle or speed in the first state"
            raise Endless([Diagnostic(asked.find.mark, "PL621", text, hint)])
