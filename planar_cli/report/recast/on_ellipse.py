"""Where something is on an ellipse at a given time, in coordinates, where these alone are asked and the nearest point
of the orbit lies on the axis of x: x = a (cos E - ε), y = a √(1 - ε²) sin E.

The distance r and the direction φ need not be found for that, and close to φ = π the sine of φ would lose figures.
(From r = a (1 - ε cos E) and tan(φ/2) = √((1 + ε)/(1 - ε)) tan(E/2); ellipse with its centre at -a ε.)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.records import record
from planar_cli.solve.between.trace.trace import MotionTrace, RouteStep
from planar_cli.solve.law import ANOMALY
from planar_cli.solve.solved_problem import PartSolution


@record
class _Place:
    """The letters of a state on an ellipse: r, φ, and x and y by the eccentric anomaly; the steps that give r and φ."""

    r: sp.Symbol
    phi: sp.Symbol
    x: sp.Expr
    y: sp.Expr
    steps: tuple[RouteStep, RouteStep]


def with_ellipse_coordinates(part: PartSolution) -> PartSolution:
    """The part, its coordinates on an ellipse by the eccentric anomaly where nothing else needs r and φ."""
    motion = part.motion
    if motion is None or not any(e.kind == ANOMALY for leg in motion.route.steps for e in leg.relations):
        return part
    for place in list(_places(motion)):
        motion = _told(motion, place)
    return part if motion is part.motion else replace(part, motion=motion)


def _told(motion: MotionTrace, place: _Place) -> MotionTrace:
    own = {place.r, place.phi}
    put = {place.r * sp.cos(place.phi): place.x, place.r * sp.sin(place.phi): place.y}
    requests = tuple(replace(q, parts=tuple(put.get(p, p) for p in q.parts)) for q in motion.requests)
    asked = {s for q in requests for p in q.parts for s in sp.sympify(p).free_symbols}
    asked |= {s for q in requests for pair in q.beside for p in pair for s in sp.sympify(p).free_symbols}
    steps = tuple(leg for leg in motion.route.steps if leg not in place.steps)
    needed = {s for leg in steps for s in leg.needs}
    if requests == motion.requests or own & (asked | needed) or motion.spans or own & motion.named.keys():
        return motion
    return replace(motion, requests=requests, route=replace(motion.route, steps=steps))


def _places(motion: MotionTrace) -> Iterator[_Place]:
    """Of each state to which Kepler's equation leads."""
    steps = {leg.unknowns[0]: leg for leg in motion.route.steps if _is_alone(leg)}
    for r, leg in steps.items():
        e = leg.relations[0]
        waves = e.residual.atoms(sp.cos)
        if len(waves) != 1 or motion.ledger.roles[r].at != e.stop:
            continue
        (wave,) = waves
        other = next(
            (s for s, x in steps.items() if s != r and x.relations[0].stop == e.stop and _turns(x, wave)), None
        )
        if other is None:
            continue
        a = r - e.residual.xreplace({wave: sp.S.Zero})
        epsilon = sp.cancel((e.residual.xreplace({wave: sp.S.One}) - r + a) / a)
        sense = sp.diff(turned := steps[other].relations[0].residual, other)
        if not epsilon.is_Symbol or not a.is_Symbol or sense not in (1, -1) or not _from_axis(turned, other, motion):
            continue
        (big,) = wave.args
        height = sense * a * sp.sqrt(1 - epsilon**2) * sp.sin(big)
        yield _Place(r, other, a * (wave - epsilon), height, (leg, steps[other]))


def _from_axis(turned: sp.Expr, phi: sp.Symbol, motion: MotionTrace) -> bool:
    """Is φ counted from the nearest point, but for whole turns?"""
    start = turned.xreplace({phi: sp.S.Zero, **dict.fromkeys(turned.atoms(sp.atan), sp.S.Zero)})
    start = start.xreplace({s: sp.S.Zero for s in start.free_symbols if motion.value(s) == 0})
    return bool((start / (2 * sp.pi)).is_integer)


def _is_alone(leg: RouteStep) -> bool:
    return len(leg.relations) == len(leg.unknowns) == 1 and leg.relations[0].kind == ANOMALY


def _turns(leg: RouteStep, wave: sp.Expr) -> bool:
    """Does it give the direction by tan(E/2)?"""
    halves = leg.relations[0].residual.atoms(sp.tan)
    return any(h.args[0] == wave.args[0] / 2 for h in halves)
