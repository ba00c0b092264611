"""The weld."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.joints._outline_residuals import joined, same_turn
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.facts import Facts, Joining, Mode, Push, opposed
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import PartnersKey, PointKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import Setting
from planar_cli.problem.scene.sketches import Fastening, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Weld(Joint):
    """Two bodies are rigidly fixed to each other.

    Meaning
        At the point `at` the two bodies are welded, clamped or built in: neither sliding nor turning. With `ground`
        it is a fixed support. With `during: 1->2` they become one body at state 1: a perfectly plastic impact.

    YAML
        title: Bracket carried by a moving rod
        plane: vertical
        points: {O: [0, 0], A: [0, -1 m], B: [0.4 m, -1 m]}
        bodies:
          OA: {rod: [O, A], mass: 2 kg}
          AB: {rod: [A, B], mass: 0.8 kg}
        joints:
          - pin: {at: O, between: [ground, OA]}
          - weld: {at: A, between: [OA, AB]}
        instant: [at rest]
        find: {alpha: alpha(OA), M: moment(A/AB)}

    Equations
        r_A and θ of one body = those of the other. Two reactions and a moment.

    Signs
        `reaction(A/b)` and `moment(A/b)` are on body b; a moment is positive counterclockwise.

    Valid when
        Nothing deforms.

    Reference
        An Introduction to Planar Dynamics, 2.2.1 (translation), 4.3.
    """

    kind: ClassVar[str] = "weld"

    at: str = key(PointKey(), "the common point")
    between: tuple[str, ...] = key(PartnersKey(), "the two bodies, or a body and `ground`")

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return tuple((self.at, body) for body in self.between)

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        return (Fastening(scene.point(self.at)),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        mover, base = (scene.carrier(b) for b in self.between)
        if mover == "ground":
            mover, base = base, mover
        point = scene.point(self.at)
        pushes = []
        held = [("x", Vec(1, 0), 0, "N"), ("y", Vec(0, 1), 0, "N")]
        # A particle has no size, so that no couple can hold it.
        turned = [("", None, 1, "N*m")] if scene.rigid(mover) and scene.rigid(base) else []
        for name, force, couple, unit in (*held, *turned):
            actions = opposed(mover, base, point, force, couple)
            title = f"{self.name}_{name}" if force is not None else f"M_{self.name}"
            pushes.append(
                Push(title, "component" if force is not None else "couple", self.name, self.at, actions, unit)
            )
        joining = Joining(self.name, mover, base, point, self.at, turns=False)
        return (Mode("", "", Facts((joining,), pushes=tuple(pushes))),)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        a, b = (scene.carrier(p) for p in self.between)
        found = (joined(scene, f"{self.name}: place", self.during, a, b, scene.point(self.at), scene.owner(self.at)),)
        if not (scene.rigid(a) and scene.rigid(b)):
            return found
        return (*found, same_turn(f"{self.name}: angle", a, b))
