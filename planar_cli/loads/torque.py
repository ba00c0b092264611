"""A couple."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Effect, Wrench
from planar_cli.problem.scene.keys import BodyKey, Choice, MagnitudeKey, PartnersKey, Table, key
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import MovingSetting, Setting
from planar_cli.problem.scene.sketches import Sketch, Twist


@dataclass(frozen=True, slots=True, kw_only=True)
class Torque(Load):
    """A couple turns a body.

    Meaning
        The moment acts on `body`; or, with `between: [a, b]`, on b, and reversed on a (a motor, a brake).

    YAML
        title: Disk started by a motor
        plane: vertical
        points: {O: [0, 0]}
        bodies: {disk: {disk: O, radius: 0.2 m, mass: 15 kg}}
        joints:
          - pin: {at: O, between: [ground, disk]}
        loads:
          - torque: {body: disk, moment: 40 N*m}
        states:
          1: [t = 0, at rest]
          2: [t = 2 s]
        find: {omega: omega(disk) @ 2}

    Equations
        The moment M enters the sum of moments about any point; power M ω (of b relative to a).

    Signs
        Positive counterclockwise; `40 N*m cw` is -40 N*m.

    Valid when
        Always.

    Reference
        An Introduction to Planar Dynamics, 4.2.2, 4.5.2.
    """

    kind: ClassVar[str] = "torque"
    effect: ClassVar[Effect] = Effect("applied torque", rank=2)
    line: ClassVar[str] = "torque {}"
    letter: ClassVar[str] = "M"
    turns_only: ClassVar[bool] = True
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(((), ("body",), ("between",)), "`body: b`, or `between: [a, b]`: on b, reversed on a"),
    )

    body: str | None = key(BodyKey(), "the body it turns; left out where one alone can be meant", default=None)
    between: tuple[str, ...] | None = key(PartnersKey(), "on the second body, reversed on the first", default=None)
    moment: Side | Table = key(MagnitudeKey("N*m"), "the moment, counterclockwise positive, or a table over time")

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        first, second = (GROUND, self.body) if self.body is not None else self.between or (GROUND, GROUND)
        both = ((second, False), (first, True))
        return tuple(Twist(scene.center(b), self.moment, against, b) for b, against in both if b != GROUND)

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        moment = scene.size(self.moment, self.mark)
        if self.body is not None:
            return (Wrench(self.name, "torque", self.body, scene.center(self.body), None, moment, moment),)
        first, second = self.between or ("ground", "ground")
        pairs = ((second, moment), (first, -moment))
        return tuple(Wrench(self.name, "torque", b, scene.center(b), None, m, m) for b, m in pairs)
