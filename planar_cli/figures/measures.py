"""Lengths, angles and names in a drawing, where the file gives them: what a reader needs to find the scene again.

Each quantity is drawn once: a radius before a distance that equals it, the distance from point to point before one
along an axis.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from planar_cli.figures.angles import angle_from_its_zero, angles_of_coordinates
from planar_cli.figures.apart_in_text import apart_in_text
from planar_cli.figures.axes_of_turning import radius_marks
from planar_cli.figures.drawn import Drawn, brief, words_of
from planar_cli.figures.partners import between
from planar_cli.figures.rings import across, way_of
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.figures.slopes import slope_angles
from planar_cli.figures.sought import in_waves, sought
from planar_cli.figures.stated import is_stated
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import (
    At,
    Body,
    Particle,
    Plate,
    Point,
    Polar,
    Problem,
    Rod,
    Round,
    Towards,
    TwoFacts,
)
from planar_cli.problem.scene.shapes import rim_of
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.marks import Angle, Dimension, Mark, Polyline, Spot, Tag

RIGHT = math.pi / 2
NEAR = 1e-6
BESIDE = 0.01
"""The middle of a scene that is so near to the line of a dimension, in parts of its length, lies on neither side."""
OUT = math.radians(35)
"""In this direction beyond the upright a radius is drawn; that of a hub a quarter turn farther."""


def measure_marks(
    drawn: Drawn, problem: Problem, tagged: Mapping[str, Spot], edges: Mapping[str, Sequence[Spot]]
) -> Iterator[Mark]:
    """Dimensions, angles and names. `tagged`: the points and particles that are drawn, by their names; `edges`: the
    fixed lines, as far as they are drawn, by their names.
    """
    yield from (Tag(spot, line(Name(name))) for name, spot in tagged.items())
    told: set[str] = set()
    middle = _middle([*tagged.values()])
    for mark in _measures(drawn, problem, tagged, edges):
        yield from _once(_outside(mark, middle), told)
    letters = {s.name: Letter(s.name, None, s.mark) for s in (*problem.given, *problem.symbols, *problem.coordinates)}
    asked = {name: letter for name, letter in letters.items() if repr(words_of(letter)) not in told}
    for mark in sought(drawn, tagged, asked):
        yield from _once(_outside(mark, middle), told)
    for point in problem.points:
        # l cos β is seen where l and β are.
        waves = [letters[name] for name in in_waves(point) if name in letters]
        seen = waves and all(repr(words_of(letter)) in told for letter in waves)
        if point.name in tagged and isinstance(point.place, At | TwoFacts) and not seen:
            for mark in _coordinates(drawn, tagged[point.name], point.place, drawn.moved_by(point.name)):
                yield from _once(mark, told)
    for body in problem.bodies:
        # A particle may have its place without a point.
        spot, place = tagged.get(body.name), body.shape.place if isinstance(body.shape, Particle) else None
        if isinstance(place, At) and spot is not None and spot == drawn.center(body.name):
            for mark in _coordinates(drawn, spot, place, (0.0, 0.0)):
                yield from _once(mark, told)
    sizes = (m for b in problem.bodies if isinstance(b.shape, Plate) for m in _plate(drawn, b, b.shape))
    for mark in (*apart_in_text(drawn, tagged), *sizes):
        yield from _once(_outside(mark, middle), told)


def _middle(spots: Sequence[Spot]) -> Spot:
    count = len(spots) or 1
    return sum(x for x, _ in spots) / count, sum(y for _, y in spots) / count


def _outside(mark: Dimension | Angle, middle: Spot) -> Dimension | Angle:
    """A dimension beside its way on the side where less of the scene is."""
    if not isinstance(mark, Dimension) or mark.side == 0 or mark.level:
        return mark
    reach = math.dist(mark.start, mark.end)
    lies = across(mark.start, way_of(mark.start, mark.end), middle)
    return replace(mark, side=-1) if lies > BESIDE * reach else mark


def _once(mark: Dimension | Angle, told: set[str]) -> Iterator[Mark]:
    """A mark whose words nothing has told yet; along x and along y the same may be told."""
    words = repr(mark.words)
    level = isinstance(mark, Dimension) and mark.level
    key = f"{words} {mark.side}" if level and isinstance(mark, Dimension) else words
    if words not in told and key not in told:
        told.add(key)
        yield mark


def _measures(
    drawn: Drawn, problem: Problem, tagged: Mapping[str, Spot], edges: Mapping[str, Sequence[Spot]]
) -> Iterator[Dimension | Angle]:
    yield from _all_radii(drawn, tagged)
    for body in problem.bodies:
        if isinstance(body.shape, Rod):
            yield from _rod(drawn, body, body.shape)
    yield from slope_angles(drawn, edges)
    for point in problem.points:
        if point.name in tagged and not any(drawn.moved_by(point.name)):
            yield from _placed(drawn, point, tagged)
    yield from _links(drawn, tagged)
    yield from radius_marks(drawn)
    yield from angles_of_coordinates(drawn)


def _placed(drawn: Drawn, point: Point, tagged: Mapping[str, Spot]) -> Iterator[Dimension | Angle]:
    """What the file gives of a point from other points."""
    spot = tagged[point.name]
    match point.place:
        case Polar() as place:
            yield from _polar(drawn, spot, place, tagged)
        case Towards(origin=origin, distance=distance):
            yield from _apart(drawn, tagged.get(origin), spot, distance)
        case TwoFacts(lines=lines, distances=distances):
            for name, distance in distances:
                yield from _apart(drawn, tagged.get(name), spot, distance)
            for name, angle in lines:
                if name in tagged:
                    yield from angle_from_its_zero(drawn, tagged[name], angle)


def _polar(drawn: Drawn, spot: Spot, place: Polar, tagged: Mapping[str, Spot]) -> Iterator[Dimension | Angle]:
    origin = tagged.get(place.origin)
    if origin is None or math.dist(origin, spot) < NEAR:
        return
    words = _given(drawn, place.distance, drawn.length(place.distance))
    on_a_rim = words in [r.words for r in _all_radii(drawn, {})] or _is_across_a_wheel(drawn, origin, spot)
    if words and not on_a_rim:
        yield Dimension(origin, spot, words)
    if not on_a_rim or _is_lettered(place.angle):
        # Of a place on a rim a number tells no more than where two bodies touch.
        yield from angle_from_its_zero(drawn, origin, place.angle)


def _is_across_a_wheel(drawn: Drawn, one: Spot, other: Spot) -> bool:
    """Do two places lie on a line through the middle of a wheel, each there, on its rim or on its hub? Its radii tell
    how far apart they are: R + r, 2 R.
    """
    for body in drawn.scene.problem.bodies:
        rim = rim_of(body.shape)
        center = drawn.carried(body.name, rim.center) if rim is not None else None
        if rim is None or center is None:
            continue
        radii = [
            r for side in (rim.radius, rim.hub) if side is not None and words_of(side) and (r := drawn.length(side))
        ]
        ends = [math.dist(center, s) for s in (one, other)]
        near = NEAR * max((1.0, *radii))
        apart = math.dist(one, other)
        in_line = min(abs(apart - abs(ends[0] - ends[1])), abs(apart - sum(ends))) < near
        if radii and in_line and all(min(abs(end - r) for r in (0.0, *radii)) < near for end in ends):
            return True
    return False


def _apart(drawn: Drawn, origin: Spot | None, spot: Spot, distance: Side) -> Iterator[Dimension]:
    words = _given(drawn, distance, drawn.length(distance))
    if origin is not None and words and math.dist(origin, spot) > NEAR and not _is_across_a_wheel(drawn, origin, spot):
        yield Dimension(origin, spot, words)


def _links(drawn: Drawn, tagged: Mapping[str, Spot]) -> Iterator[Dimension]:
    """The lengths of light rods."""
    for joint in drawn.scene.problem.joints:
        length, ends = getattr(joint, "length", None), [tagged.get(name) for name in between(joint)]
        if isinstance(length, Side) and len(ends) == 2 and ends[1] is not None:
            yield from _apart(drawn, ends[0], ends[1], length)


def _is_lettered(side: Side) -> bool:
    return any(isinstance(node, Letter) for node in walk(side))


def _all_radii(drawn: Drawn, tagged: Mapping[str, Spot]) -> Iterator[Dimension]:
    for body in drawn.scene.problem.bodies:
        rim = rim_of(body.shape)
        if rim is not None:
            yield from _radii(drawn, body, rim, tagged)


def _rod(drawn: Drawn, body: Body, shape: Rod) -> Iterator[Dimension | Angle]:
    """The length of a rod that has it as a key; of one between points these tell it."""
    start, center = drawn.carried(body.name, shape.start), drawn.spot(drawn.scene.bodies[body.name].center)
    if shape.length is None or start is None or center is None:
        return
    if words := words_of(shape.length):
        yield Dimension(start, (2 * center[0] - start[0], 2 * center[1] - start[1]), words)
    if shape.angle is not None:
        yield from angle_from_its_zero(drawn, start, shape.angle)


def _plate(drawn: Drawn, body: Body, shape: Plate) -> Iterator[Dimension]:
    """Width and height along its lower and left sides, of one that is level beside all else."""
    (ring,) = [m.places for m in body_marks(drawn, drawn.scene.bodies[body.name]) if isinstance(m, Polyline)] or [()]
    for side, ends in ((shape.width, ring[:2]), (shape.height, (*ring[3:], *ring[:1]))):
        if len(ends) == 2 and (words := _given(drawn, side, drawn.length(side))):
            level = min(abs(ends[0][i] - ends[1][i]) for i in (0, 1)) < NEAR
            yield Dimension(ends[0], ends[1], words, -1 if side is shape.width else 1 if level else -1, level)


def _radii(drawn: Drawn, body: Body, rim: Round, tagged: Mapping[str, Spot]) -> Iterator[Dimension]:
    center = drawn.carried(body.name, rim.center)
    ways = [way_of(center, tagged[name]) for name in _seen_by_angle(drawn, rim, tagged)] if center is not None else []
    for i, side in enumerate(s for s in (rim.radius, rim.hub) if s is not None):
        radius, words = drawn.length(side), words_of(side)
        if center is not None and radius and words:
            way = ways[0] if ways and i == 0 else RIGHT + OUT + i * RIGHT
            yield Dimension(center, moved(center, way, radius), words, side=0)


def _seen_by_angle(drawn: Drawn, rim: Round, tagged: Mapping[str, Spot]) -> Iterator[str]:
    """The points of a rim that are placed by an angle in letters: to one of these its radius is drawn."""
    for point in drawn.scene.problem.points:
        place = point.place
        if not isinstance(place, Polar) or point.name not in tagged or place.origin != rim.center:
            continue
        if words_of(place.distance) == words_of(rim.radius) and _is_lettered(place.angle):
            yield point.name


def _given(drawn: Drawn, side: Side, value: float | None) -> Line:
    """The words of a length, if it is told by more than the drawing."""
    return brief(side, value) if is_stated(drawn.scene.problem, side) else ()


def _coordinates(drawn: Drawn, spot: Spot, place: At | TwoFacts, moved: Spot) -> Iterator[Dimension]:
    """The distances of a point from the axes, where the file places it by them and it is drawn there."""
    for axis, side in enumerate((place.x, place.y)):
        words = _given(drawn, side, spot[axis]) if side is not None else ()
        if words and abs(spot[axis]) > NEAR and not moved[axis]:
            start = (0.0, spot[1]) if axis == 0 else (spot[0], 0.0)
            yield Dimension(start, spot, words, side=-1 if axis == 0 else 1, level=True)
