"""The ground on which a throw ends, or from which its heights count: level, or a slope that a relation between the
coordinates of a state tells.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from planar_cli.figures.angles import angle_from_its_zero
from planar_cli.figures.positions import Later
from planar_cli.figures.rings import extent_of
from planar_cli.problem.language.expression import Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Line, Particle, Problem
from planar_cli.report.document.marks import Angle, Hatched, Mark, Spot

AXES = ("x", "y")
NEAR = 1e-6
BEYOND = 0.06
"""The ground goes on beyond what stands on it by this part of its length."""
WIDE = 46.0
"""The radius of an arc under a slope, px: beyond the hatching."""


def landing_marks(where: Mapping[str, Later], problem: Problem) -> Iterator[Mark]:
    """`where`: the positions that are drawn to scale, by their states."""
    flies = all(isinstance(b.shape, Particle) for b in problem.bodies)
    ends = [*where][-1] if where else ""
    left = bool(problem.joints) and all(j.during is not None and j.during[1] != ends for j in problem.joints)
    held = any(not j.strikes for j in problem.joints) or not _are_walls(where, problem)
    if problem.plane != "vertical" or not flies or (held and not left):
        return
    spots = [s for p in where.values() for s in p.spots.values()]
    for state in problem.states:
        for relation in state.relations if state.name in where else ():
            marks = list(_slope(where[state.name], relation, extent_of(spots)))
            if marks:
                yield from marks
                return
    if _counts_from_level(where, problem) and spots and min(y for _, y in spots) > -NEAR:
        low, high = min(x for x, _ in spots), max(x for x, _ in spots)
        more = BEYOND * max(high - low, *(y for _, y in spots))
        yield Hatched(((low - more, 0.0), (high + more, 0.0)))


def _are_walls(where: Mapping[str, Later], problem: Problem) -> bool:
    """Are all surfaces upright? From a wall a ball comes back, but it lands on none."""
    scene = next(iter(where.values())).there.scene if where else None
    ways = [scene.surface_direction(s) if isinstance(s.shape, Line) else None for s in problem.surfaces if scene]
    return all(way is not None and way.x == 0 for way in ways)


def _counts_from_level(where: Mapping[str, Later], problem: Problem) -> bool:
    """Does something come to y = 0, or does it fly from above and do heights count from there?"""
    told = [r for s in problem.states if s.name in where for r in s.relations if isinstance(r, Relation)]
    heights = [r for r in told if coordinate(r.left)[0] == 1 and coordinate(r.left)[1]]
    if any(isinstance(r.right, Number) and r.right.value == 0 for r in heights):
        return True
    asked = [f.found.what for f in problem.find if isinstance(f.found.what, Quantity)]
    counted = bool(heights) or any(coordinate(a)[0] == 1 and coordinate(a)[1] for a in asked)
    begin = next(iter(where.values()), None)
    return counted and begin is not None and all(y > NEAR for _, y in begin.spots.values())


def _slope(place: Later, relation: object, size: float) -> Iterator[Mark]:
    """The slanting line through a fixed point on which a relation puts a body, with its angle."""
    if not isinstance(relation, Relation) or relation.operator != "=" or not isinstance(relation.left, Quantity):
        return
    left, right = relation.left, relation.right
    on_it = isinstance(right, Number) and right.value == 0
    if on_it and left.word == "r" and [p.kind for p in left.parts] == ["across"]:
        direction = left.parts[0].direction
        start = spot_of(place, left.things[1]) if len(left.things) == 2 else (0.0, 0.0)
        angle = place.there.length(direction) if isinstance(direction, Side) else None
        end = spot_of(place, left.things[0])
        if start is not None and end is not None and angle is not None and isinstance(direction, Side):
            yield _hatched(start, end, size)
            yield from (_arc(a) for a in angle_from_its_zero(place.there, start, direction))
        return
    axis, name, _ = coordinate(left)
    beside = {(q.word, *q.things) for q in walk(right) if isinstance(q, Quantity)}
    end = spot_of(place, name) if name else None
    if axis == 1 and beside == {("x", name)} and end is not None and min(map(abs, end)) > NEAR:
        yield _hatched((0.0, 0.0), end, size)


def _arc(angle: Angle) -> Angle:
    return Angle(angle.vertex, angle.start, angle.sweep, angle.words, WIDE)


def _hatched(start: Spot, end: Spot, size: float) -> Hatched:
    """From a little before one place to a little beyond another, from left to right."""
    reach = math.dist(start, end)
    more = BEYOND * size / reach if reach else 0.0
    way = (end[0] - start[0], end[1] - start[1])
    ends = [(start[0] + part * way[0], start[1] + part * way[1]) for part in (-more, 1 + more)]
    return Hatched(tuple(sorted(ends)))


def coordinate(side: Side | None) -> tuple[int, str, str | None]:
    """x(ball) @ top: the axis, the body and the state; no name: it is something else."""
    if not isinstance(side, Quantity) or side.word not in AXES or side.parts or len(side.things) != 1:
        return 0, "", None
    return AXES.index(side.word), side.things[0], side.at if isinstance(side.at, str) else None


def spot_of(place: Later, name: str) -> Spot | None:
    """Where a body, or a point of one, is in a position; None: nothing tells it there."""
    return place.spots.get(name) if name in place.spots or place.first is not None else place.there.named(name)
