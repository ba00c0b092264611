"""Where points are: every way of giving a place. Written once for whatever numbers a scene is made of."""

from __future__ import annotations

from typing import Any, Protocol

from planar_cli.errors import refuse
from planar_cli.problem.expression import Side
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import At, Foot, Midpoint, Point, Polar, Rims, Towards, TwoFacts

NEITHER = 1e-9
"""A difference of places below this part of their distance does not tell a side."""


class Numbers(Protocol):
    """The numbers of which places are made."""

    def point(self, name: str) -> Vec:
        """The place of another point."""

    def value(self, side: Side) -> Any: ...
    def number(self, value: int) -> Any: ...
    def unit_vector(self, angle: Any) -> Vec: ...
    def length(self, v: Vec) -> Any: ...
    def root(self, square: Any) -> Any: ...
    def is_nothing(self, value: Any) -> bool:
        """Is it zero?"""

    def apart(self, v: Vec) -> tuple[float, float] | None:
        """A difference of two places in plain numbers, zeros where they are the same; None: no such places exist."""


def located(point: Point, numbers: Numbers) -> Vec:
    """The place of a point. FileProblem where there is none, or more than one."""
    place, value, at = point.place, numbers.value, numbers.point
    match place:
        case At():
            return Vec(value(place.x), value(place.y))
        case Polar():
            polar: Vec = at(place.origin) + numbers.unit_vector(value(place.angle)) * value(place.distance)
            return polar
        case Towards():
            origin = at(place.origin)
            reach = at(place.towards) - origin
            length = numbers.length(reach)
            if numbers.is_nothing(length):
                text = f"{place.origin} and {place.towards} are the same place: no direction"
                raise refuse(point.mark, "PL510", text)
            towards: Vec = origin + reach * (value(place.distance) / length)
            return towards
        case Midpoint():
            middle: Vec = (at(place.a) + at(place.b)) / numbers.number(2)
            return middle
        case TwoFacts():
            return _two_facts(point, place, numbers)
        case Foot():
            return _foot(place, numbers)
        case Rims():
            return _between_rims(point, place, numbers)
    raise TypeError(type(place).__name__)


def _foot(place: Foot, numbers: Numbers) -> Vec:
    """The foot of the perpendicular from the centre on the edge."""
    base = numbers.point(place.through)
    if place.angle is not None:
        along = numbers.unit_vector(numbers.value(place.angle))
    else:
        assert place.towards is not None
        reach = numbers.point(place.towards) - base
        along = reach / numbers.length(reach)
    foot: Vec = base + along * (numbers.point(place.center) - base).dot(along)
    return foot


def _between_rims(point: Point, place: Rims, numbers: Numbers) -> Vec:
    """On the line of centres: between them, or beyond the centre of the smaller circle that lies inside the larger."""
    a, b = numbers.point(place.a), numbers.point(place.b)
    reach = b - a
    length = numbers.length(reach)
    if numbers.is_nothing(length):
        raise refuse(point.mark, "PL510", f"{place.a} and {place.b} are the same place: rims about it touch nowhere")
    radii = [(numbers.value(r), numbers.value(s)) for r in place.radii_a for s in place.radii_b]
    # Where none of them touch, the contact itself tells by how much the rims are apart.
    r, s = next((pair for pair in radii if _touch(*pair, length, numbers)), radii[0])

    def below(smaller: Any, larger: Any) -> bool:
        gap = numbers.apart(Vec(larger - smaller, numbers.number(0)))
        return gap is not None and gap[0] > 0

    if below(r, s) and below(length, s):
        inner: Vec = b + (a - b) * (s / length)
        return inner
    touching: Vec = a + reach * (r / length)
    return touching


def _touch(r: Any, s: Any, length: Any, numbers: Numbers) -> bool:
    """Do circles of these radii touch, with their centres so far apart, from outside or one inside the other?"""
    return any(numbers.is_nothing(length - reach) for reach in (r + s, r - s, s - r))


def _two_facts(point: Point, place: TwoFacts, numbers: Numbers) -> Vec:
    """The intersection of two of: a vertical (x), a horizontal (y), a line, circles (distances)."""
    lines = _lines(place, numbers)
    circles = [(numbers.point(name), numbers.value(distance)) for name, distance in place.distances]
    if len(lines) + len(circles) != 2:
        raise refuse(point.mark, "PL511", f"{point.name} needs just two facts of x, y, line, distances")
    if len(lines) == 2:
        (p, d), (q, e) = lines
        determinant = d.cross(e)
        if numbers.is_nothing(determinant):
            raise refuse(point.mark, "PL512", f"{point.name}: the two lines are parallel")
        crossing: Vec = p + d * ((q - p).cross(e) / determinant)
        return crossing
    if len(lines) == 1:
        candidates = _line_and_circle(*lines[0], *circles[0], numbers)
    else:
        candidates = _two_circles(*circles[0], *circles[1], numbers)
    return _chosen(point, place, candidates, numbers)


def _lines(place: TwoFacts, numbers: Numbers) -> list[tuple[Vec, Vec]]:
    zero, one = numbers.number(0), numbers.number(1)
    lines: list[tuple[Vec, Vec]] = []
    if place.x is not None:
        lines.append((Vec(numbers.value(place.x), zero), Vec(zero, one)))
    if place.y is not None:
        lines.append((Vec(zero, numbers.value(place.y)), Vec(one, zero)))
    if place.line is not None:
        lines.append((numbers.point(place.line[0]), numbers.unit_vector(numbers.value(place.line[1]))))
    return lines


def _line_and_circle(base: Vec, direction: Vec, center: Vec, radius: Any, numbers: Numbers) -> tuple[Vec, Vec]:
    """Foot of the perpendicular from the centre, plus and minus half the chord."""
    along, across = (center - base).dot(direction), (center - base).cross(direction)
    half = numbers.root(radius * radius - across * across)
    return base + direction * (along + half), base + direction * (along - half)


def _two_circles(a: Vec, r: Any, b: Vec, s: Any, numbers: Numbers) -> tuple[Vec, Vec]:
    """Intersection of two circles: along the line of centres by (r² - s² + d²)/(2 d²), across it by half the chord."""
    d = b - a
    square = d.dot(d)
    along = ((r * r - s * s) / square + numbers.number(1)) / numbers.number(2)
    across = numbers.root(r * r / square - along * along)
    foot, offset = a + d * along, d.turned() * across
    return foot + offset, foot - offset


def _chosen(point: Point, place: TwoFacts, candidates: tuple[Vec, Vec], numbers: Numbers) -> Vec:
    """The place on the named side of the other one."""
    one, other = candidates
    difference = numbers.apart(one - other)
    if difference is None:
        text = f"{point.name}: there is no such place, the distances do not reach"
        hint = "make a distance larger, or move a point: a link cannot be shorter than the gap that it spans"
        raise refuse(point.mark, "PL513", text, hint)
    dx, dy = difference
    if dx == dy == 0:
        return one
    if place.side is None:
        hint = "add `side: left`, right, above or below (the other)"
        raise refuse(point.mark, "PL514", f"{point.name}: two places fit", hint)
    lead = {"right": dx, "left": -dx, "above": dy, "below": -dy}[place.side]
    if abs(lead) <= (abs(dx) + abs(dy)) * NEITHER:
        text = f"{point.name}: neither place is {place.side} of the other"
        raise refuse(point.mark, "PL515", text, "choose by the other axis")
    return one if lead > 0 else other
