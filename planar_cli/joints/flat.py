"""A body that lies flat on another in a horizontal plane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.joints._outline_residuals import same_turn, together
from planar_cli.joints.base import Joint
from planar_cli.problem.geometry import Vec
from planar_cli.problem.residuals import Residual
from planar_cli.problem.setting import Setting
from planar_cli.problem.facts import Action, Anchor, Facts, Joining, Mode, Pull, Push, Row, Test
from planar_cli.problem.expression import Side
from planar_cli.problem.keys import PartnersKey, SideKey, key


@dataclass(frozen=True, slots=True, kw_only=True)
class Flat(Joint):
    """A body lies on another in a horizontal plane, and friction holds or brakes it.

    Meaning
        With `plane: horizontal` one looks from above: the first of `between` lies on the second (a table, a turning
        disk, or `ground`) and presses with its weight on it. Friction acts in the plane, up to mu m g.

    YAML
        title: Block on a turntable
        plane: horizontal
        points: {O: [0, 0], P: [0.5 m, 0]}
        bodies:
          table: {disk: O, radius: 1 m}
          block: {particle: P, mass: 2 kg}
        joints:
          - pin: {at: O, between: [ground, table]}
          - flat: {between: [block, table], mu: 0.3}
        motion: [omega(table) = 2 rad/s]
        instant: [v(P/table).mag = 0]
        find: {mode: mode(block), F: friction(block/block)}

    Equations
        stick  the body moves with what it lies on;               |F| <= mu m g
        slip   |F| = mu m g, against the relative velocity

    Signs
        `friction(j/b)` is the force on b, in the plane.

    Valid when
        The plane is horizontal and the body a particle, or sliding without turning.

    Reference
        An Introduction to Planar Dynamics, 3.1.2, 3.2.2.
    """

    kind: ClassVar[str] = "flat"

    between: tuple[str, ...] = key(PartnersKey(), "the body that lies, then the one it lies on or `ground`")
    mu: Side = key(SideKey("1"), "coefficient of friction; 0 is smooth")

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """PLACEHOLDER"""
        return (Mode("slip", "", Facts()),)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        if mode.name != "stick":
            return ()
        body, base = (scene.carrier(p) for p in self.between)
        found = (together(f"{self.name}: place", body, base, scene.center(body)),)
        if not (scene.rigid(body) and scene.rigid(base)):
            return found
        return (*found, same_turn(f"{self.name}: angle", body, base))
