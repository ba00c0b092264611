"""The scene of one problem wherever its bodies are: what joints and loads ask when they state facts, as terms."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from itertools import pairwise
from typing import Any

from planar_cli.errors import Mark, refuse
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.motion.scene.carried import TINIEST, Carried
from planar_cli.motion.scene.coordinates import Coordinates, Tie
from planar_cli.motion.scene.curves import curve_at
from planar_cli.motion.scene.facing import Facings
from planar_cli.motion.scene.feet import Foot, feet_of
from planar_cli.motion.scene.gaps import Gap, gaps_of
from planar_cli.motion.scene.masses import loaded
from planar_cli.motion.scene.places import unit_vector
from planar_cli.motion.scene.poses import MovingPoses
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.scene.skids import Skids
from planar_cli.motion.scene.spots import spots_of
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.sides import names_in
from planar_cli.motion.terms.terms import ROUNDING, Term, evaluate
from planar_cli.problem.language.expression import Name, Side, Statement
from planar_cli.problem.scene.acting import acting_loads
from planar_cli.problem.scene.caught import demand_caught
from planar_cli.problem.scene.facts import Outline, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.headings import heading
from planar_cli.problem.scene.keys import Table
from planar_cli.problem.scene.masses import placed
from planar_cli.problem.scene.outlines import Bend, Span, edges_at, hub_of, outline_of, spot_of
from planar_cli.problem.scene.relaxed import reach_of, relaxed_at
from planar_cli.problem.scene.scene import GROUND, Curve, Line, Plate, Problem, Round, Surface
from planar_cli.problem.scene.shapes import drawn_by
from planar_cli.units import parse_unit


class MovingScene(Carried):
    """Geometry, bodies and constants of one problem as terms of the bodies' coordinates and rates.

    It is the `Setting` and the `MovingSetting` of joints and loads (problem/scene/setting.py): what is asked of signs
    and zeros is decided as drawn, everything else holds wherever the bodies are.
    """

    def __init__(
        self,
        problem: Problem,
        values: Mapping[str, float] | None = None,
        sides: Mapping[str, int] | None = None,
        speeds: Mapping[str, tuple[float, float, float]] | None = None,
    ) -> None:
        """`values`: numbers for letters, unknowns and coordinates, by name, in SI units. `sides`: on which side
        contacts press that the drawing leaves open, by joint (Mode.side). `speeds`: of bodies at the start, along x and
        y and of turning, where the file leaves them open.
        """
        super().__init__(problem, values)
        self._sides, self.speeds = sides or {}, speeds or {}
        self._skids: Skids | None = None
        self.facings = Facings(self.graph, self.extent)
        self.feet: dict[tuple[str, str], Foot] = feet_of(self)
        self._points |= spots_of(self, partial(outline_of, self), self.spot, self.feet, self.hub)
        self._outlines: dict[tuple[str, Vec], Outline] = {}
        self.coordinates, self.ties = self._coordinates()
        self.placed = placed(problem)
        """Bodies whose mass goes with places."""
        self._load()
        demand_caught(self)

    def _coordinates(self) -> tuple[dict[str, tuple[Term, Term]], tuple[Tie, ...]]:
        """Each coordinate of the file with its rate, and what points keep that are written with them."""
        stand_ins, rates = {}, self.rates()
        for symbol in self.problem.coordinates:
            angle = symbol.unit is not None and parse_unit(symbol.unit).angle
            value = self.reference.coordinates[symbol.name]
            stand_ins[symbol.name] = self.variable(f"q_{symbol.name}", value, 1.0 if angle else self.extent)
        found = Coordinates(self, stand_ins)
        found.run()
        for name, term in found.found.items():
            if term is stand_ins[name]:
                self.own_variables[name] = (term, self.variable(f"v_{name}", 0.0, 0.0))
                rates[term] = self.own_variables[name][1]
        coordinates = {n: (t, self.graph.rate(t, rates)) for n, t in found.found.items()}
        self.sides = self.sides.with_variables({n: t for n, (t, _) in coordinates.items()})
        return coordinates, (*found.ties, *(foot.tie for foot in self.feet.values()))

    def _load(self) -> None:
        """Give bodies the masses that go with places, now that coordinates and points are known."""
        for body in self.problem.bodies:
            if body.name in self.placed:
                mass, inertia = loaded(self._drawing, body, Quantities(self, self.stored_energy, {}).sides)
                self.places[body.name] = replace(self.places[body.name], mass=mass, inertia=inertia)

    # --- what joints and loads ask -----------------------------------------------------------------------------------

    def value_of(self, side: Side) -> Term:
        """The value of a formula that may ask for velocities too."""
        return Quantities(self, self.stored_energy, {}).sides.value(side)

    def track(self, along: Side | str, point: Vec, mark: Mark) -> Outline:
        """What a point slides along there: a direction, a body's line, or a surface."""
        name = along if isinstance(along, str) else along.name if isinstance(along, Name) else ""
        if name in self.surfaces and not isinstance(self.surfaces[name].shape, Line):
            return self.outline(name, point, mark)
        base = self.carrier(name) if self.names_carrier(name) else GROUND
        self._steady(base, () if isinstance(along, str) else (along,), mark)
        return Outline("straight", base, self.direction(along), self.graph.number(0.0))

    def drawn_by(self, body: str) -> tuple[str, ...]:
        return next((drawn_by(b) for b in self.problem.bodies if b.name == body), ())

    def spot(self, partner: str, point: Vec, during: Span) -> Vec:
        return spot_of(self, self.problem.states, during, partner, point)

    def outline(self, partner: str, point: Vec, mark: Mark) -> Outline:
        surface = self.surfaces.get(partner)
        if surface is not None and isinstance(surface.shape, Line):
            self._steady(surface.body or GROUND, (surface.shape.angle,), surface.mark)
        if (partner, point) not in self._outlines:
            self._outlines[partner, point] = outline_of(self, partner, point, mark)
        return self._outlines[partner, point]

    def are_same(self, a: Any, b: Any) -> bool:
        """Are two numbers the same as drawn? The places of a small wheel far out are rounded more than its radius."""
        one, other = self.graph.of(a), self.graph.of(b)
        return abs(one.value - other.value) <= ROUNDING * max(one.size, other.size)

    def as_drawn(self, expr: Any) -> Any:
        """Terms have their value as drawn."""
        return expr

    def shape(self, body: str) -> Any:
        """The shape of a body as the file gives it."""
        return self.drawn[body].shape

    def along_plate(self, body: str, shape: Plate) -> Vec:
        """The direction of a plate's width, which turns with the body."""
        drawn = self.sides.value(shape.angle).value if shape.angle is not None else 0.0
        return self.turned_with(body, unit_vector(self.graph, self.graph.number(drawn)))

    def bend(self, surface: Surface, shape: Curve, point: Vec) -> Bend:
        """A curve where a point of it is now."""
        return curve_at(self, surface, shape, point)

    def hub(self, body: str, point: Vec) -> Vec:
        """The centre of the rim through a point of a body, about which a cord there is wound."""
        return hub_of(self, body, point)

    def edges(self, body: str, point: Vec) -> list[Outline]:
        """The edges of a plate through a point."""
        shape = self.drawn[body].shape if body in self.drawn else None
        return edges_at(self, body, shape, point) if isinstance(shape, Plate) else []

    def pulley(self, stop: str) -> str:
        """The disk that a rope passes at a stop, named itself or by its centre; "" for a bare point."""
        names = (stop, *self.owners.get(stop, ()))
        rounds = [(n, self.drawn[n].shape) for n in names if n in self.drawn]
        return next((n for n, s in rounds if isinstance(s, Round) and stop in (n, s.center)), "")

    def radius(self, body: str) -> Term:
        """The radius of a round body."""
        shape = self.drawn[body].shape
        return self.value(shape.radius) if isinstance(shape, Round) else self.graph.number(0.0)

    def contacts(self, a: str, b: str) -> int:
        """How many contacts the same two partners have."""
        return sum(set(getattr(j, "between", ())) == {a, b} and j.unilateral for j in self.problem.joints)

    def mass(self, body: str) -> Term:
        return self.places[body].mass

    def _steady(self, base: str, angles: tuple[Side, ...], mark: Mark) -> None:
        """Refuse a direction on the ground that is written with a coordinate: its turning is nobody's."""
        moving = {s.name for s in self.problem.coordinates} | {"t"}
        if base == GROUND and any(names_in(angle) & moving for angle in angles):
            text = "the track turns as the motion goes on, and no body carries it"
            raise refuse(mark, "PL707", text, "let a body carry it: `along: b`, or `body: b` of a surface")

    def pressed(self, joint: str) -> int:
        """On which side a contact presses that the drawing leaves open; 0: not known."""
        return self._sides.get(joint, 0)

    def faced(self, joint: str) -> int:
        """What presses is known, or it is as drawn."""
        return 0

    def came_from(self, joint: str, off: Any) -> Term:
        """The side of a line on which a body was last before it came to a contact."""
        return self.facings.last_side(joint, self.graph.of(off))

    def heaviness(self, body: str) -> Term:
        """m g of a body, also in a horizontal plane, where it presses on what it lies on."""
        return self.mass(body) * self.constants.gravity(self.sides)

    def refuse(self, mark: Mark, code: str, message: str, hint: str = "") -> Exception:
        return refuse(mark, code, message, hint)

    def skids(self, layout: Layout) -> Skids:
        """What slides with friction of a fixed size: the same for all models, so that a direction is noted once."""
        if self._skids is None:
            self._skids = Skids(layout, self)
        return self._skids

    @cached_property
    def poses(self) -> MovingPoses:
        """For the residuals of joints."""
        return MovingPoses(self, self.feet)

    # --- what loads ask ----------------------------------------------------------------------------------------------

    def reach_by_letter(self, reach: Vec, ends: tuple[str, str]) -> Any:
        return self.length(reach)

    def lettered_length(self, reach: Vec, name: str, words: str) -> Any:
        return self.length(reach)

    def against(self, velocity: Vec, size: Any) -> Vec:
        """A force of a given size against a velocity; none at rest."""
        speed = self.graph.call("sqrt", velocity.dot(velocity) + TINIEST)
        return Vec(*(-part * (size / speed) for part in (velocity.x, velocity.y)))

    def heading(self, angle: Any) -> Vec:
        """The unit vector in a direction that may vary with the motion."""
        return unit_vector(self.graph, angle)

    def size(self, magnitude: Side | Table, mark: Mark) -> Term:
        """A magnitude, which may use velocities, or a table over time."""
        if not isinstance(magnitude, Table):
            return self.value_of(magnitude)
        rows = [(self.value(when).value, self.value(what).value) for when, what in magnitude.rows]
        if any(after[0] <= before[0] for before, after in pairwise(rows)):
            raise refuse(magnitude.mark, "PL592", "the instants of a table must follow each other", "sort its rows")
        return self.graph.call(self.graph.table(rows), self.time)

    def with_relations(self, relations: tuple[Statement, ...], expr: Any, ends: tuple[str, str]) -> Term:
        """A distance of two points where relations hold: `relaxed_at: [theta = 30 deg]`."""
        found = relaxed_at(self.problem, relations)
        if found.by_places:
            reach = reach_of(self, found, ends, relations[0].mark)
            return self.graph.number(math.hypot(reach.x, reach.y))
        there = {name: self.value(side).value for name, side in found.coordinates.items()}
        configuration = self.configuration({**self.reference.coordinates, **there})
        return self.graph.number(evaluate([self.graph.of(expr)], configuration)[0])

    def angle_drawn(self, body: str) -> float:
        """The angle of a rigid body as drawn, rad."""
        return float(self.drawn[body].theta.value)

    def value_at(self, side: Side) -> float:
        """What the file gives, in SI units."""
        return float(self.value(side).value)

    def heading_of(self, angle: float) -> Vec:
        """(cos, sin) of an angle in plain numbers."""
        return Vec(math.cos(angle), math.sin(angle))

    # --- loads -------------------------------------------------------------------------------------------------------

    def loads(self) -> list[Load]:
        """The weight of every body, then the loads of the file."""
        return acting_loads(self.problem)

    def stored_energy(self, name: str = "", loads: Sequence[Load] | None = None) -> Term:
        """The potential energy of the loads of a name, of all without one, J. `loads`: those that act; None: all."""
        found = self.graph.number(0.0)
        for load in (x for x in (self.loads() if loads is None else loads) if name in ("", x.name)):
            part = load.potential(self)
            found = found if part is None else found + part
        return found

    def growing(self) -> tuple[Wrench, ...]:
        """The couple -(dI/dt) ω on a body whose moment of inertia changes: d(I ω)/dt = I α + (dI/dt) ω."""
        found = []
        for name, place in self.places.items():
            change = self.graph.rate(place.inertia, self.rates())
            if not self.vanishes(change):
                couple = -change * self.turn(name)
                found.append(Wrench("", "stream", name, place.center, None, couple, couple))
        return tuple(found)

    # --- what impacts ask --------------------------------------------------------------------------------------------

    def gaps(self, joint: Joint) -> tuple[Gap, ...]:
        """Every way in which the partners of a contact or an impact may touch, with its signed distance."""
        between, normal = getattr(joint, "between", ()), getattr(joint, "normal", None)
        if len(between) != 2:
            return ()
        later = joint.during is None or not self.problem.holds_at_first(joint.during)
        at = getattr(joint, "at", "")
        owner = self.owner(at) if at else ""
        named = (self.point(at), owner) if owner in {self.carrier(p) for p in between} else None
        found = gaps_of(self, self.feet, between, None if normal is None else heading(self, normal), later, named)
        if joint.strikes and joint.during is not None and later:
            # Until then nothing keeps them on the side on which they are drawn.
            found = tuple(replace(g, free=g.line is not None) for g in found)
        other = self.pressed(joint.name) < 0
        found = tuple(g.from_other_side() if other and not g.told else g for g in found)
        return tuple(self.facings.both_sides(g, f"{joint.name}_{k}") for k, g in enumerate(found))
