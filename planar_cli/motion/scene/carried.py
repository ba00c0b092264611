"""Where the bodies of one problem are and what they carry, as terms of their coordinates.

Every rigid body has the coordinates x, y of its mass centre and its angle theta, every particle x, y; the reference
configuration is the one that the file draws at its first state or instant.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from typing import Any

from planar_cli.motion.scene.masses import Drawn, drawn_bodies
from planar_cli.motion.scene.places import Drawing, length_of, points_of, unit_vector
from planar_cli.motion.scene.reference import Reference, reference_of
from planar_cli.motion.terms.sides import Constants, Sides
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.language.expression import Name, Number, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.ordinary import scales_of
from planar_cli.problem.scene.scene import GROUND, Line, Problem, Surface
from planar_cli.problem.scene.shapes import attached, closest_first, fixed_points, own_points
from planar_cli.records import record
from planar_cli.units import LENGTH, parse_unit

TINIEST = sys.float_info.min
"""Added to a square under a root, so that what is just zero does not divide zero by zero."""
EXACT = 1e-14
"""A part of an arm below this part of it is the rounding of a right angle."""


@record
class Place:
    """One body: its coordinates, their rates, and what it carries."""

    x: Term
    """Of the mass centre, m."""
    y: Term
    """Of the mass centre, m."""
    theta: Term | None
    """The body's angle, rad; None: a particle."""
    vx: Term
    """m/s."""
    vy: Term
    """m/s."""
    omega: Term | None
    """rad/s; None: a particle."""
    mass: Term
    """kg; it may vary with the time and with places."""
    inertia: Term
    """About the mass centre, kg m²."""

    @property
    def center(self) -> Vec:
        """The mass centre."""
        return Vec(self.x, self.y)

    @property
    def velocity(self) -> Vec:
        """Of the mass centre."""
        return Vec(self.vx, self.vy)

    @property
    def variables(self) -> tuple[tuple[Term, Term], ...]:
        """Coordinates with their rates."""
        linear = ((self.x, self.vx), (self.y, self.vy))
        return linear if self.theta is None or self.omega is None else (*linear, (self.theta, self.omega))


class Carried:
    """The bodies of one problem with what they carry; the points that stay with centres are told by `spots`."""

    def __init__(self, problem: Problem, values: Mapping[str, float] | None = None) -> None:
        """`values`: numbers for letters, unknowns and coordinates, by name, in SI units."""
        self.problem, self.graph = problem, Graph()
        self.surfaces: dict[str, Surface] = {s.name: s for s in problem.surfaces}
        self.constants = Constants(self.graph, problem, values or {})
        self.reference: Reference = reference_of(problem, self.graph, self.constants)
        self.time = self.graph.variable("t", self.reference.time, 1.0)
        self.sides = Sides(self.graph, self.constants, {"t": self.time})
        self.gravity: Term = self._gravity()
        self.free = {n: Vec(*(self.graph.number(p) for p in (v.x, v.y))) for n, v in self.reference.free.items()}
        self._drawing = self._drawn_at(self.reference.coordinates)
        self.drawn: dict[str, Drawn] = drawn_bodies(self._drawing)
        self.extent = self._size()
        self._arms: dict[Vec, tuple[str, Vec]] = {}
        self._frames: dict[str, Vec] = {}
        self._axes: dict[str, tuple[float, Vec]] = {}
        self.places: dict[str, Place] = {name: self._place(name) for name in self.drawn}
        (self.owners, self.own_points), self.fixed = self._owners(), fixed_points(problem)
        self._points: dict[str, Vec] = {}
        self.own_variables: dict[str, tuple[Term, Term]] = {}
        self.curve_variables: dict[str, Term] = {}

    # --- making ------------------------------------------------------------------------------------------------------

    def _gravity(self) -> Term:
        heavy = self.problem.plane == "vertical"
        return self.constants.gravity(self.sides) if heavy else self.graph.number(0.0)

    def _drawn_at(self, coordinates: Mapping[str, float]) -> Drawing:
        """The drawing at certain values of the coordinates."""
        numbers = {n: self.graph.number(v) for n, v in coordinates.items()}
        return Drawing(self.problem, self.sides.with_variables(numbers), self.free)

    def _size(self) -> float:
        """The largest distance from the middle of the drawing, m; of a single point the largest length given."""
        places = [self.place_drawn(name) for name in points_of(self.problem)]
        places += [_numbers(d.center) for d in self.drawn.values()]
        if not places:
            return self._given()
        x, y = (sum(getattr(p, a) for p in places) / len(places) for a in ("x", "y"))
        far = max(math.hypot(p.x - x, p.y - y) for p in places)
        radii = (getattr(d.shape, "radius", None) for d in self.drawn.values())
        return max([far, *(self._drawing.sides.value(r).value for r in radii if r is not None)]) or self._given()

    def _given(self) -> float:
        """The largest length that the file gives, m; one that goes with its other numbers where it gives none."""
        known = [g.value for g in self.problem.given if isinstance(g.value, Number) and g.value.unit is not None]
        lengths = [n for n in known if parse_unit(n.unit or "").dimension == LENGTH]
        sizes = (abs(self._drawing.sides.value(n).value) for n in lengths)
        return max(sizes, default=0.0) or scales_of(self.problem).length

    def free_name(self, stem: str) -> str:
        """A name for a variable that no other variable has."""
        while stem in self.graph.names.values():
            stem += "_"
        return stem

    def variable(self, stem: str, value: float, size: float) -> Term:
        """A new variable."""
        return self.graph.variable(self.free_name(stem), value, size)

    def _place(self, name: str) -> Place:
        body = self.drawn[name]
        center = _numbers(body.center)
        x, y = (self.variable(f"{a}_{name}", getattr(center, a), self.extent) for a in ("x", "y"))
        vx, vy = (self.variable(f"v{a}_{name}", 0.0, 0.0) for a in ("x", "y"))
        theta = self.variable(f"theta_{name}", body.theta.value, 1.0) if body.rigid else None
        omega = self.variable(f"omega_{name}", 0.0, 0.0) if body.rigid else None
        return Place(x, y, theta, vx, vy, omega, body.mass, body.inertia)

    def _owners(self) -> tuple[dict[str, list[str]], set[str]]:
        """The bodies that a point belongs to, the most intimate first; and the points by which bodies are drawn."""
        owners: dict[str, list[str]] = {}
        own = {p for b in self.problem.bodies for p in (*own_points(b.shape), *b.points)}

        def belongs(point: str, body: str) -> None:
            if body in self.places and body not in owners.setdefault(point, []):
                owners[point].append(body)

        # A point that is called like a body is that body's before it is any other's.
        for name in (b.name for b in self.problem.bodies):
            if name in points_of(self.problem) or name in self.free:
                belongs(name, name)
        for body in closest_first(self.problem.bodies):
            for point in (*own_points(body.shape), *body.points):
                belongs(point, body.name)
        for point, partner in attached(self.problem):
            belongs(point, self.carrier(partner))
        return owners, own | {b.name for b in self.problem.bodies}

    def rates(self) -> dict[Term, Term]:
        """Every coordinate of the state with its rate, and the time with 1."""
        found = {q: v for place in self.places.values() for q, v in place.variables}
        return {**found, **dict(self.own_variables.values()), self.time: self.graph.number(1.0)}

    # --- who owns a point --------------------------------------------------------------------------------------------

    def carrier(self, partner: str) -> str:
        """The body that a partner of a joint stands for: a surface's body, or the ground."""
        surface = self.surfaces.get(partner)
        return (surface.body or GROUND) if surface is not None else partner

    def owners_of(self, point: str) -> tuple[str, ...]:
        """All bodies that a point belongs to."""
        return tuple(self.owners.get(point, ()))

    def owner(self, point: str, apart_from: str = "") -> str:
        """The body that a point belongs to (another one than `apart_from`); the ground when it belongs to none."""
        owners = self.owners.get(point) or ((point,) if point in self.places else ())
        return next((b for b in owners if b != apart_from), GROUND)

    # --- where things are --------------------------------------------------------------------------------------------

    def place_drawn(self, name: str) -> Vec:
        """The place of a point as drawn, in plain numbers; of a body, by whose name a rope may end, its mass centre."""
        is_body = name in self.drawn and name not in self.free and name not in points_of(self.problem)
        return self.drawn_center(name) if is_body else _numbers(self._drawing.point(name))

    def drawn_center(self, body: str) -> Vec:
        """The mass centre as drawn, in plain numbers."""
        return _numbers(self.drawn[body].center)

    def frame(self, body: str) -> Vec:
        """(cos, sin) of a body's angle."""
        if body not in self._frames:
            theta = self.places[body].theta
            self._frames[body] = unit_vector(self.graph, theta if theta is not None else self.graph.number(0.0))
        return self._frames[body]

    def turned_with(self, body: str, drawn: Vec) -> Vec:
        """A drawn direction that turns with a body."""
        graph = self.graph
        v = _numbers(Vec(graph.of(drawn.x), graph.of(drawn.y)))
        place = self.places.get(body)
        if place is None or place.theta is None:
            return Vec(graph.number(v.x), graph.number(v.y))
        offset, frame = self._aligned(body, v)
        angle = place.theta.value + offset
        cosine, sine = math.cos(angle), math.sin(angle)
        a, b = _cleared(cosine * v.x + sine * v.y, cosine * v.y - sine * v.x)
        return Vec(frame.x * a - frame.y * b, frame.y * a + frame.x * b)

    def _aligned(self, body: str, v: Vec) -> tuple[float, Vec]:
        """Axes that turn with a body, and their angle from its own: the first direction asked for lies along one.

        So most points have one coordinate in them that is zero.
        """
        if body not in self._axes:
            theta = self.places[body].theta
            assert theta is not None
            size, along = math.hypot(v.x, v.y), math.atan2(v.y, v.x) - theta.value
            if not size:
                return 0.0, self.frame(body)
            if 0.0 in _cleared(math.cos(along), math.sin(along)):
                self._axes[body] = 0.0, self.frame(body)
            else:
                self._axes[body] = along, unit_vector(self.graph, theta + along)
        return self._axes[body]

    def configuration(self, coordinates: Mapping[str, float]) -> dict[Term, float]:
        """Where the bodies are at certain values of the coordinates."""
        drawing = self._drawn_at({**self.reference.coordinates, **coordinates})
        found: dict[Term, float] = {}
        for name, body in drawn_bodies(drawing).items():
            place, center = self.places[name], _numbers(body.center)
            found |= {place.x: center.x, place.y: center.y}
            if place.theta is not None:
                found[place.theta] = body.theta.value
        for name, (variable, _) in self.own_variables.items():
            found[variable] = coordinates.get(name, variable.value)
        return found

    def turned_by(self, body: str) -> Term:
        """The angle by which a body has turned since it was drawn; 0 for the ground and for particles."""
        place = self.places.get(body)
        if place is None or place.theta is None:
            return self.graph.number(0.0)
        return place.theta - place.theta.value

    def carried_from(self, body: str, drawn: Vec) -> Vec:
        """The place of the body's material point that was drawn there."""
        graph = self.graph
        place = self.places.get(body)
        at = _numbers(Vec(graph.of(drawn.x), graph.of(drawn.y)))
        if place is None:
            return Vec(graph.number(at.x), graph.number(at.y))
        center = self.drawn_center(body)
        arm = Vec(*(_difference(getattr(at, a), getattr(center, a), self.extent) for a in ("x", "y")))
        carried = self.turned_with(body, arm)
        found = place.center + carried
        self._arms.setdefault(found, (body, carried))
        return found

    def carried(self, body: str, point: str) -> Vec:
        """A drawn point that goes with a body."""
        return self.carried_from(body, self._drawing.point(point))

    def arm(self, body: str, point: Vec) -> Vec:
        """From the body's mass centre to a place."""
        known = self._arms.get(point)
        if known is not None and known[0] == body:
            return known[1]
        found: Vec = point - self.places[body].center
        return found

    def point(self, name: str) -> Vec:
        """The place of a point (or of a body: its mass centre)."""
        if name not in self._points:
            self._points[name] = self._moving(name)
        return self._points[name]

    def _moving(self, name: str) -> Vec:
        if name in self.places and name not in points_of(self.problem):
            return self.places[name].center
        owner = self.owner(name)
        if owner != GROUND:
            return self.carried(owner, name)
        return Drawing(self.problem, self.sides, self.free).point(name)

    def center(self, body: str) -> Vec:
        """The mass centre of a body; of the ground, the origin."""
        return self.places[body].center if body != GROUND else Vec(self.graph.number(0.0), self.graph.number(0.0))

    def center_name(self, body: str) -> str:
        """The name of a body's mass centre in print."""
        return self.drawn[body].center_name or body

    own_name = center_name

    def middle(self) -> Vec:
        """The mean of all drawn points."""
        names = list(points_of(self.problem))
        total = Vec(self.graph.number(0.0), self.graph.number(0.0))
        for name in names:
            total = total + self.point(name)
        mean: Vec = total / max(len(names), 1)
        return mean

    # --- numbers and directions --------------------------------------------------------------------------------------

    def value(self, side: Side) -> Term:
        """The value of a formula of places and constants."""
        return self.sides.value(side)

    def unit(self, angle: Side) -> Vec:
        """The unit vector in a direction given by an angle."""
        return unit_vector(self.graph, self.value(angle))

    def length(self, v: Vec) -> Term:
        """|v|; where it is zero as drawn, it has a direction from there on."""
        square = self.graph.of(v.dot(v))
        grows = square.zero and not square.constant
        return self.graph.call("sqrt", square + TINIEST) if grows else length_of(self.graph, v)

    def root(self, square: Any) -> Term:
        return self.graph.call("sqrt", self.graph.of(square))

    def steady(self, direction: Vec) -> None:
        """Numbers need no plainer formula."""

    def surface_direction(self, surface: Surface) -> Vec:
        """The direction of a straight surface, which turns with the body that carries it."""
        assert isinstance(surface.shape, Line)
        drawn = unit_vector(self.graph, self._drawing.sides.value(surface.shape.angle))
        return self.turned_with(surface.body or GROUND, drawn)

    def direction(self, along: Side | str) -> Vec:
        """A direction given by an angle, a surface (its line) or a body (its angle)."""
        name = along if isinstance(along, str) else along.name if isinstance(along, Name) else ""
        if name in self.surfaces:
            return self.surface_direction(self.surfaces[name])
        if name in self.places:
            return self.frame(name)
        assert not isinstance(along, str)
        return self.unit(along)

    def sign(self, expr: Any) -> int:
        """-1, 0 or 1 as drawn."""
        return self.graph.of(expr).positive

    def is_zero(self, expr: Any) -> bool:
        """Is it zero as drawn?"""
        return self.graph.of(expr).zero

    def vanishes(self, expr: Any) -> bool:
        """Is it zero wherever the bodies are?"""
        term = self.graph.of(expr)
        return term.constant and term.zero

    def velocity(self, point: Vec, body: str) -> Vec:
        """Of the body's point at a place."""
        if body == GROUND:
            return self.center(GROUND)
        place = self.places[body]
        if place.omega is None:
            return place.velocity
        found: Vec = place.velocity + self.arm(body, point).turned() * place.omega
        return found

    def turn(self, body: str) -> Term:
        """The angular velocity of a body."""
        place = self.places.get(body)
        return self.graph.number(0.0) if place is None or place.omega is None else place.omega

    def rigid(self, body: str) -> bool:
        return body == GROUND or self.drawn[body].rigid

    def names_carrier(self, name: str) -> bool:
        """Is the name a body or a surface?"""
        return name in self.places or name in self.surfaces


def _numbers(v: Vec) -> Vec:
    """A vector of terms as plain numbers, as drawn."""
    return Vec(v.x.value, v.y.value)


def _difference(a: float, b: float, size: float) -> float:
    """a - b; zero where that is the rounding of places in a drawing of this size."""
    found = a - b
    return 0.0 if abs(found) <= EXACT * max(abs(a), abs(b), size) else found


def _cleared(a: float, b: float) -> tuple[float, float]:
    """Two parts of a vector; one that is the rounding of the other is zero."""
    far = EXACT * math.hypot(a, b)
    return (0.0 if abs(a) <= far else a), (0.0 if abs(b) <= far else b)
