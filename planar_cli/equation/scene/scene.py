"""One instant of a problem with its geometry settled: symbols, places, bodies. What joints and loads ask when they
state facts.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, trigonometric
from planar_cli.equation.scene.arms import Arms
from planar_cli.equation.scene.bodies import MassReader
from planar_cli.equation.scene.curves import bend_at, carrier_pose
from planar_cli.equation.scene.decided import Decided
from planar_cli.equation.scene.displacement import Displacement
from planar_cli.equation.scene.marks import own_mark
from planar_cli.equation.scene.places import AsDrawn, Jets, is_along_one_line, is_plain
from planar_cli.equation.scene.written_angles import WrittenAngles
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.ledger import Ledger
from planar_cli.errors import Mark, refuse
from planar_cli.problem.language.expression import Name, Side, Statement
from planar_cli.problem.scene.caught import demand_caught
from planar_cli.problem.scene.facts import Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.located import located
from planar_cli.problem.scene.outlines import Bend, Span, edges_at, outline_of, spot_of
from planar_cli.problem.scene.relaxed import reach_of, relaxed_at
from planar_cli.problem.scene.scene import (
    GROUND,
    Curve,
    Line,
    Particle,
    Plate,
    Point,
    Polar,
    Problem,
    Rod,
    Round,
    Surface,
    TwoFacts,
)
from planar_cli.problem.scene.shapes import attached, closest_first, fixed_points, own_points

WORDY = 4
"""An expression of more operations than this gets a name of its own where it is a coordinate of a point."""


class Scene(Decided):
    """Geometry and bodies of one problem at one instant; built once, then only asked.

    `points`: places as expressions. `formulas`: the same as jets in the coordinates. `owners`: the bodies that a point
    belongs to, the most intimate first. `gravity`: the symbol g, or 0 in a horizontal plane.
    """

    def __init__(
        self, problem: Problem, ledger: Ledger, evaluator: Evaluator, displacement: Displacement | None = None
    ) -> None:
        self.problem, self.ledger, self.evaluator = problem, ledger, evaluator
        self.displacement = displacement
        self.open_places: set[sp.Symbol] = set()
        self._turns: dict[str, sp.Expr] = {}
        self.surfaces: dict[str, Surface] = {s.name: s for s in problem.surfaces}
        self._places = {p.name: p for p in problem.points}
        self.formulas: dict[str, Vec] = {}
        self.points: dict[str, Vec] = {}
        self._building: list[str] = []
        self._lengths: dict[Vec, sp.Expr] = {}
        self._outlines: dict[tuple[str, Vec], Outline] = {}
        self.bodies = {}
        self.undecided()
        self.gravity: sp.Expr = self._gravity()
        self._implicit_points()
        for point in problem.points:
            self.formula(point.name)
        heavy = self.gravity or ledger.symbols.get("g", sp.S.Zero)
        self.written = WrittenAngles(self)
        reader = MassReader(ledger, evaluator, self.point, self.span, self.written, heavy, problem)
        for body in problem.bodies:
            self.bodies[body.name] = reader.read(body)
        self.cancelling = reader.cancelling
        self.arms = Arms(self)
        self._valuations = None
        self.owners, self.fixed = self._owners(), fixed_points(problem)
        demand_caught(self)
        if displacement is not None:
            self._displace(displacement)
        for body in problem.bodies:
            if body.name in reader.placed:
                self.bodies[body.name] = reader.loaded(body, self.bodies)

    def _displace(self, displacement: Displacement) -> None:
        """Put every body, and what it carries, where its pose says."""
        for name, place in self.points.items():
            if name in displacement.spots:
                self.points[name] = displacement.spots[name]
                continue
            pose = displacement.poses.get(self.owner(name))
            if pose is not None:
                self.points[name] = pose.point(place)
        for name, body in self.bodies.items():
            pose = displacement.poses[name]
            theta = body.theta + pose.turn
            self.bodies[name] = replace(body, center=pose.point(body.center), theta=theta)
            if pose.turn != 0:
                self._turns[name] = pose.turn
        self._lengths.clear()
        self._outlines.clear()

    def turn(self, body: str) -> sp.Expr:
        """The angle by which a body has turned from where it was drawn."""
        return self._turns.get(body, sp.S.Zero)

    def surface_direction(self, surface: Surface) -> Vec:
        """The direction of a straight surface, which turns with the body that carries it."""
        assert isinstance(surface.shape, Line)
        return self.ledger.heading(self.value(surface.shape.angle) + self.turn(surface.body or GROUND))

    def _gravity(self) -> sp.Expr:
        if "g" not in self.ledger.symbols:
            self.ledger.gravity(letter=bool(self.problem.symbols))
        return self.ledger.symbols["g"] if self.problem.plane == "vertical" else sp.S.Zero

    def _implicit_points(self) -> None:
        """A particle given by coordinates, or free, is a point of its own name."""
        for body in self.problem.bodies:
            if isinstance(body.shape, Particle) and not isinstance(body.shape.place, str):
                if body.shape.place is None:
                    x, y = (self.ledger.seek(f"{axis}_{body.name}", "m") for axis in ("x", "y"))
                    self.points[body.name] = Vec(x, y)
                    self.open_places |= {x, y}
                else:
                    self._places[body.name] = Point(body.name, body.shape.place, body.mark)
                    self.formula(body.name)

    # --- places ------------------------------------------------------------------------------------------------------

    def formula(self, name: str) -> Vec:
        """The place of a point as a Vec of jets."""
        if name in self.formulas:
            return self.formulas[name]
        place = self._places.get(name)
        if place is None:
            raise refuse(self._mark(name), "PL530", f"{name} is no point with a place")
        if name in self._building:
            raise refuse(
                place.mark,
                "PL531",
                f"the place of {name} is given through itself: {' -> '.join([*self._building, name])}",
            )
        self._building.append(name)
        jets = located(place, Jets(self.evaluator, self.formula, lambda: self.valuations[0]))
        self._building.pop()
        self.formulas[name] = jets
        self.points[name] = Vec(*(self._named(getattr(jets, axis).value, f"{axis}_{name}") for axis in ("x", "y")))
        return jets

    def _named(self, value: sp.Expr, name: str) -> sp.Expr:
        """A long coordinate gets a name, unless letters must stay visible in the answer, or terms of it cancel."""
        if self.ledger.symbolic or not longer(value, WORDY) or self.rests_on_sought(value):
            return value
        if is_plain(value) or is_along_one_line(value):
            return value
        return self.ledger.define(name, value, "m", f"{name[0]} of {name[2:]}")

    def rests_on_sought(self, expr: sp.Expr) -> bool:
        """Does an expression rest on something that is sought?"""
        sought = set(self.ledger.sought)
        return any(
            s in sought or (s in self.ledger.values and self.rests_on_sought(self.ledger.values[s]))
            for s in expr.free_symbols
        )

    def _mark(self, name: str) -> Mark:
        return next((b.mark for b in self.problem.bodies if b.name == name), Mark(self.problem.file, 1, 1))

    # --- what joints and loads ask -----------------------------------------------------------------------------------

    def point(self, name: str) -> Vec:
        """The place of a point (or of a body: its mass centre)."""
        if name in self.points:
            return self.points[name]
        if name in self._places:
            self.formula(name)
            return self.points[name]
        return self.bodies[name].center

    def span(self, a: str, b: str) -> sp.Expr | None:
        """The distance of two points where the file gives it as such; None where it follows from coordinates."""
        for one, other in ((a, b), (b, a)):
            point = self._places.get(one)
            place = point.place if point is not None else None
            if isinstance(place, Polar) and place.origin == other:
                return self.value(place.distance)
            if isinstance(place, TwoFacts):
                for name, distance in place.distances:
                    if name == other:
                        return self.value(distance)
        return None

    def value(self, side: Side) -> sp.Expr:
        return self.evaluator.value(side)

    def unit(self, angle: Side) -> Vec:
        """The unit vector in a direction given by an angle."""
        return self.ledger.heading(self.value(angle))

    def length(self, v: Vec) -> sp.Expr:
        """|v|, in its simplest form when v lies along an axis."""
        if v not in self._lengths:
            self._lengths[v] = self._length(v)
        return self._lengths[v]

    def _length(self, v: Vec) -> sp.Expr:
        for one, other in ((v.x, v.y), (v.y, v.x)):
            if other == 0:
                return self.on_side(sp.sympify(one), self.sign(one) or 1)
        square = v.dot(v)
        simple = (
            trigonometric(expanded(square))
            if square.has(sp.cos, sp.sin)
            else expanded(square)
            if not square.is_number
            else square
        )
        root = sp.sqrt(factored(simple) if simple.free_symbols else simple)
        # A length along a slanting line is a difference of places, on the side where it is drawn.
        return self._sided(root)

    def _sided(self, root: sp.Expr) -> sp.Expr:
        """A root in which sizes of places are written for the side where they are drawn; of what the drawing does not
        tell, such as the time of a state, the size is left as it is.
        """
        told = [a for a in root.atoms(sp.Abs) if self.valuations[0].known(a.args[0]) is not None]
        inside = {a: self.on_side(a.args[0], self.sign(a.args[0]) or 1) for a in told}
        return root.xreplace(inside) if inside else root

    def direction(self, along: Side | str) -> Vec:
        """A direction given by an angle, a surface (its line) or a body (its angle)."""
        if isinstance(along, Name) and along.name not in self.ledger.symbols:
            along = along.name
        if not isinstance(along, str):
            return self.unit(along)
        if along in self.surfaces:
            return self.surface_direction(self.surfaces[along])
        body = self.bodies[along]
        if isinstance(body.shape, Rod) and body.shape.end is not None:
            reach = self.point(body.shape.end) - self.point(body.shape.start)
            found: Vec = reach / self.length(reach)
            return found
        return Vec(sp.cos(body.theta), sp.sin(body.theta))

    def with_relations(self, relations: tuple[Statement, ...], expr: sp.Expr, ends: tuple[str, str]) -> sp.Expr:
        """A distance of two points where relations hold: `relaxed_at: [theta = 30 deg]`."""
        found = relaxed_at(self.problem, relations)
        if found.by_places:
            return self.length(reach_of(AsDrawn(self), found, ends, relations[0].mark))
        return expr.subs({self.ledger.symbols[name]: self.value(side) for name, side in found.coordinates.items()})

    def carrier(self, partner: str) -> str:
        """The body that a partner of a joint stands for: a surface's body, or the ground."""
        surface = self.surfaces.get(partner)
        return (surface.body or GROUND) if surface is not None else partner

    def spot(self, partner: str, point: Vec, during: Span) -> Vec:
        return spot_of(self, self.problem.states, during, partner, point)

    def outline(self, partner: str, point: Vec, mark: Mark) -> Outline:
        if (partner, point) not in self._outlines:
            self._outlines[partner, point] = self.arms.outlined(outline_of(self, partner, point, mark), point)
        return self._outlines[partner, point]

    def rigid(self, body: str) -> bool:
        return body == GROUND or self.bodies[body].rigid

    def owner(self, point: str, apart_from: str = "") -> str:
        """The body that a point belongs to (another one than `apart_from`); the ground when it belongs to none."""
        owners = self.owners.get(point) or ((point,) if point in self.bodies else ())
        return next((b for b in owners if b != apart_from), GROUND)

    def center(self, body: str) -> Vec:
        """The mass centre of a body; of the ground, the origin."""
        return self.bodies[body].center if body != GROUND else Vec(sp.S.Zero, sp.S.Zero)

    def center_name(self, body: str) -> str:
        """The name of a body's mass centre in print."""
        return self.bodies[body].center_name or body

    def own_name(self, body: str) -> str:
        """The name of what a body's mass centre has alone, as an index."""
        return own_mark(self.bodies, self.points, body)

    def mass(self, body: str) -> sp.Expr:
        return self.bodies[body].mass

    def names_carrier(self, name: str) -> bool:
        """Is the name a body or a surface?"""
        return name in self.bodies or name in self.surfaces

    def pulley(self, stop: str) -> str:
        """The disk that a rope passes at a stop, named itself or by its centre; "" for a bare point."""
        if stop in self.bodies and isinstance(self.bodies[stop].shape, Round):
            return stop
        shapes = ((b, self.bodies[b].shape) for b in self.owners.get(stop, ()))
        return next((b for b, shape in shapes if isinstance(shape, Round) and shape.center == stop), "")

    def radius(self, body: str) -> sp.Expr:
        """The radius of a round body."""
        shape = self.bodies[body].shape
        return self.value(shape.radius) if isinstance(shape, Round) else sp.S.Zero

    def shape(self, body: str) -> Any:
        """The shape of a body as the file gives it."""
        return self.bodies[body].shape

    def carried(self, body: str, point: str) -> Vec:
        """The place of a point that goes with a body; what goes through it on the ground stays where it is drawn."""
        place = self.point(point)
        if body != GROUND or self.owner(point) == GROUND:
            return place
        return Vec(self.as_drawn(place.x), self.as_drawn(place.y))

    def along_plate(self, body: str, shape: Plate) -> Vec:
        """The direction of a plate's width, which turns with the body."""
        angle = (self.value(shape.angle) if shape.angle is not None else sp.S.Zero) + self.turn(body)
        return Vec(sp.cos(angle), sp.sin(angle))

    def bend(self, surface: Surface, shape: Curve, point: Vec) -> Bend:
        """A curve where a point of it is now."""
        return bend_at(self, surface, shape, carrier_pose(self, surface), point)

    def edges(self, body: str, point: Vec) -> list[Outline]:
        """The edges of a plate through a point."""
        shape = self.bodies[body].shape if body in self.bodies else None
        return edges_at(self, body, shape, point) if isinstance(shape, Plate) else []

    def contacts(self, a: str, b: str) -> int:
        """At how many points the same two partners press on each other."""
        return sum(set(getattr(j, "between", ())) == {a, b} and j.unilateral for j in self.problem.joints)

    def pressed(self, joint: str) -> int:
        """Nothing is known of it at one instant."""
        return 0

    def heaviness(self, body: str) -> sp.Expr:
        """m g of a body, also in a horizontal plane, where it presses on what it lies on."""
        return self.bodies[body].mass * self.ledger.symbols["g"]

    def root(self, square: Any) -> sp.Expr:
        plain = sp.sqrt(square)
        if not plain.free_symbols:
            return plain
        # A complete square has a root without one.
        whole = sp.sqrt(factored(expanded(sp.sympify(square))))
        rooted = any(p.exp.is_Rational and not p.exp.is_Integer for p in whole.atoms(sp.Pow))
        return self._sided(whole) if whole.has(sp.Abs) else plain if rooted else whole

    def middle(self) -> Vec:
        """The mean of all drawn points."""
        count = max(len(self.points), 1)
        return Vec(*(sp.Add(*(getattr(p, axis) for p in self.points.values())) / count for axis in ("x", "y")))

    def track(self, along: Side | str, point: Vec, mark: Mark) -> Outline:
        """What a point slides along there: a direction, a body's line, or a surface."""
        name = along if isinstance(along, str) else along.name if isinstance(along, Name) else ""
        if name in self.surfaces and not isinstance(self.surfaces[name].shape, Line):
            return self.outline(name, point, mark)
        base = self.carrier(name) if self.names_carrier(name) else GROUND
        return Outline("straight", base, self.direction(along), sp.S.Zero)

    def refuse(self, mark: Mark, code: str, message: str, hint: str = "") -> Exception:
        return refuse(mark, code, message, hint)

    # --- who owns a point --------------------------------------------------------------------------------------------

    def _owners(self) -> dict[str, list[str]]:
        owners: dict[str, list[str]] = {}
        own = {p for b in self.problem.bodies for p in (*own_points(b.shape), *b.points)}
        self.own_points = own | {b.name for b in self.problem.bodies}

        def belongs(point: str | None, body: str | None) -> None:
            if point is not None and body in self.bodies and body not in owners.setdefault(point, []):
                owners[point].append(body)

        # A point that is called like a body is that body's before it is any other's.
        for body in self.problem.bodies:
            if body.name in self.points:
                belongs(body.name, body.name)
        for body in closest_first(self.problem.bodies):
            for point in (*own_points(body.shape), *body.points):
                belongs(point, body.name)
        for point, partner in attached(self.problem):
            belongs(point, self.carrier(partner))
        return owners
