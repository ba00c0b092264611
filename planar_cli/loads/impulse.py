"""An impulse: a blow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.headings import heading
from planar_cli.problem.scene.keys import BodyKey, Choice, PointKey, SideKey, key
from planar_cli.problem.scene.setting import MovingSetting, Setting
from planar_cli.problem.scene.sketches import Push, Sketch, Twist


@dataclass(frozen=True, slots=True, kw_only=True)
class Impulse(Load):
    """A blow: an impulse so short that nothing moves meanwhile.

    Meaning
        `body` gets the impulse `magnitude` at its point `at` in the direction `angle`, or the angular impulse
        `moment`, between the states of `during`; the second of them is `just after` the first. A particle needs no
        `at`. A direction that turns with a body is counted from its angle, `theta(rod) + 90 deg`. A force that acts
        for some time is a `force` with `during`.

    YAML
        title: Rod struck while hanging
        plane: vertical
        points: {A: [0, 0], B: [0, -2 m], S: [0, -1.5 m]}
        bodies: {rod: {rod: [A, B], mass: 12 kg}}
        joints:
          - pin: {at: A, between: [ground, rod]}
        loads:
          - impulse: {body: rod, at: S, magnitude: 1000 N * 0.03 s, angle: 0 deg, during: 1->2}
        states:
          1: [at rest]
          2: [just after 1]
        find: {omega: omega(rod) @ 2, kick: impulse(A).x @ 1->2}

    Equations
        m v_G2 - m v_G1 = J;  I_G (ω2 - ω1) = (S - G) × J, with the impulses of the joints.

    Signs
        Along `angle`; `moment` positive counterclockwise.

    Valid when
        Finite forces (weight, springs) do nothing in so short a time.

    Reference
        An Introduction to Planar Dynamics, 3.4.1, 3.4.2, 4.6, Example 4-13.
    """

    kind: ClassVar[str] = "impulse"
    strikes: ClassVar[bool] = True
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("magnitude", "angle"), ("at", "magnitude", "angle"), ("moment",)),
            "`at: S, magnitude: 30 N*s, angle: 0 deg`, or `moment: 3 N*m*s`",
        ),
    )

    body: str = key(BodyKey(), "the body that is struck; left out where one alone can be meant", default="")
    at: str | None = key(PointKey(), "the point that is struck; a particle needs none", default=None)
    magnitude: Side | None = key(SideKey("N*s"), "the impulse", default=None)
    angle: Side | None = key(
        SideKey("deg", angle=True, turns=True), "its direction from +x, counterclockwise", default=None
    )
    moment: Side | None = key(SideKey("N*m*s"), "an angular impulse, counterclockwise positive", default=None)

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return () if self.at is None else ((self.at, self.body),)

    def passes_through(self, names: frozenset[str]) -> str | None:
        return ""

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        point = scene.point(self.at) if self.at is not None else scene.center(self.body)
        if self.moment is not None:
            return (Twist(point, self.moment, body=self.body),)
        assert self.angle is not None
        return (Push(point, heading(scene, self.angle), self.magnitude),)

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        """None: a blow is no force."""
        return ()

    def impulses(self, scene: Setting) -> tuple[Wrench, ...]:
        point = scene.point(self.at) if self.at is not None else scene.center(self.body)
        if self.moment is not None:
            moment = scene.value(self.moment)
            return (Wrench(self.name, "impulse", self.body, point, None, moment, moment),)
        assert self.magnitude is not None
        assert self.angle is not None
        size = scene.value(self.magnitude)
        return (Wrench(self.name, "impulse", self.body, point, heading(scene, self.angle) * size, 0, size),)
