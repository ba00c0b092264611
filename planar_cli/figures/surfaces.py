"""Surfaces as they are drawn: as far as bodies come to them, with hatching on the side where none is."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.curves import carrier_pose, curve_place
from planar_cli.errors import PlanarError
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.shapes import moved
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import Circle, Curve, Line, Surface
from planar_cli.report.marks import Hatched, Mark, Polyline, Spot

BEYOND = 0.25
"""A line goes on behind the last place on it by this part of the size of the scene."""
STEPS = 48
REACH = math.radians(65)
"""A circle is drawn so far on either side of what touches it."""


def surface_marks(
    drawn: Drawn, surface: Surface, touching: Sequence[Spot], bodies: Sequence[Spot], size: float
) -> Iterator[Mark]:
    """A surface. `touching`: places on it that matter; `bodies`: where bodies are; `size`: that of the scene, m."""
    shape = surface.shape
    if isinstance(shape, Line):
        places = _line(drawn, surface, shape, touching, size)
    elif isinstance(shape, Circle):
        places = _circle(drawn, surface, shape, touching)
    else:
        places = _curve(drawn, surface, shape, touching, size)
    if len(places) < 2:
        return
    if surface.body is not None:
        yield Polyline(tuple(places), "body")
        return
    free = _side(places, bodies)
    yield Hatched(tuple(places if free >= 0 else places[::-1]))


def _line(drawn: Drawn, surface: Surface, shape: Line, touching: Sequence[Spot], size: float) -> list[Spot]:
    start = drawn.carried(surface.body, shape.through)
    along = drawn.angle(drawn.scene.surface_direction(surface))
    if start is None or along is None:
        return []
    cos, sin = math.cos(along), math.sin(along)
    ways = [(p[0] - start[0]) * cos + (p[1] - start[1]) * sin for p in touching] or [0.0]
    low, high = min(ways), max(ways)
    # A line that others end at (an incline on its floor) is not drawn through the ground.
    return [moved(start, along, low - BEYOND * size), moved(start, along, high + BEYOND * size)]


def _circle(drawn: Drawn, surface: Surface, shape: Circle, touching: Sequence[Spot]) -> list[Spot]:
    center, radius = drawn.carried(surface.body, shape.center), drawn.length(shape.radius)
    if center is None or not radius:
        return []
    near = [p for p in touching if abs(math.dist(p, center) - radius) < radius / 10]
    angles = [math.atan2(p[1] - center[1], p[0] - center[0]) for p in near]
    middle = math.atan2(sum(map(math.sin, angles)), sum(map(math.cos, angles))) if angles else math.pi / 2
    off = max((abs(math.remainder(a - middle, 2 * math.pi)) for a in angles), default=0.0)
    reach = min(off + REACH, math.pi)
    return [moved(center, middle + reach * (2 * i / STEPS - 1), radius) for i in range(STEPS + 1)]


def _curve(drawn: Drawn, surface: Surface, shape: Curve, touching: Sequence[Spot], size: float) -> list[Spot]:
    x, place = curve_place(drawn.scene, shape)
    pose = carrier_pose(drawn.scene, surface)
    origin, turn = drawn.spot(pose.point(Vec(sp.S.Zero, sp.S.Zero))), drawn.number(pose.turn) or 0.0
    if origin is None:
        return []
    seen = [_seen(p, origin, turn) for p in touching] or [(0.0, 0.0)]
    if shape.kind == "y":
        ways = [p[0] for p in seen]
        low, high = min(ways) - BEYOND * size, max(ways) + BEYOND * size
    else:
        ways = [math.atan2(p[1], p[0]) for p in seen]
        low, high = min(ways) - REACH, max(ways) + REACH
    found = []
    for i in range(STEPS + 1):
        at = low + (high - low) * i / STEPS
        spot = _at(drawn, place, x, at)
        if spot is not None:
            found.append(moved(origin, turn, *spot))
    return found


def _at(drawn: Drawn, place: Vec, x: sp.Symbol, at: float) -> Spot | None:
    """A place of a curve in its own axes; None where it has none (a root of a negative number)."""
    here = {x: sp.Rational(f"{at:.9f}")}
    try:
        return drawn.spot(Vec(place.x.subs(here), place.y.subs(here)))
    except PlanarError:
        return None


def _seen(p: Spot, origin: Spot, turn: float) -> Spot:
    return moved((0.0, 0.0), -turn, p[0] - origin[0], p[1] - origin[1])


def _side(places: Sequence[Spot], bodies: Sequence[Spot]) -> float:
    """Positive: bodies lie to the left of the way along these places, which is then the free side."""
    total = 0.0
    for body in bodies:
        i = min(range(len(places) - 1), key=lambda k: math.dist(places[k], body) + math.dist(places[k + 1], body))
        a, b = places[i], places[i + 1]
        cross = (b[0] - a[0]) * (body[1] - a[1]) - (b[1] - a[1]) * (body[0] - a[0])
        total += cross / max(math.dist(a, b), 1e-300)
    return total
