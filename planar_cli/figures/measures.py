"""Lengths, angles and names in a drawing, where the file gives them: what a reader needs to find the scene again.

Each quantity is drawn once: a radius before a distance that equals it, the distance from point to point before one
along an axis.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from planar_cli.figures.angles import angle_from_its_zero, angles_of_coordinates
from planar_cli.figures.drawn import Drawn, size_of, words_of
from planar_cli.figures.shapes import moved
from planar_cli.problem.scene import At, Body, Line, Point, Polar, Problem, Rod, Round, TwoFacts
from planar_cli.problem.shapes import rim_of
from planar_cli.report.blocks import Name, line
from planar_cli.report.marks import Angle, Dimension, Mark, Spot, Tag

RIGHT = math.pi / 2
NEAR = 1e-6
OUT = math.radians(35)
"""In this direction beyond the upright a radius is drawn; that of a hub a quarter turn farther."""


def measure_marks(drawn: Drawn, problem: Problem, tagged: Mapping[str, Spot]) -> Iterator[Mark]:
    """Dimensions, angles and names. `tagged`: the points and particles that are drawn, by their names."""
    yield from (Tag(spot, line(Name(name))) for name, spot in tagged.items())
    told: set[str] = set()
    for mark in _measures(drawn, problem, tagged):
        words = repr(mark.words)
        if words not in told:
            told.add(words)
            yield mark


def _measures(drawn: Drawn, problem: Problem, tagged: Mapping[str, Spot]) -> Iterator[Dimension | Angle]:
    yield from _all_radii(drawn)
    for body in problem.bodies:
        if isinstance(body.shape, Rod):
            yield from _rod(drawn, body, body.shape)
    for point in problem.points:
        if point.name in tagged and isinstance(point.place, Polar):
            yield from _polar(drawn, point, point.place, tagged)
    for surface in problem.surfaces:
        if isinstance(surface.shape, Line) and surface.body is None:
            start = drawn.carried(None, surface.shape.through)
            if start is not None:
                yield from angle_from_its_zero(drawn, start, surface.shape.angle)
    yield from angles_of_coordinates(drawn)
    for point in problem.points:
        if point.name in tagged and isinstance(point.place, At | TwoFacts):
            yield from _coordinates(tagged[point.name], point.place, drawn.moved_by(point.name))


def _polar(drawn: Drawn, point: Point, place: Polar, tagged: Mapping[str, Spot]) -> Iterator[Dimension | Angle]:
    origin, spot = tagged.get(place.origin), tagged[point.name]
    if origin is None or math.dist(origin, spot) < NEAR or any(drawn.moved_by(point.name)):
        return
    words, radii = words_of(place.distance), [r.words for r in _all_radii(drawn)]
    if words in radii:
        # A place on a rim, such as where two bodies touch.
        return
    if words:
        yield Dimension(origin, spot, words)
    yield from angle_from_its_zero(drawn, origin, place.angle)


def _all_radii(drawn: Drawn) -> Iterator[Dimension]:
    for body in drawn.scene.problem.bodies:
        rim = rim_of(body.shape)
        if rim is not None:
            yield from _radii(drawn, body, rim)


def _rod(drawn: Drawn, body: Body, shape: Rod) -> Iterator[Dimension | Angle]:
    """The length of a rod that has it as a key; of one between points these tell it."""
    start, center = drawn.carried(body.name, shape.start), drawn.spot(drawn.scene.bodies[body.name].center)
    if shape.length is None or start is None or center is None:
        return
    if words := words_of(shape.length):
        yield Dimension(start, (2 * center[0] - start[0], 2 * center[1] - start[1]), words)
    if shape.angle is not None:
        yield from angle_from_its_zero(drawn, start, shape.angle)


def _radii(drawn: Drawn, body: Body, rim: Round) -> Iterator[Dimension]:
    center = drawn.carried(body.name, rim.center)
    for i, side in enumerate(s for s in (rim.radius, rim.hub) if s is not None):
        radius, words = drawn.length(side), words_of(side)
        if center is not None and radius and words:
            yield Dimension(center, moved(center, RIGHT + OUT + i * RIGHT, radius), words, side=0)


def _coordinates(spot: Spot, place: At | TwoFacts, moved: Spot) -> Iterator[Dimension]:
    """The distances of a point from the axes, where the file places it by them and it is drawn there."""
    for axis, side in enumerate((place.x, place.y)):
        words = size_of(side, spot[axis]) if side is not None else ()
        if words and abs(spot[axis]) > NEAR and not moved[axis]:
            start = (0.0, spot[1]) if axis == 0 else (spot[0], 0.0)
            yield Dimension(start, spot, words, side=-1 if axis == 0 else 1, level=True)
