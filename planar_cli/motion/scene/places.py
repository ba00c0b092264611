"""Where the file draws its points: every way of giving a place, as formulas of the coordinates."""

from __future__ import annotations

import math
from dataclasses import field

from planar_cli.errors import Mark, refuse
from planar_cli.motion.terms.sides import Sides
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.implied.written_directions import WrittenDirections
from planar_cli.problem.language.expression import Name, Number, Scaled, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.located import length_in, located
from planar_cli.problem.scene.scene import At, Particle, Place, Point, Problem
from planar_cli.records import changing
from planar_cli.units import parse_unit


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


@changing
class Drawing:
    """All points of one problem, with certain terms for its coordinates."""

    problem: Problem
    sides: Sides
    free: dict[str, Vec]
    """Where particles are that the file calls `free`."""
    places: dict[str, Vec] = field(default_factory=dict)
    """The places that were asked for, by name."""
    _building: list[str] = field(default_factory=list)

    def written_direction(self, origin: str, to: str, reach: Vec) -> Term | None:
        """The angle with which the file writes the direction of the reach from one point to another; None: it writes
        none.
        """
        graph = self.sides.graph
        for written in WrittenDirections(self.problem).between(origin, to):
            angle = self.sides.value(written.angle)
            along = graph.of(reach.dot(unit_vector(graph, angle))).value
            if along > 0 or (written.sense and along == 0):
                return angle
        return None

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
        found = self.places[name] = located(point, self)
        self._building.pop()
        return found

    # --- the numbers of which places are made (problem/scene/located.py) ----------------------------------------------

    def value(self, side: Side) -> Term:
        return self.sides.value(side)

    def number(self, value: int) -> Term:
        return self.sides.graph.number(float(value))

    def unit_vector(self, angle: Term) -> Vec:
        return unit_vector(self.sides.graph, angle)

    def polar(self, distance: Term, angle: Term) -> Vec:
        return self.unit_vector(angle) * distance

    def length(self, v: Vec) -> Term:
        return length_of(self.sides.graph, v)

    def root(self, square: Term) -> Term:
        """The square root; of what is zero but for rounding, zero."""
        return square.graph.number(0.0) if square.zero else square.graph.call("sqrt", square)

    def is_nothing(self, value: Term) -> bool:
        return value.zero

    def apart(self, v: Vec) -> tuple[float, float] | None:
        """A difference of two places as drawn; None: a root of it is not real."""
        if math.isnan(v.x.value) or math.isnan(v.y.value):
            return None
        return (0.0, 0.0) if v.x.zero and v.y.zero else (v.x.value, v.y.value)

    def plain(self, value: Term) -> float | None:
        """A length in m, as drawn."""
        return None if math.isnan(value.value) else value.value

    def shown(self, size: float, side: Side) -> str:
        """A length in the unit in which a side, or what it names, is written."""
        given = {s.name: s.value for s in self.problem.given}
        named = [given.get(n.name) for n in walk(side) if isinstance(n, Name)]
        nodes = [n for tree in (side, *named) if tree is not None for n in walk(tree)]
        units = [parse_unit(n.unit) for n in nodes if isinstance(n, Number | Scaled) and n.unit is not None]
        return length_in(size, units, self.problem.us)


def points_of(problem: Problem) -> dict[str, Point]:
    """All points with a place, also particles that are given by coordinates."""
    found = {p.name: p for p in problem.points}
    for body in problem.bodies:
        place: str | Place | None = body.shape.place if isinstance(body.shape, Particle) else None
        if isinstance(place, At):
            found[body.name] = Point(body.name, place, body.mark)
    return found
