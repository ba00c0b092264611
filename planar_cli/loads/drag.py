"""Drag."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.expression import Side
from planar_cli.problem.facts import Effect, Wrench
from planar_cli.problem.keys import BodyKey, MagnitudeKey, Table, key
from planar_cli.problem.setting import MovingSetting


@dataclass(frozen=True, slots=True, kw_only=True)
class Drag(Load):
    """The resistance of air or water, always against the velocity.

    Meaning
        The force acts at the mass centre of `body` against its velocity; the magnitude may use quantities, such as
        `c*v(b).mag^2`.

    YAML
        title: Skydiver
        plane: vertical
        given: {c: 0.25 kg/m}
        bodies: {man: {particle: [0, 0], mass: 80 kg}}
        loads:
          - drag: {body: man, magnitude: c*v(man).mag^2}
        instant: [v(man).x = 0, v(man).y = -20 m/s]
        find: {a: a(man).y}

    Equations
        F = -D v/|v|.

    Signs
        The magnitude is positive.

    Valid when
        The body moves; at rest there is no drag.

    Reference
        An Introduction to Planar Dynamics, 1.3.1, 3.1.2.
    """

    kind: ClassVar[str] = "drag"
    effect: ClassVar[Effect] = Effect("drag", "drag", rank=3)
    line: ClassVar[str] = "drag on {}"
    opposes: ClassVar[bool] = True
    dissipates: ClassVar[bool] = True

    body: str = key(BodyKey(), "the body that is braked")
    magnitude: Side | Table = key(MagnitudeKey("N"), "its magnitude, such as `c*v(b).mag^2`")

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        center = scene.center(self.body)
        velocity = scene.velocity(center, self.body)
        if scene.vanishes(velocity.dot(velocity)):
            return ()
        magnitude = scene.size(self.magnitude, self.mark)
        return (Wrench(self.name, "drag", self.body, center, scene.against(velocity, magnitude), 0, magnitude),)
