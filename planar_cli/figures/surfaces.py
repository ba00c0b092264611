"""Surfaces as they are drawn: as far as bodies come to them, with hatching on the side where none is."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.scene.curves import carrier_pose, curve_place
from planar_cli.errors import PlanarError
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import between, is_lane, leads
from planar_cli.figures.rings import side_of
from planar_cli.figures.shapes import moved
from planar_cli.figures.smooth import smooth
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Circle, Curve, Line, Surface
from planar_cli.report.document.marks import Arc, Hatched, Mark, Polyline, Spot, spots_of

BEYOND = 0.25
"""A line goes on behind the last place on it by this part of the size of the scene."""
STEPS = 48
REACH = math.radians(65)
"""A circle is drawn so far on either side of what touches it."""
ROUND = math.radians(140)
"""One that goes farther on either side is drawn whole."""
FOOT = 3.0
"""As steep as this, at most, a curve is drawn from where its formula begins."""
NEAR, PAST = 0.02, 0.1
"""What is as near to a line or circle in parts of the size of the scene, or of the radius, touches it; so much of what
is drawn of a line may touch it behind the corner at which it ends.
"""


def surface_marks(
    drawn: Drawn,
    surface: Surface,
    touching: Sequence[Spot],
    shown: Sequence[Sequence[Mark]],
    bodies: Sequence[Spot],
    size: float,
) -> Iterator[Mark]:
    """A surface. `touching`: places on it that matter; `shown`: the bodies that come to it, in all positions that are
    drawn; `bodies`: where they are at first; `size`: that of the scene, m.
    """
    shape = surface.shape
    if isinstance(shape, Line):
        places = _line(drawn, surface, shape, touching, shown, size)
    elif isinstance(shape, Circle):
        places = _circle(drawn, surface, shape, touching, shown)
    else:
        spots = (s for marks in shown for m in marks for s in spots_of(m))
        places = _curve(drawn, surface, shape, (*touching, *spots), size)
    if len(places) < 2:
        return
    if surface.body is not None:
        yield Polyline(tuple(places), "body")
        return
    if is_lane(drawn.scene.problem, surface.name):
        yield Polyline(tuple(places), "lane")
        return
    free = side_of(places, bodies)
    if abs(free) < NEAR * size:
        # What stands on it as a point is on its upper side.
        free = places[-1][0] - places[0][0]
    yield Hatched(tuple(places if free >= 0 else places[::-1]))


def _line(
    drawn: Drawn,
    surface: Surface,
    shape: Line,
    touching: Sequence[Spot],
    shown: Sequence[Sequence[Mark]],
    size: float,
) -> list[Spot]:
    start = drawn.carried(surface.body, shape.through)
    along = drawn.angle(drawn.scene.surface_direction(surface))
    if start is None or along is None:
        return []
    seen = [_seen(p, start, along) for p in touching]
    contacts = [ahead for ahead, aside in seen if abs(aside) <= NEAR * size]
    ways = list(contacts)
    for marks in shown:
        foot = _foot(marks, start, along, NEAR * size)
        contacts += foot[:1]
        ways += foot[1:]
    low, high = min(ways or [0.0]), max(ways or [0.0])
    ends = [low - BEYOND * size, high + BEYOND * size]
    for corner in _corners(drawn, surface, start, along):
        # A line that meets another one (an incline its floor) ends there, where nothing touches it beyond.
        slack = PAST * (high - low)
        if ends[0] < corner and all(c > corner - slack for c in contacts) and any(c > corner + slack for c in contacts):
            ends[0] = corner
        if ends[1] > corner and all(c < corner + slack for c in contacts) and any(c < corner - slack for c in contacts):
            ends[1] = corner
    return [moved(start, along, way) for way in ends]


def _foot(marks: Sequence[Mark], start: Spot, along: float, near: float) -> list[float]:
    """Where on a line a body touches it, and as far as where it reaches; nothing of one that is not at the line."""
    rounds = [m for m in marks if isinstance(m, Arc)]
    for rim in rounds:
        ahead, aside = _seen(rim.center, start, along)
        if abs(abs(aside) - rim.radius) <= near + rim.radius * NEAR:
            return [ahead, ahead - rim.radius, ahead + rim.radius]
    spots = [_seen(s, start, along) for m in marks if not isinstance(m, Arc) for s in spots_of(m)]
    closest = min(spots, key=lambda s: abs(s[1]), default=None)
    if closest is None or abs(closest[1]) > near:
        return []
    return [closest[0], *(ahead for ahead, _ in spots)]


def _corners(drawn: Drawn, surface: Surface, start: Spot, along: float) -> Iterator[float]:
    """Where on a fixed line others cross it."""
    for other in drawn.scene.problem.surfaces if surface.body is None else ():
        if other is surface or other.body is not None or not isinstance(other.shape, Line):
            continue
        through, way = drawn.carried(None, other.shape.through), drawn.angle(drawn.scene.surface_direction(other))
        if through is None or way is None or abs(math.sin(way - along)) < NEAR:
            continue
        ahead, aside = _seen(through, start, along)
        yield ahead - aside / math.tan(way - along)


def _circle(
    drawn: Drawn, surface: Surface, shape: Circle, touching: Sequence[Spot], shown: Sequence[Sequence[Mark]]
) -> list[Spot]:
    center, radius = drawn.carried(surface.body, shape.center), drawn.length(shape.radius)
    if center is None or not radius:
        return []
    near = [p for p in touching if abs(math.dist(p, center) - radius) < radius / 10]
    for marks in shown:
        near += [m.center for m in marks if isinstance(m, Arc) and _touches(m, center, radius)]
        spots = (s for m in marks if not isinstance(m, Arc) for s in spots_of(m))
        near += [s for s in spots if abs(math.dist(s, center) - radius) < radius * NEAR]
    angles = [math.atan2(p[1] - center[1], p[0] - center[0]) for p in near]
    middle = math.atan2(sum(map(math.sin, angles)), sum(map(math.cos, angles))) if angles else math.pi / 2
    seen = [math.remainder(a - middle, 2 * math.pi) for a in angles] or [0.0]
    low, high = min(seen), max(seen)
    if high - low < NEAR or not _is_left(drawn, surface):
        high = max(-low, high) + REACH
        high = math.pi if high > ROUND else high
        low = -high
    return [moved(center, middle + low + (high - low) * i / STEPS, radius) for i in range(STEPS + 1)]


def _is_left(drawn: Drawn, surface: Surface) -> bool:
    """Does a track hold what runs along it only from one state to another, as far as which it goes?"""
    own = [j for j in drawn.scene.problem.joints if surface.name in between(j)]
    return bool(own) and all(leads(j) and j.during is not None for j in own)


def _touches(rim: Arc, center: Spot, radius: float) -> bool:
    apart = math.dist(rim.center, center)
    return min(abs(apart - abs(radius - rim.radius)), abs(apart - radius - rim.radius)) < radius * NEAR


def _curve(drawn: Drawn, surface: Surface, shape: Curve, touching: Sequence[Spot], size: float) -> list[Spot]:
    x, place = curve_place(drawn.scene, shape)
    pose = carrier_pose(drawn.scene, surface)
    origin, turn = drawn.spot(pose.point(Vec(sp.S.Zero, sp.S.Zero))), drawn.number(pose.turn) or 0.0
    if origin is None:
        return []
    seen = [_seen(p, origin, turn) for p in touching] or [(0.0, 0.0)]
    if shape.kind == "y":
        ways = [p[0] for p in seen]
        foot = _at(drawn, place, x, 0.0)
        if foot is not None and abs(foot[1] - seen[0][1]) < FOOT * abs(ways[0]) and len(set(ways)) == 1:
            # Of one place the curve is seen from where its formula begins.
            ways.append(0.0)
        beyond = BEYOND * max(size, max(ways) - min(ways))
        low, high = min(ways) - beyond, max(ways) + beyond
    else:
        ways = [math.atan2(p[1], p[0]) for p in seen]
        low, high = min(ways) - REACH, max(ways) + REACH
        if _is_closed(drawn, place, x):
            low, high = -math.pi, math.pi
    found = smooth(lambda share: _at(drawn, place, x, low + (high - low) * share), STEPS)
    return [moved(origin, turn, *spot) for spot in found]


def _is_closed(drawn: Drawn, place: Vec, x: sp.Symbol) -> bool:
    """Does a curve come back to where it began after one turn, with a place everywhere?"""
    spots = [_at(drawn, place, x, math.pi * i / 6) for i in range(-6, 7)]
    first, last = spots[0], spots[-1]
    return None not in spots and first is not None and last is not None and math.dist(first, last) < 1e-6


def _at(drawn: Drawn, place: Vec, x: sp.Symbol, at: float) -> Spot | None:
    """A place of a curve in its own axes; None where it has none (a root of a negative number)."""
    here = {x: sp.Rational(f"{at:.9f}")}
    try:
        return drawn.spot(Vec(place.x.subs(here), place.y.subs(here)))
    except PlanarError:
        return None


def _seen(p: Spot, origin: Spot, turn: float) -> Spot:
    return moved((0.0, 0.0), -turn, p[0] - origin[0], p[1] - origin[1])
