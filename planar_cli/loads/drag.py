"""Drag."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import ClassVar, Self

from planar_cli.errors import Mark
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Binary, Number, Part, Quantity, Side
from planar_cli.problem.scene.facts import Effect, Wrench
from planar_cli.problem.scene.keys import BodyKey, Choice, MagnitudeKey, SideKey, Table, key
from planar_cli.problem.scene.setting import MovingSetting


@dataclass(frozen=True, slots=True, kw_only=True)
class Drag(Load):
    """The resistance of air or water, always against the velocity.

    Meaning
        The force acts at the mass centre of `body` against its velocity; the magnitude may use quantities, such as
        `c*v(b).mag^2`. `quadratic: c` stands for just this, and `linear: c` for c v; both together are added.

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
        The body moves; at rest there is no drag. One that does not vanish with the speed stops the body: it stays
        there if nothing else acts, and turns round if what acts is more than the drag.

    Reference
        An Introduction to Planar Dynamics, 1.3.1, 3.1.2.
    """

    kind: ClassVar[str] = "drag"
    effect: ClassVar[Effect] = Effect("drag", "drag", rank=3)
    line: ClassVar[str] = "drag on {}"
    opposes: ClassVar[bool] = True
    dissipates: ClassVar[bool] = True
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("magnitude",), ("linear",), ("quadratic",), ("linear", "quadratic")),
            "`magnitude: c*v(b).mag^2`, or `quadratic: c` for the same, or `linear: c` for c v",
        ),
    )

    body: str = key(BodyKey(), "the body that is braked; left out where one alone can be meant", default="")
    magnitude: Side | Table | None = key(MagnitudeKey("N"), "its magnitude, such as `c*v(b).mag^2`", default=None)
    linear: Side | None = key(SideKey("N*s/m"), "c of a magnitude c v", default=None)
    quadratic: Side | None = key(SideKey("kg/m"), "c of a magnitude c v^2", default=None)

    def in_full(self) -> Self:
        """With the magnitude of `linear` and `quadratic` as it would be written out."""
        found = self.magnitude
        for power, side in ((1, self.linear), (2, self.quadratic)):
            if side is not None:
                term = Binary("*", side, self._speed(power, side.mark), side.mark)
                found = term if found is None or isinstance(found, Table) else Binary("+", found, term, side.mark)
        return replace(self, magnitude=found)

    def _speed(self, power: int, mark: Mark) -> Side:
        speed = Quantity("v", (self.body,), None, (Part("mag", None, mark),), None, mark)
        return speed if power == 1 else Binary("^", speed, Number(Fraction(power), None, 1, mark), mark)

    @property
    def derived(self) -> frozenset[str]:
        short = self.linear is not None or self.quadratic is not None
        return frozenset(("magnitude",)) if short else frozenset()

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        center = scene.center(self.body)
        velocity = scene.velocity(center, self.body)
        if scene.vanishes(velocity.dot(velocity)):
            return ()
        assert self.magnitude is not None
        magnitude = scene.size(self.magnitude, self.mark)
        return (Wrench(self.name, "drag", self.body, center, scene.against(velocity, magnitude), 0, magnitude),)
