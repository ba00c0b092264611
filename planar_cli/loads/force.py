"""A force."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Effect, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import BodyKey, Choice, MagnitudeKey, PointKey, SideKey, Table, key
from planar_cli.problem.scene.setting import MovingSetting, Setting
from planar_cli.problem.scene.sketches import Push, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Force(Load):
    """A force acts on a body at a point.

    Meaning
        `body` is pushed or pulled at its point `at`, which moves with it (a particle needs no `at`). With `wound_at: T`
        the force is that of a cord wound on the body, which leaves it at the rim point T and unwinds: T stays where it
        is in the drawing's direction while the body turns. The direction is `angle` (fixed in space), or `towards` a
        point, or `angle` with `relative_to: b`, then it turns with the body b. The magnitude may use `t` and
        quantities, or be a table of instants and values.

    YAML
        title: Crate pushed on a smooth floor
        plane: vertical
        points: {C: [0, 0]}
        surfaces: {floor: {through: C, angle: 0 deg}}
        bodies: {crate: {particle: C, mass: 20 kg}}
        joints:
          - contact: {between: [crate, floor], at: C, mu: 0}
        loads:
          - force: {body: crate, at: C, magnitude: 50 N + 10 N/s * t, angle: 30 deg}
        states:
          1: [t = 0, at rest]
          2: [t = 3 s]
        find: {v: v(crate).x @ 2}

    Equations
        The wrench F at the point; power F · v of the point (of the rim, where a cord unwinds).

    Signs
        The magnitude is along the direction given; a negative one points the other way.

    Valid when
        The force is known, or its magnitude or angle is an unknown of the file.

    Reference
        An Introduction to Planar Dynamics, 3.1.2, 4.3.
    """

    kind: ClassVar[str] = "force"
    effect: ClassVar[Effect] = Effect("applied force", rank=1)
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(((), ("at",), ("wound_at",)), "`at: P`, or `wound_at: T` for a cord that unwinds, not both"),
        Choice(
            (("angle",), ("towards",), ("angle", "relative_to")),
            "`angle: 30 deg`, or `towards: P`, or `angle: 30 deg, relative_to: b`",
        ),
    )

    body: str = key(BodyKey(), "the body it acts on; left out where one alone can be meant", default="")
    at: str | None = key(PointKey(), "the point of the body where it acts; a particle needs none", default=None)
    wound_at: str | None = key(PointKey(), "the rim point where a cord leaves the body and unwinds", default=None)
    magnitude: Side | Table = key(MagnitudeKey("N"), "its magnitude, or a table over time")
    angle: Side | None = key(SideKey("deg", angle=True), "its direction from +x, counterclockwise", default=None)
    towards: str | None = key(PointKey(), "the point that it is directed to", default=None)
    relative_to: str | None = key(BodyKey(), "the body that its direction turns with", default=None)

    @property
    def beside(self) -> str:
        """By its body, or its point, where it has no name of its own."""
        places = {self.wound_at: "force at", self.at: "force at", self.body: "force on"}
        return f"{places[self.name]} {self.name}" if self.name in places else self.by_line(self.line)

    def attachments(self) -> tuple[tuple[str, str], ...]:
        point = self.at or self.wound_at
        return () if point is None else ((point, self.body),)

    def rims(self) -> tuple[tuple[str, str], ...]:
        return () if self.wound_at is None else ((self.wound_at, self.body),)

    def passes_through(self, names: frozenset[str]) -> str | None:
        return self.towards

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        point = self._place(scene)
        return (Push(point, self._direction(scene, point), self.magnitude, unwinds=self.wound_at is not None),)

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        point = self._place(scene)
        magnitude = scene.size(self.magnitude, self.mark)
        return (Wrench(self.name, "force", self.body, point, self._direction(scene, point) * magnitude, 0, magnitude),)

    def _place(self, scene: Setting) -> Vec:
        name = self.at or self.wound_at
        return scene.point(name) if name is not None else scene.center(self.body)

    def _direction(self, scene: Setting, point: Vec) -> Vec:
        if self.towards is not None:
            reach = scene.point(self.towards) - point
            if scene.vanishes(reach.dot(reach)):
                text = f"{self.name} acts at {self.towards} and points to it: it has no direction"
                raise scene.refuse(self.mark, "PL541", text, "name another point, or write `angle: 30 deg`")
            found: Vec = reach / scene.length(reach)
            return found
        if self.angle is None:
            raise scene.refuse(
                self.mark, "PL540", f"the direction of {self.name} is missing", "write `angle: 30 deg` or `towards: P`"
            )
        if self.relative_to is not None:
            along = scene.direction(self.relative_to)
            turn = scene.unit(self.angle)
            turned: Vec = along * turn.x + along.turned() * turn.y
            return turned
        return scene.unit(self.angle)
