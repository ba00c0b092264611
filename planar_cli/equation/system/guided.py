"""Guides and walls that have nothing to keep on its line: what is hauled up a shaft does not press against it."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND


def does_nothing(system: System, push: Push, size: Decimal | None) -> bool:
    """Is it a friction that is zero, or a guide that guides nothing? `size`: None where nothing tells it."""
    return (size == 0 and push.kind == "friction") or (not size and guides_nothing(system, push))


def guides_nothing(system: System, push: Push) -> bool:
    """Is it the force of a fixed guide or wall across which nothing else acts, and nothing is accelerated? Two of them
    on one body keep nothing either.
    """
    if push.kind != "normal":
        return False
    own = [a for a in push.actions if a.body != GROUND]
    return len(own) == 1 and all(a.force is not None and not _acts(system, a.body, a.force) for a in own)


def _acts(system: System, body: str, across: Vec) -> bool:
    """Is there anything on a body along a direction but forces of fixed guides and walls along it?"""
    motion, reactions = system.motion, system.reactions
    if motion is None or reactions is None:
        return True
    others = [w.force for w in system.wrenches if w.body == body and w.force is not None]
    for p, _ in reactions.pushes:
        forces = [a.force for a in p.actions if a.body == body and a.force is not None]
        fixed = p.kind == "normal" and all(a.body in (body, GROUND) for a in p.actions)
        others += () if fixed and all(simplified(f.cross(across)) == 0 for f in forces) else forces
    center = system.scene.bodies[body].center
    others.append(motion.acceleration(center, body))
    return any(simplified(sp.sympify(force.dot(across))) != 0 for force in others)
