"""The spring."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.loads.base import Load, mode_key
from planar_cli.problem.language.expression import Side, Statement
from planar_cli.problem.scene.facts import Effect, Facts, Mode, Test, Wrench
from planar_cli.problem.scene.fixed_ends import fixed_ends
from planar_cli.problem.scene.keys import Choice, PointPairKey, SideKey, StatementsKey, WordKey, key
from planar_cli.problem.scene.setting import MovingSetting, Setting
from planar_cli.problem.scene.sketches import Sketch, Spiral


@dataclass(frozen=True, slots=True, kw_only=True)
class Spring(Load):
    """A linear spring between two points.

    Meaning
        A light spring joins two points, of bodies or fixed. Its natural length is `natural_length`, or the distance
        of its ends where the relations of `relaxed_at` hold. `acts: push` or `acts: pull` where it is not fastened and
        acts one way only: a buffer that pushes only while it is compressed, a cord that pulls only while it is
        stretched. In a motion it may begin and cease to act on the way.

    YAML
        title: Block on a spring
        plane: horizontal
        points: {O: [0, 0], P: [0.5 m, 0]}
        bodies: {block: {particle: P, mass: 2 kg}}
        joints:
          - guide: {point: P, along: 0 deg}
        loads:
          - spring: {between: [O, P], stiffness: 200 N/m, natural_length: 0.3 m}
        instant: [at rest]
        find: {a: a(block).x}

    Equations
        F = k (l - l0) along the line of its ends; potential energy k (l - l0)²/2.

    Signs
        Stretched it pulls. `tension(j)` > 0 pulls.

    Valid when
        The spring is light and linear.

    Reference
        An Introduction to Planar Dynamics, 3.5.3.
    """

    kind: ClassVar[str] = "spring"
    effect: ClassVar[Effect] = Effect("spring force", "springs", rank=4)
    line: ClassVar[str] = "pull of {called}"
    pushing: ClassVar[str] = "push of {called}"
    quantities: ClassVar[tuple[str, ...]] = ("tension",)
    pulls: ClassVar[bool] = True
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("natural_length",), ("relaxed_at",)),
            "`natural_length: 0.3 m`, or `relaxed_at: [theta = 0]`, where it is relaxed",
        ),
    )

    between: tuple[str, str] = key(PointPairKey(), "the two points it joins")
    stiffness: Side = key(SideKey("N/m"), "its stiffness")
    natural_length: Side | None = key(SideKey("m"), "its length when relaxed", default=None)
    relaxed_at: tuple[Statement, ...] | None = key(
        StatementsKey(), "relations of the place where it is relaxed", default=None
    )
    acts: str | None = key(WordKey(("push", "pull")), "where it only pushes or only pulls", default=None)

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        start, end = (scene.point(p) for p in self.between)
        pushes = self.acts == "push" and self.natural_length is not None
        free = scene.value(self.natural_length) if pushes and self.natural_length is not None else None
        return (Spiral(start, end, fixed_ends(scene, *self.between), free, self.stiffness),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        if self.acts is None:
            return ()
        key, sense = mode_key(self.name), 1 if self.acts == "pull" else -1
        start, end = (scene.point(p) for p in self.between)
        stretch = self._stretch(scene, scene.length(end - start)) * sense
        state = "stretched" if sense > 0 else "compressed"
        engaged = Test(key, f"{self.called} is {state}", constant=stretch)
        free = Test(key, f"{self.called} is not {state}", constant=-stretch)
        acts = "pulls" if sense > 0 else "pushes"
        return (
            Mode("", f"{self.called} {acts}", Facts(), (engaged,)),
            Mode("", f"{self.called} is free", Facts(idle=(key,)), (free,)),
        )

    def _stretch(self, scene: Any, length: Any) -> Any:
        """How much longer it is than when relaxed."""
        if self.natural_length is not None:
            return length - scene.value(self.natural_length)
        return length - scene.with_relations(self.relaxed_at or (), length, self.between)

    def passes_through(self, names: frozenset[str]) -> str | None:
        return next((end for end in self.between if end not in names), None)

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        start, end = (scene.point(p) for p in self.between)
        length = scene.length(end - start)
        stretch = self._stretch(scene, length)
        if scene.vanishes(stretch):
            return ()
        if scene.vanishes(length):
            raise scene.refuse(self.mark, "PL541", f"the ends of {self.name} coincide: the spring has no direction")
        told = scene.lettered_length(end - start, f"l_{self.name}" if self.name else "l_s", self.called)
        stiffness, longer = scene.value(self.stiffness), self._stretch(scene, told)
        # What only pushes counts how much shorter it is: k (l0 - l) stands on the page, the size of its push.
        tension = -(stiffness * -longer) if self.acts == "push" else stiffness * longer
        along = (end - start) / length
        ends = ((self.between[0], start, along), (self.between[1], end, -along))
        return tuple(Wrench(self.name, "spring", scene.owner(p), at, d * tension, 0, tension) for p, at, d in ends)

    def stored(self, scene: Setting) -> tuple[Any, Any, int, str]:
        """k s²/2, s its stretch."""
        start, end = (scene.point(p) for p in self.between)
        return scene.value(self.stiffness), self._stretch(scene, scene.length(end - start)), 2, "s"
