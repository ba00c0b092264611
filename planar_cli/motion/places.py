"""Where the file draws its points: every way of giving a place, as formulas of the coordinates."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from planar_cli.errors import Mark, refuse
from planar_cli.motion.sides import Sides
from planar_cli.motion.terms import Graph, Term
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import At, Midpoint, Particle, Place, Point, Polar, Problem, Towards, TwoFacts

Lookup = Callable[[str], Vec]
CLEAR = 1e-9
"""A difference of places below this part of their distance does not tell a side."""


def unit_vector(graph: Graph, angle: Term) -> Vec:
    """(cos, sin) of an angle."""
    return Vec(graph.call("cos", angle), graph.call("sin", angle))


def length_of(graph: Graph, v: Vec) -> Term:
    """|v|; along an axis the component itself, on the side where it is drawn."""
    for one, other in ((v.x, v.y), (v.y, v.x)):
        if graph.of(other).constant and graph.of(other).value == 0:
            along = graph.of(one)
            return -along if along.value < 0 else along
    return graph.call("sqrt", v.dot(v))


@dataclass(slots=True)
class Drawing:
    """All points of one problem, with certain terms for its coordinates."""

    problem: Problem
    sides: Sides
    free: dict[str, Vec]
    """Where particles are that the file calls `free`."""
    places: dict[str, Vec] = field(default_factory=dict)
    """The places that were asked for, by name."""
    _building: list[str] = field(default_factory=list)

    def point(self, name: str) -> Vec:
        """The place of a point; a particle that is given by coordinates is a point of its own name."""
        if name in self.places:
            return self.places[name]
        if name in self.free:
            return self.free[name]
        point = points_of(self.problem).get(name)
        if point is None:
            mark = next((b.mark for b in self.problem.bodies if b.name == name), Mark(self.problem.file, 1, 1))
            raise refuse(mark, "PL530", f"{name} is no point with a place")
        if name in self._building:
            way = " -> ".join([*self._building, name])
            raise refuse(point.mark, "PL531", f"the place of {name} is given through itself: {way}")
        self._building.append(name)
        found = self.places[name] = self._place(point)
        self._building.pop()
        return found

    def _place(self, point: Point) -> Vec:
        sides, place = self.sides, point.place
        match place:
            case At():
                return Vec(sides.value(place.x), sides.value(place.y))
            case Polar():
                direction = unit_vector(sides.graph, sides.value(place.angle))
                polar: Vec = self.point(place.origin) + direction * sides.value(place.distance)
                return polar
            case Towards():
                origin = self.point(place.origin)
                reach = self.point(place.towards) - origin
                length = length_of(sides.graph, reach)
                if length.zero:
                    text = f"{place.origin} and {place.towards} are the same place: no direction"
                    raise refuse(point.mark, "PL510", text)
                towards: Vec = origin + reach * (sides.value(place.distance) / length)
                return towards
            case Midpoint():
                middle: Vec = (self.point(place.a) + self.point(place.b)) * 0.5
                return middle
            case TwoFacts():
                return self._two_facts(point, place)
        raise TypeError(type(place).__name__)

    def _two_facts(self, point: Point, place: TwoFacts) -> Vec:
        """The intersection of two of: a vertical (x), a horizontal (y), a line, circles (distances)."""
        lines = self._lines(place)
        circles = [(self.point(name), self.sides.value(distance)) for name, distance in place.distances]
        if len(lines) + len(circles) != 2:
            raise refuse(point.mark, "PL511", f"{point.name} needs just two facts of x, y, line, distances")
        if len(lines) == 2:
            (p, d), (q, e) = lines
            determinant = d.cross(e)
            if determinant.zero:
                raise refuse(point.mark, "PL512", f"{point.name}: the two lines are parallel")
            crossing: Vec = p + d * ((q - p).cross(e) / determinant)
            return crossing
        if len(lines) == 1:
            return _choose(point, place, self._line_and_circle(*lines[0], *circles[0]))
        return _choose(point, place, self._two_circles(*circles[0], *circles[1]))

    def _lines(self, place: TwoFacts) -> list[tuple[Vec, Vec]]:
        sides = self.sides
        zero, one = sides.graph.number(0.0), sides.graph.number(1.0)
        lines: list[tuple[Vec, Vec]] = []
        if place.x is not None:
            lines.append((Vec(sides.value(place.x), zero), Vec(zero, one)))
        if place.y is not None:
            lines.append((Vec(zero, sides.value(place.y)), Vec(one, zero)))
        if place.line is not None:
            lines.append((self.point(place.line[0]), unit_vector(sides.graph, sides.value(place.line[1]))))
        return lines

    def _line_and_circle(self, base: Vec, direction: Vec, center: Vec, radius: Term) -> tuple[Vec, Vec]:
        """Foot of the perpendicular from the centre, plus and minus half the chord."""
        along, across = (center - base).dot(direction), (center - base).cross(direction)
        half = self._root(radius * radius - across * across)
        return base + direction * (along + half), base + direction * (along - half)

    def _two_circles(self, a: Vec, r: Term, b: Vec, s: Term) -> tuple[Vec, Vec]:
        """Along the line of centres by (r² - s² + d²)/(2 d²), across it by half the chord."""
        d = b - a
        square = d.dot(d)
        along = ((r * r - s * s) / square + 1) * 0.5
        across = self._root(r * r / square - along * along)
        foot, offset = a + d * along, d.turned() * across
        return foot + offset, foot - offset

    def _root(self, square: Term) -> Term:
        """The square root; of what is zero but for rounding, zero."""
        return square.graph.number(0.0) if square.zero else square.graph.call("sqrt", square)


def points_of(problem: Problem) -> dict[str, Point]:
    """All points with a place, also particles that are given by coordinates."""
    found = {p.name: p for p in problem.points}
    for body in problem.bodies:
        place: str | Place | None = body.shape.place if isinstance(body.shape, Particle) else None
        if isinstance(place, At):
            found[body.name] = Point(body.name, place, body.mark)
    return found


def _choose(point: Point, place: TwoFacts, candidates: tuple[Vec, Vec]) -> Vec:
    """The place on the named side of the other one."""
    one, other = candidates
    dx, dy = one.x.value - other.x.value, one.y.value - other.y.value
    if math.isnan(dx) or math.isnan(dy):
        raise refuse(
            point.mark,
            "PL513",
            f"{point.name}: there is no such place, the distances do not reach",
            "make a distance larger, or move a point: a link cannot be shorter than the gap that it spans",
        )
    if (one.x - other.x).zero and (one.y - other.y).zero:
        return one
    if place.side is None:
        hint = "add `side: left`, right, above or below (the other)"
        raise refuse(point.mark, "PL514", f"{point.name}: two places fit", hint)
    lead = {"right": dx, "left": -dx, "above": dy, "below": -dy}[place.side]
    if abs(lead) <= (abs(dx) + abs(dy)) * CLEAR:
        text = f"{point.name}: neither place is {place.side} of the other"
        raise refuse(point.mark, "PL515", text, "choose by the other axis")
    return one if lead > 0 else other
