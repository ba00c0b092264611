"""Bodies that an impact joint lets strike each other: apart until the distance closes, and in contact where they stay.

Every way in which their outlines may meet is a contact of its own, with the restitution and the friction of the impact.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from planar_cli.joints.base import Joint
from planar_cli.motion.scene.boundaries import Corner, boundaries
from planar_cli.motion.scene.gaps import NEAR, Gap
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.facts import Facts, Law, Mode, Push, Row, Test, opposed, relative
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import Setting


@dataclass(frozen=True, slots=True, kw_only=True)
class Encounter(Joint):
    """One way in which the partners of an impact may touch."""

    kind: ClassVar[str] = "encounter"

    impact: str
    """The impact's name."""
    gap: Gap
    """How far they are apart, and where they would touch."""
    restitution: Term
    """e; nan where the file leaves it open."""
    mu: Term
    """The coefficient of friction; 0 where it is smooth."""
    forced: bool
    """Does it strike whatever the distance, between the states that the file names?"""
    over: bool = False
    """Are those states behind? Then it strikes no more; where it was plastic, its partners stay in contact."""

    @property
    def distance(self) -> Term:
        """How far they are apart; positive too where the foot is outside the edge [m]."""
        found = self.gap.distance
        for inside in self.gap.within:
            found = (found - inside + found.graph.call("abs", found + inside)) * 0.5
        return found

    @property
    def plastic(self) -> bool:
        """Is the restitution zero?"""
        return self.restitution.constant and self.restitution.value == 0

    @property
    def smooth(self) -> bool:
        """Is there no friction?"""
        return self.mu.constant and self.mu.value == 0

    @property
    def sliding(self) -> Row:
        """How fast the second partner slides along the first."""
        return self._row(self.gap.normal.turned(), "sliding")

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """Apart first; then in contact, sticking or slipping where it is rough."""
        words = " and ".join(sorted((self.gap.first, self.gap.second), key=lambda b: b == GROUND))
        across, sliding = self._row(self.gap.normal, "apart"), self.sliding
        parts = Test(self.name, f"{words} are apart", row=across)
        apart = Mode("apart", f"{words} are apart", Facts(), (parts,), touching=Facts(rows=(across,)))
        normal = self._push("N", "normal", self.gap.normal)
        pressed = Test(self.name, f"{words} press on each other", ((normal.name, 1),))
        if self.smooth:
            return (apart, Mode("slip", f"{words} stay in contact", Facts(pushes=(normal,)), (pressed,)))
        friction = self._push("F", "friction", self.gap.normal.turned())
        pushes = (normal, friction)
        within = tuple(
            Test(self.name, f"friction between {words} within its limit", ((normal.name, self.mu), (friction.name, s)))
            for s in (-1, 1)
        )
        found = [apart, Mode("stick", f"{words} stick together", Facts(pushes=pushes), (pressed, *within), sliding)]
        for direction in (1, -1):
            slips = f"{words} slide on each other"
            moves = Test(self.name, f"{slips} as assumed", row=sliding, sense=direction, strict=True)
            facts = Facts(pushes=pushes, laws=(Law(friction.name, -direction * self.mu, normal.name),))
            found.append(Mode("slip", slips, facts, (pressed, moves), sliding, direction))
        return tuple(found)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """The distance stays zero where they are in contact."""
        if mode.name == "apart":
            return ()
        return (Residual(f"{self.impact}: distance", lambda poses: self.gap.distance),)

    def _push(self, stem: str, kind: str, along: Any) -> Push:
        actions = opposed(self.gap.second, self.gap.first, self.gap.point, along)
        return Push(f"{stem}_{self.name}", kind, self.name, self.name, actions)

    def _row(self, along: Any, title: str) -> Row:
        pulls = relative(self.gap.second, self.gap.first, self.gap.point, along)
        return Row(self.name, f"{self.impact}: {title}", pulls)


def encounters_of(
    scene: MovingScene, joints: Sequence[Joint], stands: Callable[[Joint, Gap], bool], over: Collection[str] = ()
) -> dict[str, tuple[Encounter, ...]]:
    """The encounters of every impact among the joints, by its name. `stands`: another joint stands for this way of
    touching. `over`: of these the states they act between are behind.
    """
    found: dict[str, tuple[Encounter, ...]] = {}
    for joint in joints:
        gaps = [gap for gap in scene.gaps(joint) if not stands(joint, gap)] if joint.strikes else []
        if not gaps:
            continue
        one = [_encounter(scene, joint, gap, joint.name in over) for gap in gaps]
        if len(one) > 1:
            one = [replace(e, name=f"{joint.name}_{k + 1}") for k, e in enumerate(one)]
        found[joint.name] = tuple(one)
    return found


def at_another_corner(scene: MovingScene, place: Vec, contact: Joint) -> bool:
    """Is a place a corner of one of the partners of a contact, which is at another corner of it?"""
    at = getattr(contact, "at", "")
    if not at:
        return False
    corners = [b.place for p in getattr(contact, "between", ()) for b in boundaries(scene, p) if isinstance(b, Corner)]
    own, others = (
        next((i for i, c in enumerate(corners) if _one(scene, c, p)), None) for p in (place, scene.point(at))
    )
    return own is not None and others is not None and own != others


def _one(scene: MovingScene, a: Vec, b: Vec) -> bool:
    """Are two places drawn as one?"""
    gap = a - b
    return math.hypot(scene.graph.of(gap.x).value, scene.graph.of(gap.y).value) <= NEAR * scene.extent


def restitution_of(scene: MovingScene, joint: Joint) -> Term:
    """e of an impact."""
    side = getattr(joint, "restitution", None)
    return scene.graph.number(math.nan) if side is None else scene.value(side)


def friction_of(scene: MovingScene, joint: Joint) -> Term:
    """The coefficient of friction of an impact; 0 where it has none."""
    side = getattr(joint, "mu", None)
    return scene.graph.number(0.0) if side is None else scene.value(side)


def _encounter(scene: MovingScene, joint: Joint, gap: Gap, over: bool) -> Encounter:
    return Encounter(
        name=joint.name,
        during=None if over else joint.during,
        mark=joint.mark,
        impact=joint.name,
        gap=gap,
        restitution=restitution_of(scene, joint),
        mu=friction_of(scene, joint),
        forced=joint.during is not None and not over,
        over=over,
    )
