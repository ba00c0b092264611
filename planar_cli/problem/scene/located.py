"""Where points are: every way of giving a place. Written once for whatever numbers a scene is made of."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

from planar_cli.base_units import in_base
from planar_cli.errors import refuse
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import At, Foot, Midpoint, Point, Polar, Rims, Tip, Towards, TwoFacts
from planar_cli.problem.scene.tips import tip
from planar_cli.units import LENGTH, Unit, default_unit

NEITHER = 1e-9
"""A difference of places below this part of their distance does not tell a side."""


class Numbers(Protocol):
    """The numbers of which places are made."""

    def point(self, name: str) -> Vec:
        """The place of another point."""

    def value(self, side: Side) -> Any: ...
    def number(self, value: int) -> Any: ...
    def unit_vector(self, angle: Any) -> Vec: ...
    def polar(self, distance: Any, angle: Any) -> Vec:
        """A distance in a direction."""

    def length(self, v: Vec) -> Any: ...
    def root(self, square: Any) -> Any: ...
    def is_nothing(self, value: Any) -> bool:
        """Is it zero?"""

    def apart(self, v: Vec) -> tuple[float, float] | None:
        """A difference of two places in plain numbers, zeros where they are the same; None: no such places exist."""

    def plain(self, value: Any) -> float | None:
        """A length in m; None where letters have their part in it."""

    def shown(self, size: float, side: Side) -> str:
        """A length in the unit in which a side is written."""


def length_in(size: float, units: Iterable[Unit], us: bool) -> str:
    """A length in the first of these units that is one of length, else in m or ft."""
    unit = next((u for u in units if u.dimension == LENGTH), default_unit(LENGTH, us=us))
    return f"{size / in_base(unit, us):.4g} {unit.text}"


def located(point: Point, numbers: Numbers) -> Vec:
    """The place of a point. FileProblem where there is none, or more than one."""
    place, value, at = point.place, numbers.value, numbers.point
    match place:
        case At():
            return Vec(value(place.x), value(place.y))
        case Polar():
            polar: Vec = at(place.origin) + numbers.polar(value(place.distance), value(place.angle))
            return polar
        case Towards():
            origin = at(place.origin)
            reach = at(place.towards) - origin
            length = numbers.length(reach)
            if numbers.is_nothing(length):
                text = f"{point.name}: {place.origin} and {place.towards} are the same place, which gives no direction"
                hint = f"name another point, or write `{{from: {place.origin}, distance: …, angle: 30 deg}}`"
                raise refuse(point.mark, "PL510", text, hint)
            towards: Vec = origin + reach * (value(place.distance) / length)
            return towards if place.offset is None else towards + reach.turned() * (value(place.offset) / length)
        case Midpoint():
            middle: Vec = (at(place.a) + at(place.b)) / numbers.number(2)
            return middle
        case TwoFacts():
            return _two_facts(point, place, numbers)
        case Foot():
            return _touched(place, numbers)
        case Rims():
            return _between_rims(point, place, numbers)
        case Tip():
            return tip(point, place, numbers, _edge(place, numbers) if place.through else None)
    raise TypeError(type(place).__name__)


def _touched(place: Foot, numbers: Numbers) -> Vec:
    """The foot; where a rim that meets the edge later is not there yet, the place of the rim that is nearest to it. A
    wheel that comes over an edge, or up to a plateau, is drawn beyond the line: it stays on the side where it rolls.
    """
    foot = _foot(place, numbers)
    if not place.later:
        return foot
    center = numbers.point(place.center)
    reach = foot - center
    length, radii = numbers.length(reach), [numbers.value(r) for r in place.radii]
    beyond = place.former and _below(reach.dot(numbers.point(place.former) - center), numbers.number(0), numbers)
    if numbers.is_nothing(length) or (not beyond and any(numbers.is_nothing(length - r) for r in radii)):
        return foot
    nearest: Vec = center + reach * ((-radii[0] if beyond else radii[0]) / length)
    return nearest


def _foot(place: Foot, numbers: Numbers) -> Vec:
    """The foot of the perpendicular from the centre on the edge."""
    base, along = _edge(place, numbers)
    foot: Vec = base + along * (numbers.point(place.center) - base).dot(along)
    return foot


def _edge(place: Foot | Tip, numbers: Numbers) -> tuple[Vec, Vec]:
    """A point of a straight edge, and its direction."""
    base = numbers.point(place.through)
    if place.angle is not None:
        return base, numbers.unit_vector(numbers.value(place.angle))
    assert place.towards is not None
    reach = numbers.point(place.towards) - base
    return base, reach / numbers.length(reach)


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
    if _below(r, s, numbers) and _below(length, s, numbers):
        inner: Vec = b + (a - b) * (s / length)
        return inner
    touching: Vec = a + reach * (r / length)
    return touching


def _below(smaller: Any, larger: Any, numbers: Numbers) -> bool:
    gap = numbers.apart(Vec(larger - smaller, numbers.number(0)))
    return gap is not None and gap[0] > 0


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
            first, second = _line_names(place)
            text = f"{point.name}: {first} and {second} are parallel, and meet nowhere"
            raise refuse(point.mark, "PL512", text, "turn the line, or give a distance in the place of one of the two")
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
    for through, angle in place.lines:
        lines.append((numbers.point(through), numbers.unit_vector(numbers.value(angle))))
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
        raise refuse(point.mark, "PL513", *_out_of_reach(point, place, numbers))
    dx, dy = difference
    if dx == dy == 0:
        return one
    if place.side is None:
        hint = "add `side: above`, or below" if abs(dx) < abs(dy) else "add `side: left`, or right"
        text = f"{point.name}: two places fit, {_way(dx, dy)} of each other"
        raise refuse(point.mark, "PL514", text, hint)
    lead = {"right": dx, "left": -dx, "above": dy, "below": -dy}[place.side]
    if abs(lead) <= (abs(dx) + abs(dy)) * NEITHER:
        ways = "`above` or `below`" if abs(dx) < abs(dy) else "`left` or `right`"
        beside = f"{place.side} of" if place.side in ("left", "right") else place.side
        text = f"{point.name}: two places fit, {_way(dx, dy)} of each other, and none is {beside} the other"
        raise refuse(point.mark, "PL515", text, f"write `side:` with {ways}")
    return one if lead > 0 else other


def _way(dx: float, dy: float) -> str:
    """How two places lie, by the larger of their differences."""
    return "above and below" if abs(dx) < abs(dy) else "left and right"


def _line_names(place: TwoFacts) -> list[str]:
    """The lines in words."""
    names = ["the line of that x"] * (place.x is not None) + ["the line of that y"] * (place.y is not None)
    return names + [f"the line through {through}" for through, _ in place.lines]


def _out_of_reach(point: Point, place: TwoFacts, numbers: Numbers) -> tuple[str, str]:
    """Why a circle meets nothing, by how much it fails where no letter is in it, and what to do."""
    (name, side), *others = place.distances
    radius = numbers.plain(numbers.value(side))
    text = f"{point.name}: there is no such place, the distances do not reach"
    hint = "make a distance larger, or move a point: a link cannot be shorter than the gap that it spans"
    if not others:
        ((base, direction),) = _lines(place, numbers)
        off = numbers.plain((numbers.point(name) - base).cross(direction))
        if radius is None or off is None:
            return text, hint
        gap, reach = (numbers.shown(x, side) for x in (abs(off), radius))
        (line,) = _line_names(place)
        return f"{point.name}: {line} passes {name} at {gap}, and the distance is only {reach}", hint
    ((other, second),) = others
    rest = numbers.plain(numbers.value(second))
    gap_length = numbers.plain(numbers.length(numbers.point(other) - numbers.point(name)))
    if radius is None or rest is None or gap_length is None:
        return text, hint
    gap, one, two = (numbers.shown(x, side) for x in (gap_length, radius, rest))
    if gap_length > radius + rest:
        both = numbers.shown(radius + rest, side)
        return f"{point.name}: {name} and {other} are {gap} apart, and {one} and {two} reach only {both}", hint
    longer = numbers.shown(abs(radius - rest), side)
    text = f"{point.name}: {name} and {other} are only {gap} apart, and {one} and {two} differ by {longer}"
    return text, "make the larger distance smaller, or move a point: one circle lies inside the other"
