"""Which ends of a rope, link, spring or damper are fastened to the ground."""

from __future__ import annotations

from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import Setting


def fixed_ends(scene: Setting, start: str, end: str) -> tuple[bool, bool]:
    """Of two points: do they belong to the ground?"""
    return scene.owner(start) == GROUND, scene.owner(end) == GROUND
