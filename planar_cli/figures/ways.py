"""Ways in their shape where they are not drawn to scale, or where no coordinate tells them: that of what comes again
too far away, that of what flies in a scene of letters, that of a bob on a cord or rod.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.rings import extent_of
from planar_cli.figures.shapes import moved
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Particle
from planar_cli.problem.scene.sketches import Bar, Cord
from planar_cli.report.document.marks import Spot

TURNED, NEAR = 0.1, 1e-6
"""A way is drawn smaller as long as it would be turned by less, rad; what differs by less, in parts, is alike."""
STEPS = 48
FLAT, BENT = 0.04, 0.1
"""A flight that is bent by less, in parts of the scene, looks straight; so much it is bent in a scene of letters."""


def in_shape(way: Sequence[Spot], ends: tuple[Spot, Spot]) -> tuple[Spot, ...]:
    """A way drawn smaller, between two places; none: it would lie there otherwise than it does."""
    if len(way) < 3:
        return ()
    start, end = complex(*way[0]), complex(*way[-1])
    first, last = complex(*ends[0]), complex(*ends[1])
    if abs(end - start) == 0 or abs(last - first) == 0:
        return ()
    scale = (last - first) / (end - start)
    if abs(math.atan2(scale.imag, scale.real)) > TURNED:
        return ()
    places = [first + scale * (complex(*p) - start) for p in way]
    return tuple((p.real, p.imag) for p in places)


def round_a_tie(there: Drawn, name: str, ends: tuple[Spot, Spot], before: Sequence[Spot]) -> tuple[Spot, ...]:
    """The circle on which a cord or rod from a fixed point leads a particle, from place to place; none: none does.
    `there`: a position in which it holds; `before`: the way on which it came, which tells in which sense it goes on.
    """
    body = there.body(name)
    at = there.spot(body.center) if body is not None and isinstance(body.shape, Particle) else None
    for joint in there.scene.problem.joints if at is not None else ():
        for sketch in sketch_of(there, joint):
            center = _fixed_end(there, sketch, at)
            if center is None:
                continue
            radii, angles = [math.dist(center, e) for e in ends], [_toward(center, e) for e in ends]
            if abs(radii[0] - radii[1]) > NEAR * max(radii) or radii[0] == 0:
                continue
            turned = (angles[1] - angles[0]) % (2 * math.pi)
            if not _is_ahead(center, ends[0], before, turned):
                turned -= 2 * math.pi
            return tuple(moved(center, angles[0] + turned * i / STEPS, radii[0]) for i in range(STEPS + 1))
    return ()


def _fixed_end(there: Drawn, sketch: object, at: Spot | None) -> Spot | None:
    """The fixed end of a cord or rod whose other end is at a place."""
    match sketch:
        case Bar(start=start, end=end, fixed=fixed):
            ends: tuple[Vec, Vec] = (start, end)
        case Cord(stops=(first, last), fixed=fixed):
            ends = (first.center, last.center)
        case _:
            return None
    one, other = (there.spot(e) for e in ends)
    if one is None or other is None or at is None or fixed[0] == fixed[1]:
        return None
    center, free = (one, other) if fixed[0] else (other, one)
    return center if math.dist(free, at) <= NEAR * math.dist(center, free) else None


def _is_ahead(center: Spot, start: Spot, before: Sequence[Spot], turned: float) -> bool:
    """Does a particle go round counterclockwise? As it came, or else down, or the shorter way."""
    x, y = start[0] - center[0], start[1] - center[1]
    if len(before) > 1 and math.dist(before[-1], start) < NEAR * math.hypot(x, y):
        (u, v), (p, q) = before[-2:]
        return x * (q - v) - y * (p - u) > 0
    if abs(turned - math.pi) < NEAR:
        return x < 0
    return turned < math.pi


def _toward(center: Spot, spot: Spot) -> float:
    return math.atan2(spot[1] - center[1], spot[0] - center[0])


def lower_by(ways: Sequence[Sequence[Spot]], spots: Sequence[Spot]) -> Spot:
    """By how much the end of some flights is drawn lower, so that they are seen to be bent: all alike, as if they took
    longer, where the letters of a scene leave open how long. (0, 0): they need not, or are bent otherwise. `spots`:
    the places of the scene.
    """
    bends = [_bend(way) for way in ways]
    if not bends or any(math.dist(b, bends[0]) > 1e-3 * math.hypot(*bends[0]) for b in bends):
        return 0.0, 0.0
    bend, size = math.hypot(*bends[0]), extent_of(spots)
    if not 0 < bend < FLAT * size:
        return 0.0, 0.0
    more = 4 * (BENT * size / bend - 1)
    return -more * bends[0][0], -more * bends[0][1]


def _bend(way: Sequence[Spot]) -> Spot:
    """How far the middle of a way is from that of its ends."""
    (x, y), (a, b), (u, v) = way[0], way[len(way) // 2], way[-1]
    return a - (x + u) / 2, b - (y + v) / 2


def lowered(way: Sequence[Spot], by: Spot) -> tuple[Spot, ...]:
    """A flight, told at equal steps of time, whose end is so far from where it is."""
    last = max(len(way) - 1, 1)
    return tuple((x + by[0] * (i / last) ** 2, y + by[1] * (i / last) ** 2) for i, (x, y) in enumerate(way))
