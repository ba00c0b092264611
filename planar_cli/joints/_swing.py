"""A straight tie between two points: one end swings about the other."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from planar_cli.problem.facts import Anchor, Joining, Path
from planar_cli.problem.geometry import Vec
from planar_cli.problem.setting import Setting


def swing(
    scene: Setting, joint: str, start: tuple[str, Anchor], end: tuple[str, Anchor], direction: Vec, curvature: Any
) -> Joining:
    """The start slides along a circle about the end (with no curvature: straight across the direction).

    `start`, `end`: the name of each point and its anchor; `direction`: unit vector from start to end. The circle bends
    towards the end: with the tangent t = -k × direction, its normal k × t is the direction itself. What swings about
    a fixed point of a body that turns there has nothing of the turning.
    """
    fixed = [anchor.body == "ground" or name in scene.fixed for name, anchor in (start, end)]
    if sum(fixed) == 1:
        start, end = ((n, replace(a, body="ground") if f else a) for (n, a), f in zip((start, end), fixed, strict=True))
    if start[1].body == "ground":
        start, end, direction = end, start, -direction
    path = Path(-direction.turned(), curvature)
    return Joining(joint, start[1].body, end[1].body, start[1].point, start[0], path, far=end[0])
