"""What acts inside bodies that are joined to one: the reactions of welds, and of pins between particles."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.equation.system.system import System
from planar_cli.joints.base import Joint, distinct
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.scene import GROUND


def inner_reactions(system: System) -> Iterator[tuple[Push, Joint]]:
    """Each with its joint. A particle has no size: what is pinned to it can turn, but two of them move as one."""
    found = [j for j in distinct(system.scene.problem.joints) if j.kind in ("weld", "pin")]
    joints = {j.name: j for j in found if j.kind == "weld" or not any(map(system.scene.rigid, _bodies(j)))}
    for push in system.pushes if joints else ():
        if push.joint in joints and GROUND not in {a.body for a in push.actions}:
            yield push, joints[push.joint]


def _bodies(joint: Joint) -> list[str]:
    return [b for b in getattr(joint, "between", ()) if b != GROUND]
