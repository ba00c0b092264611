"""Contact that may stick, slip or part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.joints._outline_residuals import flush, stuck
from planar_cli.joints._touching import ContactPlace, Friction, Touching
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Mode, Outline
from planar_cli.problem.scene.keys import Choice, PartnersKey, PointKey, SideKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import Setting


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact(Joint):
    """Two bodies touch at a point and press on each other; they may stick, slip or part.

    Meaning
        A body stands, leans or slides on another, or on a surface, at the point `at`; it may be left out for a
        particle, for a round rim on an edge or another rim, and for a plate or a rod that stands on a line with an
        edge, a corner or one end. Say what friction there is: `mu` (static and kinetic; 0 is smooth), or `mu_s` and
        `mu_k` (`mu_k` alone: it slides; `mu_s` alone: does it slide, or at its limit), or `friction`, a fixed limit of
        the force. Which case holds is found, and asked by `mode(j)`: stick, slip, apart, or tip for a block. From one
        surface to another: one contact `during: 1->2`, the next `during: 2->3`. The corner between them is taken as
        rounded, so that the speed is kept; with a state `just after 2` it is a blow.

    YAML
        title: Does the ladder slip?
        plane: vertical
        points: {A: [0, 0], B: {from: A, distance: 4 m, angle: 60 deg}}
        surfaces: {floor: {through: A, angle: 0 deg}, wall: {through: B, angle: 90 deg}}
        bodies: {ladder: {rod: [A, B], mass: 20 kg}}
        joints:
          - contact: {between: [ladder, floor], at: A, mu: 0.35}
          - contact: {between: [ladder, wall], at: B, mu: 0}
        instant: [at rest]
        find: {mode: mode(A), N: N(A), F: friction(A).x}

    Equations
        stick  the touching points have the same velocity;        |F| <= mu_s N, N >= 0
        slip   the same velocity across the surface;               |F| = mu_k N, against the slipping
        apart  no force;                                          the distance does not shrink

    Signs
        `N(j)` > 0 presses. `friction(j)` is a vector, the force on the body whose partner is the ground, else on the
        body named, `friction(j/b)`; ask `.x` or `.along(30 deg)`.

    Valid when
        Dry friction; nothing is known of a pressure spread over an area, only of its resultant.

    Reference
        An Introduction to Planar Dynamics, 3.1.2, 4.3, 4.9.
    """

    kind: ClassVar[str] = "contact"
    guides: ClassVar[bool] = True
    quantities: ClassVar[tuple[str, ...]] = ("N", "friction", "mode")
    touches: ClassVar[bool] = True
    unilateral: ClassVar[bool] = True
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("mu",), ("mu_s", "mu_k"), ("mu_s",), ("mu_k",), ("friction",)),
            "`mu: 0` when it is smooth, `mu: 0.3`, or `mu_s: 0.3, mu_k: 0.2` (`mu_k` alone: it slides; "
            "`mu_s` alone: does it?), or `friction: 25 N`, a fixed limit",
        ),
    )

    between: tuple[str, ...] = key(PartnersKey(), "the two bodies, or a body and a surface")
    at: str = key(PointKey(), "the point where they touch; left out where the shapes tell it", default="")
    mu: Side | None = key(SideKey("1"), "coefficient of friction, static and kinetic; 0 is smooth", default=None)
    mu_s: Side | None = key(SideKey("1"), "coefficient of static friction", default=None)
    mu_k: Side | None = key(SideKey("1"), "coefficient of kinetic friction", default=None)
    friction: Side | None = key(SideKey("N"), "the largest friction force, whatever the normal force", default=None)

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return tuple((self.at, body) for body in self.between)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        # Of what slides, the kinetic coefficient alone may be known: at rest it holds at least as much.
        given = (self.mu_s or self.mu or self.mu_k, self.mu_k or self.mu or self.mu_s, self.friction)
        friction = Friction(*(None if side is None else scene.value(side) for side in given))
        return Touching(self._place(), scene, friction).modes()

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        if mode.name == "apart":
            return ()
        pair = Touching(self._place(), scene, Friction())
        mover, place = pair.mover, pair.place
        if mode.name == "tip":
            # Which corner stays is a choice of the mode: it is where its forces act.
            mover, place = Outline("corner", mover.body), mode.facts.pushes[0].actions[0].point
        sticks = mode.name == "stick" or (mode.name == "tip" and mode.sliding is not None and mode.direction == 0)
        return (stuck if sticks else flush)(self.name, mover, pair.base, place)

    def _place(self) -> ContactPlace:
        return ContactPlace(self.name, self.between, self.at, self.mark, self.during)
