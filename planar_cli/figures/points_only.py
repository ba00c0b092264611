"""A file of points alone: lines where it tells distances between them, and the vectors that are asked."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import combinations

from planar_cli.figures.drawn import Drawn
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Quantity, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import At, Point, Polar, Towards, TwoFacts
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Mark, Polyline, Span, Spot

NEAR = 1e-9


def lines_of_points(drawn: Drawn, tagged: Mapping[str, Spot]) -> Iterator[Mark]:
    """Between points that are as far apart as the file tells in letters, or of which it places one from the other; and
    position vectors from one point to another.
    """
    problem = drawn.scene.problem
    if problem.bodies or problem.surfaces or problem.coordinates or problem.states:
        return
    told = [(p.name, *one) for p in problem.points for one in _distances(p)]
    lettered = {s: _is_lettered(s) for p in problem.points for s in _lengths(p)}
    letters = [length for s, known in lettered.items() if known and (length := drawn.length(s))]
    pairs = [{name, origin} for name, origin, _ in told]
    for a, b in combinations(tagged, 2):
        reach = math.dist(tagged[a], tagged[b])
        if {a, b} in pairs or any(abs(reach - abs(length)) < NEAR for length in letters):
            yield Polyline((tagged[a], tagged[b]), "thin")
    for find in problem.find:
        asked = find.found.what
        if isinstance(asked, Quantity) and asked.word == "r" and len(asked.things) == 2 and not asked.parts:
            ends = [tagged.get(name) for name in reversed(asked.things)]
            if ends[0] is not None and ends[1] is not None and math.dist(ends[0], ends[1]) > NEAR:
                yield Span(ends[0], ends[1], "velocity", line(Name(f"r_{'/'.join(asked.things)}")))


def _distances(point: Point) -> Iterator[tuple[str, Side]]:
    """From which other points a point is placed, and how far."""
    match point.place:
        case Polar(origin=origin, distance=distance) | Towards(origin=origin, distance=distance):
            yield origin, distance
        case TwoFacts(distances=distances):
            yield from distances


def _lengths(point: Point) -> Iterator[Side]:
    """All lengths by which a point is placed."""
    yield from (distance for _, distance in _distances(point))
    if isinstance(point.place, At):
        yield from (s for s in (point.place.x, point.place.y) if s is not None)


def _is_lettered(side: Side) -> bool:
    return any(isinstance(node, Letter) for node in walk(side))
