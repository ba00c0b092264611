"""The names of bodies in a drawing: each beside its own body, where no other one is near."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.rings import Ring, circle, extent_of, inside, sides
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.problem.scene.scene import Particle, Problem
from planar_cli.report.document.blocks import line
from planar_cli.report.document.marks import Arc, Mark, Polyline, Spot, Tag

CLEAR = 0.08
"""As far from other bodies, in parts of the scene, a name is beside nothing but its own."""
PARTS = (0.75, 0.85, 0.65, 0.25, 0.35, 0.15)
"""Where on a bar its name may stand beside its middle: first on the outer half."""
ROUND = tuple(math.radians(a) for a in (45, 135, 225, 315, 90, 270, 180, 0))


def names_of_bodies(drawn: Drawn, problem: Problem, tagged: Mapping[str, Spot]) -> Iterator[Tag]:
    """The names of bodies that are not called by their points. `tagged`: the names that stand there already."""
    shapes = {n: [*body_marks(drawn, body)] for n, body in drawn.scene.bodies.items()}
    size = extent_of([s for marks in shapes.values() for m in marks for way in _ways(m) for s in way])
    for body in problem.bodies:
        spot = drawn.spot(drawn.scene.bodies[body.name].center)
        by_points = body.name in tagged or any(a + b == body.name for a in tagged for b in tagged)
        pointed = isinstance(body.shape, Particle) and spot in tagged.values()
        if spot is None or by_points or pointed or body.name in problem.hidden:
            continue
        others = [ring for n, marks in shapes.items() if n != body.name for m in marks for ring in _ways(m)]
        yield Tag(_clearest([spot, *_places(shapes[body.name])], others, CLEAR * size), line(_called(body.name)))


def _called(name: str) -> str:
    return name.replace("_", " ")


def _places(marks: Sequence[Mark]) -> Iterator[Spot]:
    """Where on a body its name may stand."""
    for mark in marks:
        match mark:
            case Polyline(places=places, closed=False) if len(places) == 2:
                (x, y), (u, v) = places
                yield from ((x + part * (u - x), y + part * (v - y)) for part in PARTS)
            case Polyline(places=places, closed=True):
                middle = (sum(x for x, _ in places) / len(places), sum(y for _, y in places) / len(places))
                yield from (((x + middle[0]) / 2, (y + middle[1]) / 2) for x, y in places)
            case Arc(center=center, radius=radius):
                yield from (moved(center, angle, part * radius) for part in (0.6, 1.0) for angle in ROUND)


def _ways(mark: Mark) -> Iterator[Ring]:
    """The lines by which a body is drawn; the first place again at the end of a closed one."""
    match mark:
        case Polyline(places=places, closed=closed):
            yield [*places, *(places[:1] if closed else ())]
        case Arc(center=center, radius=radius):
            ring = circle(center, radius)
            yield [*ring, ring[0]]


def _clearest(places: Sequence[Spot], others: Sequence[Ring], clear: float) -> Spot:
    """The first place that is clear of other bodies, or else the one that is farthest from them."""
    told = [(min((_away(p, ring) for ring in others), default=clear), p) for p in places]
    far = max(min(away, clear) for away, _ in told)
    return next(p for away, p in told if away >= far * (1 - 1e-9))


def _away(spot: Spot, ring: Ring) -> float:
    """How far a place is from a line; nothing within the area that it goes round."""
    if len(ring) > 3 and ring[0] == ring[-1] and (inside(ring[:-1], spot) or inside(ring[:0:-1], spot)):
        return 0.0
    return min((_from(spot, a, b) for a, b in list(sides(ring))[:-1]), default=math.inf)


def _from(spot: Spot, a: Spot, b: Spot) -> float:
    """How far a place is from a straight stroke."""
    long = math.dist(a, b)
    if long == 0:
        return math.dist(spot, a)
    part = ((spot[0] - a[0]) * (b[0] - a[0]) + (spot[1] - a[1]) * (b[1] - a[1])) / long**2
    part = min(max(part, 0.0), 1.0)
    return math.dist(spot, (a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])))
