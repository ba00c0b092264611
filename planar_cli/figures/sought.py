"""Letters of the file that no place is given by alone, such as those of `l*cos(beta)`: the length between two points
that is l, and the angle that is β.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import combinations

import sympy as sp

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import between
from planar_cli.figures.rings import way_of
from planar_cli.problem.language.expression import Function, Name, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, At, Point, Rod, TwoFacts
from planar_cli.records import record
from planar_cli.report.document.blocks import Name as Letter
from planar_cli.report.document.blocks import line
from planar_cli.report.document.marks import Angle, Dimension, Spot

NEAR = 1e-9
RIGHT = math.pi / 2


@record
class _Segment:
    """From point to point: as a vector, and where it is drawn."""

    way: Vec
    start: Spot
    end: Spot


def in_waves(point: Point) -> frozenset[str]:
    """The letters of coordinates that are products with sines and cosines: l and beta of l*cos(beta)."""
    place = point.place
    sides = (place.x, place.y) if isinstance(place, At | TwoFacts) else ()
    waves = (s for s in sides if s is not None and any(isinstance(node, Function) for node in walk(s)))
    return frozenset(node.name for s in waves for node in walk(s) if isinstance(node, Name))


def sought(drawn: Drawn, tagged: Mapping[str, Spot], letters: Mapping[str, Side]) -> Iterator[Dimension | Angle]:
    """Lengths and angles that are one of some letters, given as the file would write them."""
    values = {name: value for name, side in letters.items() if (value := drawn.length(side)) is not None}
    symbols = {name: drawn.scene.value(letters[name]) for name in values}
    left = set(values)
    for segment in _segments(drawn, tagged):
        reach = math.dist(segment.start, segment.end)
        for name in sorted(left):
            if abs(reach - values[name]) < NEAR and drawn.scene.length(segment.way) == symbols[name]:
                left.discard(name)
                yield Dimension(segment.start, segment.end, line(Letter(name)))
            elif (found := _angle(drawn, segment, symbols[name], values[name])) is not None:
                left.discard(name)
                yield Angle(segment.start, *found, line(Letter(name)))
        if not left:
            return


def _segments(drawn: Drawn, tagged: Mapping[str, Spot]) -> Iterator[_Segment]:
    """Rods and links first, each from its end on the ground; then what lies between any two points."""
    scene = drawn.scene
    rods = [(b.shape.start, b.shape.end) for b in scene.problem.bodies if isinstance(b.shape, Rod) and b.shape.end]
    ties = [tuple(between(j)) for j in scene.problem.joints]
    pairs = [*rods, *ties, *combinations(tagged, 2)]
    for a, b in (pair for pair in pairs if len(pair) == 2):
        if a in tagged and b in tagged and math.dist(tagged[a], tagged[b]) > NEAR:
            start, end = (b, a) if scene.owner(b) == GROUND != scene.owner(a) else (a, b)
            yield _Segment(scene.point(end) - scene.point(start), tagged[start], tagged[end])


def _angle(drawn: Drawn, segment: _Segment, letter: sp.Expr, value: float) -> tuple[float, float] | None:
    """From which axis, and by how much, a segment is turned, where that is the letter."""
    way = way_of(segment.start, segment.end)
    for quarter in range(4):
        zero = quarter * RIGHT
        sweep = math.remainder(way - zero, 2 * math.pi)
        if abs(abs(sweep) - value) > NEAR or not 0 < value < RIGHT:
            continue
        length = drawn.scene.length(segment.way)
        along = segment.way.y if quarter % 2 else segment.way.x
        sense = -1 if quarter > 1 else 1
        if sp.expand(along - sense * length * sp.cos(letter)) == 0:
            return zero, sweep
    return None
