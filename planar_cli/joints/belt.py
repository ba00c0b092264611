"""The belt between two disks."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.errors import Diagnostic
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.facts import Action, Anchor, Facts, Mode, Pull, Push, Row
from planar_cli.problem.scene.keys import FlagKey, PartnersKey, key
from planar_cli.problem.scene.residuals import Poses, Residual
from planar_cli.problem.scene.setting import Setting, WrittenScene
from planar_cli.problem.scene.sketches import Loop, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Belt(Joint):
    """An endless belt or chain runs round two disks without slipping.

    Meaning
        The rims of the two disks have the same speed. `crossed: true`: the belt crosses itself between the disks, so
        that they turn in opposite senses.

    YAML
        title: Belt drive
        points: {A: [0, 0], B: [0.5 m, 0]}
        bodies:
          small: {disk: A, radius: 0.1 m}
          large: {disk: B, radius: 0.3 m}
        joints:
          - pin: {at: A, between: [ground, small]}
          - pin: {at: B, between: [ground, large]}
          - belt: {between: [small, large]}
        motion: [omega(small) = 60 rpm]
        find: {omega: omega(large) in rpm}

    Equations
        R1 ω1 = R2 ω2, or R1 ω1 = -R2 ω2 when crossed. One reaction: the difference of the tensions of its two parts.

    Signs
        `tension(j)` is that difference; > 0 turns the second disk of `between` counterclockwise.

    Valid when
        The belt is taut, light and does not slip.

    Reference
        An Introduction to Planar Dynamics, 1.3.2, 2.2.2.
    """

    kind: ClassVar[str] = "belt"
    quantities: ClassVar[tuple[str, ...]] = ("tension",)

    between: tuple[str, ...] = key(PartnersKey(), "the two disks")
    crossed: bool = key(FlagKey(), "true: the belt crosses itself and reverses the sense", default=False)

    def objections(self, scene: WrittenScene) -> Iterable[Diagnostic]:
        for body in scene.bodies:
            if body.name in self.between and not body.is_disk:
                message = f"a belt runs round disks; {body.name} is none"
                hint = "give it `disk: G, radius: …`"
                if body.is_round:
                    message = f"a belt runs round disks with the mass centre in the middle; that of {body.name} is not"
                    hint = f"let it run on a disk `{{disk: O, radius: …}}` without mass, and `weld` that to {body.name}"
                yield Diagnostic(body.mark, "PL455", message, hint)

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        a, b = self.between
        return (Loop((scene.center(a), scene.center(b)), (scene.radius(a), scene.radius(b)), self.crossed),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        a, b = self.between
        r_a, r_b = scene.radius(a), scene.radius(b) * (-1 if self.crossed else 1)
        center_a, center_b = scene.center(a), scene.center(b)
        if scene.vanishes((center_b - center_a).dot(center_b - center_a)):
            text = f"{a} and {b} have one centre: no belt runs from one to the other"
            raise scene.refuse(self.mark, "PL541", text, "draw them beside each other, or `weld` them together")
        span = scene.length(center_b - center_a)
        across = (center_b - center_a).turned() / span**2
        arm = across * (r_b - r_a)
        pulls = (Pull(Anchor(b, center_b), arm), Pull(Anchor(a, center_a), -arm))
        row = Row(self.name, f"the belt runs on {a} and {b} without slip", pulls, ((a, r_a), (b, -r_b)))
        actions = (Action(a, center_a, -arm, r_a), Action(b, center_b, arm, -r_b))
        push = Push(f"T_{self.name}", "tension", self.name, self.name, actions)
        return (Mode("", "", Facts(rows=(row,), pushes=(push,))),)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """One straight part takes up on one rim what it gives out on the other: R_a (θ_a - ψ) = ± R_b (θ_b - ψ).

        ψ is the direction of the line of centres, against which the tangent points keep their places.
        """
        a, b = self.between
        center_a, center_b, radius_a, radius_b = scene.center(a), scene.center(b), scene.radius(a), scene.radius(b)

        def creep(poses: Poses) -> Any:
            psi = poses.turned(poses.point(b, center_b) - poses.point(a, center_a))
            on_a = (poses.angle(a) - psi) * poses.number(radius_a)
            on_b = (poses.angle(b) - psi) * poses.number(radius_b)
            return on_a + on_b if self.crossed else on_a - on_b

        return (Residual(f"{self.name}: arcs on both rims", creep),)
