"""A stream that enters or leaves a body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Effect, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.headings import heading
from planar_cli.problem.scene.keys import BodyKey, Choice, Flow, FlowKey, MagnitudeKey, Table, key
from planar_cli.problem.scene.setting import MovingSetting, Setting
from planar_cli.problem.scene.sketches import Push, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Stream(Load):
    """A jet or a stream of matter enters a body, leaves it, or is turned by it.

    Meaning
        Matter flows at `rate` (mass per time) into the body where it `enters` and out of it where it `leaves`: water
        turned by a vane or a pipe does both, the gas of a rocket only leaves, sand that falls into a wagon only enters.
        Each is `{at: point, speed: u, angle: direction}`. The velocity is the one *seen from the body*, less that of
        the body's own point there: `speed` is its size, `angle` its direction from the fixed x axis. What is seen
        from a moving body is written with quantities: a jet of speed c that hits a wagon has `speed: c - v(wagon).x`;
        sand that falls straight down into a moving wagon comes, along the rails, from the front with
        `speed: v(wagon).x, angle: 180 deg`. Rate, speeds and angles may use `t` and quantities, the rate also a table.

        The mass of a body that a stream fills or empties is written by its own formula, `mass: M - q*t`; the stream
        does not change it. The moment of inertia goes with the mass (an `inertia` without `t` is that at t = 0).
        Where all streams on a body act `during: 1->2`, the formula is that of the times between these states; before
        and after them its mass stays what it is there. State 2 then has a time, `[t = T]`.
        Pressures at the ends of a pipe are forces of their own.

        A mass may also go with places, `x(P)`, `y(P)`, `theta(b)` or coordinates: of a chain that is lifted out of a
        heap, `mass: rho*y(end)`, with what comes up from rest, `rate: rho*v(end).y` and `enters: {at: end, speed:
        v(end).y, angle: -90 deg}`. The body then stands for the part that moves, all of it with the velocity of the
        end, and has its weight. Kinetic energy is not kept: each link is jerked into motion, and what the pull does
        beyond weight and kinetic energy is lost. What is laid down leaves the body with `speed: 0 m/s`. A mass that
        goes with places and has no stream is refused, as nothing says with what velocity it comes.

    YAML
        title: Water in a bend
        plane: horizontal
        points: {A: [0, 0], B: [0.5 m, 0.5 m]}
        bodies: {pipe: {points: [A, B]}}
        joints:
          - weld: {at: A, between: [ground, pipe]}
        loads:
          - stream:
              body: pipe
              rate: 45 kg/s
              enters: {at: A, speed: 15 m/s, angle: 0 deg}
              leaves: {at: B, speed: 15 m/s, angle: 90 deg}
        instant: [at rest]
        find: {R: reaction(A)}

    Equations
        The force on the body is rate u_in at the point of entry and -rate u_out at that of exit, so that
        m(t) a = ΣF + rate_in u_in - rate_out u_out. Where the body turns, the flow through it also needs the Coriolis
        force -2 rate ω × (r_out - r_in) at the mass centre and the couple -rate ω (r_out² - r_in²), r from the mass
        centre; and where its moment of inertia changes, the couple -(dI/dt) ω.

    Signs
        Angles are those in which the matter moves, fixed in space; speeds are relative to the body.

    Valid when
        The flow is steady as seen from the body, and the mass centre stays the same point of the body. What only
        enters stays at the mass centre, what only leaves comes from there; water that reaches a turning body from out
        of the plane enters with `speed: 0 m/s` where it does.

    Reference
        An Introduction to Planar Dynamics, 3.4.1, 4.6, Problem 4.45.
    """

    kind: ClassVar[str] = "stream"
    effect: ClassVar[Effect] = Effect("stream of matter", rank=6)
    line: ClassVar[str] = "momentum per second of {called}"
    brings_mass: ClassVar[bool] = True
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("enters",), ("leaves",), ("enters", "leaves")),
            "`enters: {at: A, speed: 15 m/s, angle: 0 deg}`, `leaves: {…}`, or both",
        ),
    )

    body: str = key(BodyKey(), "the body that the stream meets")
    rate: Side | Table = key(MagnitudeKey("kg/s"), "mass per time, or a table over time")
    enters: Flow | None = key(FlowKey(), "where and how it enters: {at, speed, angle}", default=None)
    leaves: Flow | None = key(FlowKey(), "where and how it leaves: {at, speed, angle}", default=None)

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return tuple((flow.at, self.body) for flow, _ in self._flows())

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        return tuple(
            Push(scene.point(flow.at), heading(scene, flow.angle), flow.speed, inward=sense > 0, flows=True)
            for flow, sense in self._flows()
        )

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        rate = scene.size(self.rate, self.mark)
        found: list[Wrench] = []
        for flow, sense in self._flows():
            magnitude = rate * scene.size(flow.speed, flow.mark)
            if not scene.vanishes(magnitude):
                direction = scene.heading(scene.size(flow.angle, flow.mark)) * sense
                force = direction * magnitude
                found.append(Wrench(self.name, "stream", self.body, scene.point(flow.at), force, 0, magnitude))
        return (*found, *self._through(scene, rate))

    def _flows(self) -> tuple[tuple[Flow, int], ...]:
        """The ends of the stream, with the sign with which they bring momentum."""
        return tuple((flow, sense) for flow, sense in ((self.enters, 1), (self.leaves, -1)) if flow is not None)

    def _through(self, scene: MovingSetting, rate: Any) -> tuple[Wrench, ...]:
        """What the flow from end to end of a turning body needs besides: ∫ -2 ρ ω × u dV = -2 rate ω × (r_out - r_in),
        and its moment about the mass centre; neither depends on the way between the ends.
        """
        turn, center = scene.turn(self.body), scene.center(self.body)
        if scene.vanishes(turn):
            return ()
        arms = [(scene.point(flow.at) - center, sense) for flow, sense in self._flows()]
        way = Vec(0, 0)
        for arm, sense in arms:
            way = way + arm * -sense
        found = []
        if not scene.vanishes(way.dot(way)):
            push = way.turned() * (-2 * rate * turn)
            found.append(Wrench(self.name, "stream", self.body, center, push, 0, 2 * rate * turn * scene.length(way)))
        couple = turn * rate * sum(sense * scene.length(arm) ** 2 for arm, sense in arms)
        if not scene.vanishes(couple):
            found.append(Wrench(self.name, "stream", self.body, center, None, couple, couple))
        return tuple(found)
