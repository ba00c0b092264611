"""A stream that enters or leaves a body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.expression import Side
from planar_cli.problem.facts import Wrench
from planar_cli.problem.keys import BodyKey, Choice, Flow, FlowKey, SideKey, key
from planar_cli.problem.setting import MovingSetting


@dataclass(frozen=True, slots=True, kw_only=True)
class Stream(Load):
    """A jet or a stream of matter enters a body, leaves it, or is turned by it.

    Meaning
        Matter flows at `rate` (mass per time) into the body where it `enters` and out of it where it `leaves`: water
        turned by a vane or pipe has both, a rocket only leaves, a wagon that is loaded only enters. Each is
        `{at: point, speed: u, angle: direction}`. A mass that changes is written `mass: M - q*t`.

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
        The force on the body is rate (u_in - u_out), u_in acting at the point of entry, u_out at that of exit.

    Signs
        Angles are fixed in space; speeds are relative to the body.

    Valid when
        The flow is steady as seen from the body.

    Reference
        An Introduction to Planar Dynamics, 3.4.1, 4.6, Problem 4.45.
    """

    kind: ClassVar[str] = "stream"
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("enters",), ("leaves",), ("enters", "leaves")),
            "`enters: {at: A, speed: 15 m/s, angle: 0 deg}`, `leaves: {…}`, or both",
        ),
    )

    body: str = key(BodyKey(), "the body that the stream meets")
    rate: Side = key(SideKey("kg/s"), "mass per time")
    enters: Flow | None = key(FlowKey(), "where and how it enters: {at, speed, angle}", default=None)
    leaves: Flow | None = key(FlowKey(), "where and how it leaves: {at, speed, angle}", default=None)

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        raise scene.refuse(
            self.mark, "PL590", "a stream changes the mass over time", "replace it by the force that it causes"
        )
