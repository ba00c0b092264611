"""The viscous damper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Effect, Wrench
from planar_cli.problem.scene.fixed_ends import fixed_ends
from planar_cli.problem.scene.keys import PointPairKey, SideKey, key
from planar_cli.problem.scene.setting import MovingSetting, Setting
from planar_cli.problem.scene.sketches import Absorber, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Damper(Load):
    """A viscous damper between two points.

    Meaning
        A light dashpot joins two points and resists the change of their distance in proportion to its rate.

    YAML
        title: Block braked by a damper
        plane: horizontal
        points: {O: [0, 0], P: [0.5 m, 0]}
        bodies: {block: {particle: P, mass: 2 kg}}
        joints:
          - guide: {point: P, along: 0 deg}
        loads:
          - damper: {between: [O, P], coefficient: 20 N*s/m}
        instant: [v(P).x = 3 m/s]
        find: {a: a(block).x}

    Equations
        F = c dl/dt along the line of its ends; power -c (dl/dt)².

    Signs
        Growing longer it pulls. `tension(j)` > 0 pulls.

    Valid when
        The damper is light and linear.

    Reference
        An Introduction to Planar Dynamics, 3.1.2.
    """

    kind: ClassVar[str] = "damper"
    effect: ClassVar[Effect] = Effect("damper force", "dampers", rank=5)
    line: ClassVar[str] = "pull of {called}"
    quantities: ClassVar[tuple[str, ...]] = ("tension",)
    nouns: ClassVar[tuple[str, ...]] = ("dashpot", "absorber", "brake")
    pulls: ClassVar[bool] = True
    dissipates: ClassVar[bool] = True

    between: tuple[str, str] = key(PointPairKey(), "the two points it joins")
    coefficient: Side = key(SideKey("N*s/m"), "force per speed")

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        start, end = (scene.point(p) for p in self.between)
        return (Absorber(start, end, fixed_ends(scene, *self.between), self.coefficient),)

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        start, end = (scene.point(p) for p in self.between)
        reach = end - start
        if scene.vanishes(reach.dot(reach)):
            raise scene.refuse(self.mark, "PL541", f"the ends of {self.name} coincide: the damper has no direction")
        along = reach / scene.length(reach)
        bodies = tuple(scene.owner(p) for p in self.between)
        rate = (scene.velocity(end, bodies[1]) - scene.velocity(start, bodies[0])).dot(along)
        coefficient = scene.value(self.coefficient)
        # A case may leave out the damper of the others by a coefficient of zero.
        if scene.vanishes(rate) or scene.vanishes(coefficient):
            return ()
        tension = coefficient * rate
        ends = ((bodies[0], start, along), (bodies[1], end, -along))
        return tuple(Wrench(self.name, "damper", b, at, d * tension, 0, tension) for b, at, d in ends)
