"""The link: a light rigid rod between two points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.joints._swing import swing
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Action, Anchor, Facts, Mode, Push
from planar_cli.problem.scene.fixed_ends import fixed_ends
from planar_cli.problem.scene.keys import PointPairKey, SideKey, key
from planar_cli.problem.scene.residuals import Poses, Residual
from planar_cli.problem.scene.setting import Setting
from planar_cli.problem.scene.sketches import Bar, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Link(Joint):
    """A light rigid rod keeps two points at a constant distance.

    Meaning
        A massless two-force member, pinned at both points. The points belong to bodies, or are fixed. It pulls or
        pushes. `length` may be given where a place is open; else it is the distance as drawn.

    YAML
        title: Beam carried by two parallel links
        plane: vertical
        points:
          A: [0, 1 m]
          B: [1 m, 1 m]
          C: {from: A, distance: 1 m, angle: -60 deg}
          D: {from: B, distance: 1 m, angle: -60 deg}
        bodies: {beam: {rod: [C, D], mass: 10 kg}}
        joints:
          - link: {between: [A, C], name: AC}
          - link: {between: [B, D], name: BD}
        instant: [at rest]
        find: {a: a(beam), T: tension(AC)}

    Equations
        |r_B - r_A| = l; so v(B/A) stands across the link. One reaction along it.

    Signs
        `tension(j)` > 0 pulls, < 0 pushes.

    Valid when
        Its mass is small against the others.

    Reference
        An Introduction to Planar Dynamics, 2.3.1, 4.3.
    """

    kind: ClassVar[str] = "link"
    quantities: ClassVar[tuple[str, ...]] = ("tension",)

    between: tuple[str, str] = key(PointPairKey(), "the two points it joins")
    length: Side | None = key(SideKey("m"), "its length, where the drawing leaves it open", default=None)

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        start, end = (scene.point(p) for p in self.between)
        return (Bar(start, end, fixed_ends(scene, *self.between)),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        a, b = self.between
        start, end = Anchor(scene.owner(a), scene.point(a)), Anchor(scene.owner(b), scene.point(b))
        reach = end.point - start.point
        if scene.vanishes(reach.dot(reach)):
            raise scene.refuse(self.mark, "PL541", f"the ends of {self.name} coincide: the link has no direction")
        length = scene.value(self.length) if self.length is not None else scene.length(reach)
        direction = reach / length
        joining = swing(scene, self.name, (a, start), (b, end), direction, 1 / length)
        drawn = direction if self.length is not None else reach / scene.reach_by_letter(reach, self.between)
        actions = (Action(start.body, start.point, drawn), Action(end.body, end.point, -drawn))
        push = Push(f"S_{self.name}", "tension", self.name, f"{a}{b}", actions)
        return (Mode("", "", Facts((joining,), pushes=(push,))),)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        (a, b), owners = self.between, [scene.owner(p) for p in self.between]
        start, end = scene.point(a), scene.point(b)
        length = None if self.length is None else scene.value(self.length)

        def stretch(poses: Poses) -> Any:
            distance = poses.length(poses.point(owners[1], end) - poses.point(owners[0], start))
            return poses.change(distance) if length is None else distance - poses.number(length)

        return (Residual(f"{self.name}: length", stretch),)
