"""Guides that have nothing to keep on their line: what is hauled up a shaft does not press against it."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.plain import simplified
from planar_cli.equation.system import System
from planar_cli.problem.facts import Push
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND


def guides_nothing(system: System, push: Push) -> bool:
    """Is it the force of a guide at rest across which nothing else acts, and nothing is accelerated?"""
    guides = {j.name for j in system.scene.problem.joints if j.kind == "guide"}
    if push.kind != "normal" or push.joint not in guides:
        return False
    own = [a for a in push.actions if a.body != GROUND]
    return len(own) == 1 and all(a.force is not None and not _acts(system, push, a.body, a.force) for a in own)


def _acts(system: System, push: Push, body: str, across: Vec) -> bool:
    """Is there anything on a body along a direction but this force?"""
    motion, reactions = system.motion, system.reactions
    if motion is None or reactions is None:
        return True
    others = [w.force for w in system.wrenches if w.body == body and w.force is not None]
    pushing = [a for p, _ in reactions.pushes if p.name != push.name for a in p.actions]
    others += [a.force for a in pushing if a.body == body and a.force is not None]
    center = system.scene.bodies[body].center
    others.append(motion.acceleration(center, body))
    return any(simplified(sp.sympify(force.dot(across))) != 0 for force in others)
