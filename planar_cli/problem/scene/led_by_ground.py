"""Whether the ground leads a point of a body along a path."""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND


def led_by_ground(joinings: Iterable[Joining], body: str) -> bool:
    """Does the ground lead a point of a body, which turns about it, along a path?"""
    return any({j.mover, j.base} == {body, GROUND} and j.path is not None and j.turns for j in joinings)
