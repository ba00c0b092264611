"""What v(B), omega(b), N(C), KE(all) ... are wherever the bodies are, as terms; rates are derivatives of these."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace

from planar_cli.errors import refuse
from planar_cli.motion.scene.carried import TINIEST, Carried
from planar_cli.motion.scene.places import Drawing, unit_vector
from planar_cli.motion.terms.sides import Sides
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.problem.implied.written_directions import ORIGIN
from planar_cli.problem.language.expression import Name, Part, PointPair, Quantity, Relation, Side
from planar_cli.problem.language.no_number import mode_misplaced
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.problem.scene.scene import ALL, GROUND
from planar_cli.records import record

OVER_TIME = frozenset("path hodograph work impulse heat path_length mean count reached period frequency stable".split())


@record
class Quantities:
    """Quantities of one scene."""

    scene: Carried
    stored: Callable[[str], Term]
    """The potential energy of the loads of a name, of all of them for "" [J]."""
    accelerations: Mapping[Term, Term]
    """The second derivative behind each rate of the state; empty where they are not known yet."""
    reactions: Reactions | None = None
    """What joints and loads do; None where it is not known yet."""
    elsewhere: Callable[[str, Side], Term | Vec] | None = None
    """What stands before `@ state`; None: nothing may."""

    @property
    def sides(self) -> Sides:
        """Formulas in which these quantities may stand."""
        sides = self.scene.sides
        return Sides(sides.graph, sides.constants, sides.variables, self.scalar, self.elsewhere or sides.elsewhere)

    def scalar(self, q: Quantity) -> Term:
        """The quantity as a number. FileProblem when it is a vector without a part."""
        found = self.any(q)
        if isinstance(found, Vec):
            hint = "ask for a part: .x .y .mag .angle .along(30 deg)"
            raise refuse(q.mark, "PL550", f"{q.word}(…) is a vector", hint)
        return found

    def any(self, q: Quantity) -> Term | Vec:
        """The quantity with its parts: a number or a vector."""
        if q.word in OVER_TIME:
            hint = "at one instant ask places, velocities, accelerations and forces"
            raise refuse(q.mark, "PL590", f"{q.word}(…) belongs to a motion over time", hint)
        if q.at is not None:
            assert isinstance(q.at, str)
            bare = replace(q, at=None)
            return self.sides.at(q.at, bare) if self.elsewhere is None else self.elsewhere(q.at, bare)
        found: Term | Vec = _ASKED[q.word](self, q)
        for part in q.parts:
            if not isinstance(found, Vec):
                raise refuse(part.mark, "PL551", f".{part.kind} of a number", "only a vector has parts")
            found = self.part(found, part, q)
        return found

    # --- rates -------------------------------------------------------------------------------------------------------

    def rate(self, of: Term) -> Term:
        """The time derivative."""
        return self.scene.graph.rate(of, {**self.scene.rates(), **self.accelerations})

    def followed(self, of: Term) -> bool:
        """Is its rate a formula too: do places, velocities and the time tell it, without accelerations and forces?"""
        known = {self.scene.time, *self.scene.rates(), *self.accelerations}
        return all(t in known for t in ordered([of]) if t.op == "variable")

    def _rate(self, of: Vec) -> Vec:
        return Vec(self.rate(of.x), self.rate(of.y))

    def dotted(self, q: Quantity) -> Term | Vec:
        """dot(…) and ddot(…)."""
        argument = q.argument
        assert argument is not None
        assert not isinstance(argument, Relation)
        found = self.any(argument) if isinstance(argument, Quantity) else self.sides.value(argument)
        for _ in range(1 if q.word == "dot" else 2):
            parts = (found.x, found.y) if isinstance(found, Vec) else (found,)
            if self.accelerations and not all(self.followed(p) for p in parts):
                hint = "velocities and accelerations are known at an instant, their rates beyond are not"
                raise refuse(q.mark, "PL552", "the rate of a force or an acceleration is not known", hint)
            found = self._rate(found) if isinstance(found, Vec) else self.rate(found)
        return found

    # --- motion ------------------------------------------------------------------------------------------------------

    def point(self, name: str) -> Vec:
        """The place of a point or of a body; of `all`, of the mass centre Σ m r / Σ m."""
        if name != ALL:
            return self.scene.point(name)
        graph, heavy = self.scene.graph, [p for p in self.scene.places.values() if not self.scene.vanishes(p.mass)]
        total = graph.number(0.0)
        for place in heavy:
            total = total + place.mass
        parts = [place.center * (place.mass / total) for place in heavy]
        return sum(parts[1:], parts[0])

    def carrier(self, name: str) -> str:
        """The body with which a point goes."""
        scene = self.scene
        if name == ALL:
            return GROUND
        return name if name in scene.places and name not in scene.owners else scene.owner(name)

    def velocity(self, name: str) -> Vec:
        """Of the body's material point that is now there; of a point of no body, the rate of its place."""
        place, body = self.point(name), self.carrier(name)
        return self._rate(place) if body == GROUND else self.scene.velocity(place, body)

    def acceleration(self, name: str) -> Vec:
        """The same."""
        place, body = self.point(name), self.carrier(name)
        return self._rate(self._rate(place)) if body == GROUND else self.of_body(place, body)

    def of_body(self, point: Vec, body: str) -> Vec:
        """The acceleration of a body's material point: a_G + α k × r - ω² r."""
        scene = self.scene
        if body == GROUND:
            return scene.center(GROUND)
        linear = self._rate(scene.places[body].velocity)
        omega = scene.turn(body)
        arm = scene.arm(body, point)
        found: Vec = linear + arm.turned() * self.rate(omega) - arm * (omega * omega)
        return found

    def frame(self, q: Quantity) -> str | None:
        """The body after the slash, None when it is a point."""
        second = q.things[1] if len(q.things) == 2 else ""
        return second if second in self.scene.places and second not in self.scene.owners else None

    def less(self, q: Quantity, of: Callable[[str], Vec]) -> Vec:
        """That of the first thing less that of the second, a point."""
        if len(q.things) == 1 or q.things[1] == GROUND:
            return of(q.things[0])
        return of(q.things[0]) - of(q.things[1])

    def place(self, q: Quantity) -> Vec:
        """r(P), r(B/A), r(P/b)."""
        return self.less(q, self.point)

    def speed(self, q: Quantity) -> Vec:
        """v(P), v(B/A), and as seen from a body v - v'."""
        body = self.frame(q)
        if body is None:
            return self.less(q, self.velocity)
        return self.velocity(q.things[0]) - self.scene.velocity(self.point(q.things[0]), body)

    def coriolis(self, q: Quantity) -> Vec:
        """2 ω k × v_rel."""
        body = self.frame(q)
        if body is None:
            text = "the Coriolis acceleration is seen from a body"
            raise refuse(q.mark, "PL554", text, "write coriolis(P/b)")
        return self.speed(q).turned() * (self.scene.turn(body) * 2)

    def gain(self, q: Quantity) -> Vec:
        """a(P), a(B/A), and as seen from a body a - a' - 2 ω k × v_rel."""
        body = self.frame(q)
        if body is None:
            return self.less(q, self.acceleration)
        own = self.of_body(self.point(q.things[0]), body)
        return self.acceleration(q.things[0]) - own - self.coriolis(q)

    def turning(self, q: Quantity, of: Callable[[str], Term]) -> Term:
        """That of the first body less that of the second."""
        for name in q.things:
            if name != GROUND and (name not in self.scene.places or self.scene.places[name].theta is None):
                raise refuse(q.mark, "PL553", f"{name} is no body that turns")
        found = of(q.things[0])
        return found - of(q.things[1]) if len(q.things) == 2 else found

    def theta(self, body: str) -> Term:
        """The angle of a body."""
        place = self.scene.places.get(body)
        return self.scene.graph.number(0.0) if place is None or place.theta is None else place.theta

    def radius_of_curvature(self, q: Quantity) -> Term:
        """ρ = |v|³ / |v × a|."""
        v, a = self.speed(q), self.gain(q)
        speed = self.magnitude(v)
        return speed * speed * speed / self.scene.graph.call("abs", v.cross(a))

    def centre_of_rotation(self, q: Quantity) -> Vec:
        """r_G + k × v_G / ω."""
        place = self.scene.places[q.things[0]]
        found: Vec = place.center + place.velocity.turned() / self.scene.turn(q.things[0])
        return found

    # --- mass and energy ---------------------------------------------------------------------------------------------

    def total(self, q: Quantity, of: Callable[[str], Term]) -> Term:
        """The sum over the bodies that are meant."""
        names = list(self.scene.places) if q.things[0] == ALL else [q.things[0]]
        found = self.scene.graph.number(0.0)
        for name in names:
            found = found + of(name)
        return found

    def inertia(self, q: Quantity) -> Term:
        """I(b), I(b/P)."""

        def of(name: str) -> Term:
            place = self.scene.places[name]
            if q.things == (name,):
                return place.inertia
            arm = place.center - self.point(q.things[-1])
            return place.inertia + self.scene.graph.of(place.mass * arm.dot(arm))

        return self.total(q, of)

    def kinetic(self, name: str) -> Term:
        """m v_G²/2 + I_G ω²/2."""
        place, omega = self.scene.places[name], self.scene.turn(name)
        v = place.velocity
        return (place.mass * self.scene.graph.of(v.dot(v)) + place.inertia * omega * omega) * 0.5

    def potential(self, q: Quantity) -> Term:
        """m g y_G, from y = 0; of the whole system all that the loads tell."""
        name = q.things[0]
        if name in self.scene.places:
            place = self.scene.places[name]
            return place.mass * self.scene.gravity * place.y
        return self.stored("" if name == ALL else name)

    def momentum(self, q: Quantity) -> Vec:
        """Σ m v_G."""
        places = self.scene.places
        x = self.total(q, lambda name: places[name].mass * places[name].vx)
        return Vec(x, self.total(q, lambda name: places[name].mass * places[name].vy))

    def spin(self, q: Quantity) -> Term:
        """Σ r_G × m v_G + I_G ω about the point, by default the mass centre."""

        def of(name: str) -> Term:
            place = self.scene.places[name]
            own = place.inertia * self.scene.turn(name)
            if len(q.things) == 1:
                return own
            arm = place.center - self.scene.point(q.things[1])
            return self.scene.graph.of(arm.cross(place.velocity)) * place.mass + own

        return self.total(q, of)

    # --- forces ------------------------------------------------------------------------------------------------------

    def forces(self, q: Quantity) -> Reactions:
        """What joints and loads do."""
        if self.reactions is None:
            text = "forces are not known before the motion is"
            raise refuse(q.mark, "PL555", f"{q.word}(…) can not stand here", text)
        return self.reactions

    # --- parts -------------------------------------------------------------------------------------------------------

    def magnitude(self, v: Vec) -> Term:
        """|v|."""
        return self.scene.graph.call("sqrt", v.dot(v) + TINIEST)

    def part(self, v: Vec, part: Part, q: Quantity) -> Term:
        """A part of a vector that stands behind this quantity."""
        graph = self.scene.graph
        match part.kind:
            case "x" | "y":
                return graph.of(getattr(v, part.kind))
            case "mag":
                return self.magnitude(v)
            case "angle":
                # The direction of a place counts its turns.
                x, y = graph.of(v.x), graph.of(v.y)
                return self._direction_of_place(q, y, x) if q.word == "r" else graph.call("atan2", y, x)
            case "along" | "r":
                return graph.of(v.dot(self._direction(part, q)))
            case "across" | "theta":
                return graph.of(self._direction(part, q).cross(v))
        return self._natural(v, part, q)

    def _direction_of_place(self, q: Quantity, y: Term, x: Term) -> Term:
        """The angle of (x, y) with its turns from the written one, counted once for all that ask for it."""
        graph, inside = self.scene.graph, (y, x, self.scene.time)
        written = self.written_direction(q, Vec(x, y))
        if written is not None and not written.constant:
            # Wherever it is, the written angle tells the turns, and the place itself what it is off by.
            along = unit_vector(graph, written)
            return written + graph.call("atan2", graph.of(along.cross(Vec(x, y))), graph.of(along.dot(Vec(x, y))))
        near = 0.0 if written is None else written.value
        for name, term in graph.turned.items():
            if term.args == inside and abs(graph.turnings[name].start - near) <= math.pi:
                return term
        return graph.turning(y, x, 0.0, self.scene.time, near)

    def written_direction(self, q: Quantity, place: Vec) -> Term | None:
        """The angle with which the file writes the direction of r(…), which is this vector; None: it writes none."""
        origin = q.things[1] if len(q.things) == 2 and q.things[1] != GROUND else ORIGIN
        drawing = Drawing(self.scene.problem, self.scene.sides, self.scene.free)
        return drawing.written_direction(origin, q.things[0], place)

    def _natural(self, v: Vec, part: Part, q: Quantity) -> Term:
        """.t along the velocity, .n towards the centre of curvature."""
        graph, velocity = self.scene.graph, self.speed(q)
        tangent = velocity / self.magnitude(velocity)
        if part.kind == "t":
            return graph.of(v.dot(tangent))
        return graph.of(tangent.cross(v)) * graph.call("sign", velocity.cross(self.gain(q)))

    def _direction(self, part: Part, q: Quantity) -> Vec:
        """The unit vector of .along(…) and .across(…); of .r and .theta that of the same bracket."""
        named = part.direction
        if named is None or isinstance(named, PointPair):
            reach = self.place(q) if named is None else self.scene.point(named.to) - self.scene.point(named.origin)
            unit: Vec = reach / self.magnitude(reach)
            return unit
        if isinstance(named, Name) and self.scene.names_carrier(named.name):
            return self.scene.direction(named.name)
        return unit_vector(self.scene.graph, self.sides.value(named))


def _no_mode(asked: Quantities, q: Quantity) -> Term:
    raise mode_misplaced(q.mark)


_ASKED: dict[str, Callable[[Quantities, Quantity], Term | Vec]] = {
    "dot": Quantities.dotted,
    "ddot": Quantities.dotted,
    "r": Quantities.place,
    "x": lambda s, q: s.place(q).x,
    "y": lambda s, q: s.place(q).y,
    "v": Quantities.speed,
    "a": Quantities.gain,
    "coriolis": Quantities.coriolis,
    "theta": lambda s, q: s.turning(q, s.theta),
    "omega": lambda s, q: s.turning(q, s.scene.turn),
    "alpha": lambda s, q: s.rate(s.turning(q, s.scene.turn)),
    "rho": Quantities.radius_of_curvature,
    "IC": Quantities.centre_of_rotation,
    "mass": lambda s, q: s.total(q, lambda name: s.scene.places[name].mass),
    "I": Quantities.inertia,
    "KE": lambda s, q: s.total(q, s.kinetic),
    "PE": Quantities.potential,
    "momentum": Quantities.momentum,
    "H": Quantities.spin,
    "N": lambda s, q: s.scene.graph.of(s.forces(q).number(q, "normal")),
    "tension": lambda s, q: s.scene.graph.of(s.forces(q).number(q, "tension")),
    "moment": lambda s, q: s.scene.graph.of(s.forces(q).couple(q)),
    "friction": lambda s, q: s.forces(q).force(q, ("friction",)),
    "reaction": lambda s, q: s.forces(q).force(q, None),
    "force": lambda s, q: s.forces(q).load(q),
    "power": lambda s, q: s.scene.graph.of(s.forces(q).power(q, s.scene.velocity, s.scene.turn)),
    "mode": _no_mode,
}
"""How each quantity of an instant is found, by its word."""
