"""What v(B), omega(b), N(C), KE(all) … are at one instant: expressions in the unknowns of the motion and the pushes."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.kinematics.written_points import is_written
from planar_cli.equation.scene.growth import growth
from planar_cli.equation.scene.of_all import energy_of_load, mass_centre
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.scene.turning import counted_angle
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.jets import Jet, constant, direction_angle, magnitude, only, resolved, vector_jet
from planar_cli.equation.values.parts_of_accelerations import CORIOLIS, with_mark
from planar_cli.errors import refuse
from planar_cli.problem.language.expression import Name, Part, PointPair, Quantity, Relation
from planar_cli.problem.language.no_number import mode_misplaced
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.problem.scene.scene import ALL, GROUND
from planar_cli.records import record

LATER = {
    "path",
    "hodograph",
    "work",
    "impulse",
    "heat",
    "path_length",
    "mean",
    "count",
    "reached",
    *OF_SWINGS,
    "stable",
}

ALONG = "write `.along` or `.across`"


def _short(jet: Jet) -> Jet:
    """A rate multiplied out where that is shorter, as of an angular momentum most cancels."""
    out = expanded(jet.value)
    return Jet(out, jet.rate, jet.second) if out.count_ops() < jet.value.count_ops() else jet


def parts_of(v: Vec) -> tuple[Jet, Jet]:
    """The components of a Vec of jets."""
    return v.x, v.y


@record
class Quantities:
    """Evaluates quantities in one scene, motion and set of reactions."""

    scene: Scene
    motion: Motion
    reactions: Reactions | None
    evaluator: Evaluator

    def scalar(self, quantity: Quantity) -> Jet:
        """The quantity as a number. FileProblem when it is a vector without a part."""
        found = self.any(quantity)
        if isinstance(found, Vec):
            raise refuse(
                quantity.mark,
                "PL550",
                f"{quantity.word}(…) is a vector",
                "ask for a part: .x .y .mag .angle .along(30 deg)",
            )
        return found

    def any(self, quantity: Quantity) -> Jet | Vec:
        """The quantity with its parts: a Jet, or a Vec of jets."""
        found = self._whole(quantity)
        for part in quantity.parts:
            if not isinstance(found, Vec):
                raise refuse(part.mark, "PL551", f".{part.kind} of a number", "only a vector has parts")
            found = self.part(found, part, quantity)
        return found

    def _whole(self, q: Quantity) -> Jet | Vec:
        if q.word in LATER:
            raise refuse(
                q.mark,
                "PL590",
                f"{q.word}(…) belongs to a motion over time",
                "name its instants in `states`; at one instant ask places, velocities, accelerations and forces",
            )
        if q.word in ("dot", "ddot"):
            return self._dotted(q)
        handler: Callable[[Quantity], Jet | Vec] = getattr(self, f"_q_{q.word.lower()}")
        return handler(q)

    def _dotted(self, q: Quantity) -> Jet | Vec:
        times = 1 if q.word == "dot" else 2
        argument = q.argument
        assert argument is not None
        assert not isinstance(argument, Relation)
        found = self.any(argument) if isinstance(argument, Quantity) else self.evaluator.jet(argument)
        try:
            for _ in range(times):
                found = Vec(found.x.dotted(), found.y.dotted()) if isinstance(found, Vec) else found.dotted()
        except ValueError as error:
            raise refuse(
                q.mark,
                "PL552",
                str(error),
                "velocities and accelerations are known at an instant, their rates beyond are not",
            ) from None
        return Vec(_short(found.x), _short(found.y)) if isinstance(found, Vec) else _short(found)

    # --- places and motion -------------------------------------------------------------------------------------------

    def place(self, name: str) -> Vec:
        """r, v and a of a point (or a body's mass centre), as jets."""
        scene = self.scene
        if name == ALL:
            return mass_centre((growth(scene, self.evaluator, b)[0], self.place(b)) for b in scene.bodies)
        body = scene.owner(name) if name not in scene.bodies or name in scene.points else name
        at = scene.bodies[name].center if name in scene.bodies and name not in scene.points else scene.point(name)
        if body == GROUND or is_written(scene, self.motion, name, body):
            formula = scene.formulas.get(name)
            return formula if formula is not None else vector_jet(at, None, None)
        return vector_jet(at, self.motion.velocity(at, body), self.motion.acceleration(at, body))

    def frame_body(self, q: Quantity) -> str | None:
        """The body after the slash, None when it is a point."""
        second = q.things[1] if len(q.things) == 2 else None
        return second if second in self.scene.bodies and second not in self.scene.points else None

    def _relative(self, q: Quantity) -> Vec:
        """Place jets of the first thing less those of the second, a point."""
        found = self.place(q.things[0])
        if len(q.things) == 2 and q.things[1] != GROUND:
            found = found - self.place(q.things[1])
        return found

    def _q_r(self, q: Quantity) -> Vec:
        body = self.frame_body(q)
        if body is None:
            return self._relative(q)
        # The rates are those of the vector itself, which parts along turning directions need.
        return self.place(q.things[0]) - self.place(body)

    def _q_x(self, q: Quantity) -> Jet:
        return parts_of(self._q_r(q))[0]

    def _q_y(self, q: Quantity) -> Jet:
        return parts_of(self._q_r(q))[1]

    def seen_from(self, name: str, body: str) -> tuple[Vec, Vec]:
        """Relative velocity and acceleration of a point seen from a body: v - v', a - a' - 2 ω k × v_rel."""
        place = self.place(name)
        at = Vec(place.x.value, place.y.value)
        velocity = Vec(place.x.rate, place.y.rate) - self.motion.velocity(at, body)
        coriolis = velocity.turned() * with_mark(2 * self.motion.velocities[body].angular, CORIOLIS)
        return velocity, Vec(place.x.second, place.y.second) - self.motion.acceleration(at, body) - coriolis

    def _q_v(self, q: Quantity) -> Vec:
        body = self.frame_body(q)
        if body is not None:
            velocity, acceleration = self.seen_from(q.things[0], body)
            turning = velocity.turned() * self.motion.velocities[body].angular
            return vector_jet(velocity, acceleration + turning, None)
        jets = self._relative(q)
        return Vec(jets.x.dotted(), jets.y.dotted())

    def _q_a(self, q: Quantity) -> Vec:
        body = self.frame_body(q)
        if body is not None:
            return vector_jet(self.seen_from(q.things[0], body)[1], None, None)
        jets = self._relative(q)
        return Vec(only(jets.x.second), only(jets.y.second))

    def _q_theta(self, q: Quantity) -> Jet:
        return self._turning(q, lambda b: self.scene.bodies[b].theta if b != GROUND else sp.S.Zero)

    def _turning(self, q: Quantity, angle: Callable[[str], sp.Expr]) -> Jet:
        def one(body: str) -> Jet:
            if body not in self.motion.velocities:
                raise refuse(q.mark, "PL553", f"{body} is no body that turns")
            return Jet(angle(body), self.motion.velocities[body].angular, self.motion.accelerations[body].angular)

        found = one(q.things[0])
        return found - one(q.things[1]) if len(q.things) == 2 else found

    def _q_omega(self, q: Quantity) -> Jet:
        return self._turning(q, lambda b: sp.S.Zero).dotted()

    def _q_alpha(self, q: Quantity) -> Jet:
        return self._turning(q, lambda b: sp.S.Zero).dotted().dotted()

    def _q_coriolis(self, q: Quantity) -> Vec:
        body = self.frame_body(q)
        if body is None:
            raise refuse(q.mark, "PL554", "the Coriolis acceleration is seen from a body", "write coriolis(P/b)")
        velocity, _ = self.seen_from(q.things[0], body)
        return vector_jet(velocity.turned() * (2 * self.motion.velocities[body].angular), None, None)

    def _q_rho(self, q: Quantity) -> Jet:
        """ρ = |v|³ / |v × a|."""
        body = self.frame_body(q)
        jets = self._relative(q)
        seen = Vec(jets.x.rate, jets.y.rate), Vec(jets.x.second, jets.y.second)
        v, a = seen if body is None else self.seen_from(q.things[0], body)
        return only(v.dot(v) ** sp.Rational(3, 2) / sp.Abs(v.cross(a)))

    def _q_ic(self, q: Quantity) -> Vec:
        """r_G + k × v_G / ω; at infinity when ω is zero."""
        center = self.scene.bodies[q.things[0]].center
        omega = self.motion.velocities[q.things[0]].angular
        if omega == 0:
            return vector_jet(Vec(sp.oo, sp.oo), None, None)
        return vector_jet(center + self.motion.velocity(center, q.things[0]).turned() / omega, None, None)

    # --- mass and energy ---------------------------------------------------------------------------------------------

    def _bodies(self, q: Quantity) -> list[str]:
        return list(self.scene.bodies) if q.things[0] == ALL else [q.things[0]]

    def _q_mass(self, q: Quantity) -> Jet:
        return sum((growth(self.scene, self.evaluator, b)[0] for b in self._bodies(q)), constant(sp.S.Zero))

    def _q_i(self, q: Quantity) -> Jet:
        found = constant(sp.S.Zero)
        for name in self._bodies(q):
            body = self.scene.bodies[name]
            mass, inertia = growth(self.scene, self.evaluator, name)
            if body.pivot is not None and q.things == (name, body.pivot[0]):
                return constant(body.pivot[1])
            found = found + inertia
            if q.things != (name,):
                about = self.place(q.things[-1])
                arm = body.center - Vec(about.x.value, about.y.value)
                found = found + mass * constant(arm.dot(arm))
        return found

    def _q_ke(self, q: Quantity) -> Jet:
        """Σ m v_G²/2 + I_G ω²/2, with its rate."""
        parts, rates = [], []
        for name in self._bodies(q):
            body = self.scene.bodies[name]
            v, a = self.motion.velocity(body.center, name), self.motion.acceleration(body.center, name)
            omega, alpha = self.motion.velocities[name].angular, self.motion.accelerations[name].angular
            parts.append(body.mass * v.dot(v) / 2 + body.inertia * omega**2 / 2)
            rates.append(body.mass * v.dot(a) + body.inertia * omega * alpha)
            mass, inertia = growth(self.scene, self.evaluator, name)
            rates += [mass.rate * v.dot(v) / 2, inertia.rate * omega**2 / 2]
        return Jet(sp.Add(*parts), sp.Add(*rates), None)

    def _q_pe(self, q: Quantity) -> Jet:
        """m g y_G, from y = 0; of the whole system also what every other load has, k s²/2 of a spring."""
        name, scene = q.things[0], self.scene
        found = constant(sp.S.Zero)
        for body in self._bodies(q) if name in scene.bodies or name == ALL else ():
            mass = growth(scene, self.evaluator, body)[0]
            found = found + mass * constant(scene.gravity) * self.place(body).y
        for load in (x for x in scene.problem.loads if name in (ALL, x.name) and name not in scene.bodies):
            stored = energy_of_load(load, scene, self.reactions, self.motion.velocity)
            found = found if stored is None else found + stored
        return found

    def _q_momentum(self, q: Quantity) -> Vec:
        """Σ m v_G, with its rate."""
        parts = [self._velocity(name) * growth(self.scene, self.evaluator, name)[0] for name in self._bodies(q)]
        return sum(parts[1:], parts[0])

    def _q_h(self, q: Quantity) -> Jet:
        """Σ r_G × m v_G + I_G ω about the point, by default the mass centre; with its rate, also where it moves."""
        found = constant(sp.S.Zero)
        for name in self._bodies(q):
            mass, inertia = growth(self.scene, self.evaluator, name)
            omega, alpha = self.motion.velocities[name].angular, self.motion.accelerations[name].angular
            found = found + inertia * Jet(omega, alpha, None)
            if len(q.things) == 2:
                arm = self.place(name) - self.place(q.things[1])
                found = found + mass * arm.cross(self._velocity(name))
        return found

    def _velocity(self, body: str) -> Vec:
        center = self.scene.bodies[body].center
        return vector_jet(self.motion.velocity(center, body), self.motion.acceleration(center, body), None)

    # --- forces ------------------------------------------------------------------------------------------------------

    def _forces(self, q: Quantity) -> Reactions:
        if self.reactions is None:
            way = f"; for loads `unknowns: {{D: N}}`, `magnitude: D`, `instant: [D = …{q.word}({'/'.join(q.things)})]`"
            hint = "forces are not known before the motion is" + ("" if self.scene.problem.states else way)
            raise refuse(q.mark, "PL555", f"{q.word}(…) can not stand here", hint)
        return self.reactions

    def _q_n(self, q: Quantity) -> Jet:
        return only(self._forces(q).number(q, "normal"))

    def _q_tension(self, q: Quantity) -> Jet:
        return only(self._forces(q).number(q, "tension"))

    def _q_moment(self, q: Quantity) -> Jet:
        return only(self._forces(q).couple(q))

    def _q_friction(self, q: Quantity) -> Vec:
        return vector_jet(self._forces(q).force(q, ("friction",)), None, None)

    def _q_reaction(self, q: Quantity) -> Vec:
        return vector_jet(self._forces(q).force(q, None), None, None)

    def _q_force(self, q: Quantity) -> Vec:
        return vector_jet(self._forces(q).load(q), None, None)

    def _q_power(self, q: Quantity) -> Jet:
        return only(self._forces(q).power(q, self.motion.velocity, lambda b: self.motion.velocities[b].angular))

    def _q_mode(self, q: Quantity) -> Jet:
        raise mode_misplaced(q.mark)

    # --- parts -------------------------------------------------------------------------------------------------------

    def part(self, v: Vec, part: Part, q: Quantity) -> Jet | Vec:
        """One part of a vector."""
        match part.kind:
            case "x" | "y":
                return parts_of(v)[part.kind == "y"]
            case "mag":
                return magnitude(v)
            case "angle":
                if v.x.value == 0 and v.y.value == 0:
                    text = "the angle of a vector that is zero: it has no direction"
                    raise refuse(part.mark, "PL556", text, "ask for `.mag`")
                counted = counted_angle(self.scene, q, Vec(v.x.value, v.y.value)) if q.word == "r" else None
                found = direction_angle(v)
                return found if counted is None else Jet(counted, found.rate, found.second)
            case "along" | "across":
                return resolved(v, self.direction(part), part.kind == "along")
            case "r" | "theta":
                reach = self._q_r(Quantity("r", q.things, None, (), None, q.mark))
                if self.scene.vanishes(reach.x.value) and self.scene.vanishes(reach.y.value):
                    raise refuse(part.mark, "PL556", f".{part.kind} of what is at the centre: no direction", ALONG)
                return resolved(v, reach * (constant(1) / magnitude(reach)), part.kind == "r")
        return self._natural(v, part, q)

    def _natural(self, v: Vec, part: Part, q: Quantity) -> Jet:
        """.t along the velocity, .n towards the centre of curvature."""
        jets = self._q_v(Quantity("v", q.things, None, (), None, q.mark))
        velocity = Vec(jets.x.value, jets.y.value)
        speed = magnitude(vector_jet(velocity, None, None)).value
        if speed == 0:
            raise refuse(part.mark, "PL556", f".{part.kind} where the speed is zero", ALONG)
        value = Vec(v.x.value, v.y.value)
        if part.kind == "t":
            return only(value.dot(velocity) / speed)
        body = self.frame_body(q)
        bend = Vec(jets.x.rate, jets.y.rate) if body is None else self.seen_from(q.things[0], body)[1]
        across = velocity.cross(value)
        return only((sp.Abs(simplified(across)) if value == bend else across * sp.sign(velocity.cross(bend))) / speed)

    def direction(self, part: Part) -> Vec:
        """The unit vector of .along(…) as jets; of a body or two points it turns with them."""
        named = part.direction
        if isinstance(named, Name) and named.name in self.scene.bodies:
            at = self.scene.direction(named.name)
            return self._turning_unit(at, named.name)
        if isinstance(named, Name) and named.name in self.scene.surfaces:
            return vector_jet(self.scene.direction(named.name), None, None)
        if isinstance(named, PointPair):
            reach = self.place(named.to) - self.place(named.origin)
            return reach * (constant(1) / magnitude(reach))
        assert named is not None
        angle = self.evaluator.jet(named)
        return Vec(angle.through(sp.cos), angle.through(sp.sin))

    def _turning_unit(self, unit: Vec, body: str) -> Vec:
        omega, alpha = self.motion.velocities[body].angular, self.motion.accelerations[body].angular
        return vector_jet(unit, unit.turned() * omega, unit.turned() * alpha - unit * omega**2)


def quantities_of(scene: Scene, motion: Motion, reactions: Reactions | None) -> Quantities:
    """Quantities whose own arguments are evaluated in the same motion."""

    def scalar(quantity: Quantity) -> Jet:
        return found.scalar(quantity)

    known = scene.evaluator
    found = Quantities(scene, motion, reactions, Evaluator(scene.ledger, known.motions, scalar, known.at_state))
    return found
