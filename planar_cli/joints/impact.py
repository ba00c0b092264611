"""Impact of two bodies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.joints.base import Joint
from planar_cli.problem.expression import Side
from planar_cli.problem.facts import Mode
from planar_cli.problem.keys import PartnersKey, SideKey, key
from planar_cli.problem.residuals import Residual
from planar_cli.problem.setting import Setting


@dataclass(frozen=True, slots=True, kw_only=True)
class Impact(Joint):
    """Two bodies collide.

    Meaning
        Between the states of `during` (the second is `just after` the first) the two bodies strike each other.
        `normal` is the direction of the common normal, where the shapes leave it open. `restitution` is the ratio of
        the speeds of separation and approach along it; left out, it is unknown. `mu` adds friction impulses.

    YAML
        title: Two balls collide head on
        plane: horizontal
        points: {A: [0, 0], B: [1 m, 0]}
        bodies:
          A: {particle: A, mass: 2 kg}
          B: {particle: B, mass: 1 kg}
        joints:
          - impact: {between: [A, B], normal: 0 deg, restitution: 0.8, during: 1->2}
        states:
          1: [v(A).x = 3 m/s, v(A).y = 0, B at rest]
          2: [just after 1]
        find: {v_A: v(A).x @ 2, v_B: v(B).x @ 2}

    Equations
        (v_B2 - v_A2) · n = -e (v_B1 - v_A1) · n;  equal and opposite impulses along n; across it each keeps its
        momentum, or a friction impulse up to mu times the normal impulse acts.

    Signs
        `impulse(j/b) @ 1->2` is the impulse on b, a vector.

    Valid when
        The impact is so short that nothing moves meanwhile; 0 <= restitution <= 1.

    Reference
        An Introduction to Planar Dynamics, 3.7.1 (direct), 3.7.2 (oblique), 3.7.3 (with constraints), 4.6.
    """

    kind: ClassVar[str] = "impact"

    between: tuple[str, ...] = key(PartnersKey(), "the two bodies, or a body and a surface")
    normal: Side | None = key(SideKey("deg", angle=True), "direction of the common normal", default=None)
    restitution: Side | None = key(SideKey("1"), "coefficient of restitution, 0 to 1; left out: unknown", default=None)
    mu: Side | None = key(SideKey("1"), "coefficient of friction during the impact", default=None)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        raise scene.refuse(
            self.mark,
            "PL590",
            "an impact joins two states",
            "state the velocities after it: instants, and motions between impacts, are solved",
        )

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """None: an impact keeps no places."""
        return ()
