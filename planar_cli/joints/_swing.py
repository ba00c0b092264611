"""A straight tie between two points: one end swings about the other."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from planar_cli.problem.scene.facts import Anchor, Joining, Path
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.setting import Setting


def swing(
    scene: Setting, joint: str, start: tuple[str, Anchor], end: tuple[str, Anchor], direction: Vec, curvature: Any
) -> Joining:
    """One end slides along a circle about the other: about the one that is fixed; of two particles the last about the
    first, as a bob about the point from which it hangs; else the first (with no curvature: straight across).

    `start`, `end`: the name of each point and its anchor; `direction`: unit vector from start to end. The circle bends
    towards its centre: with the tangent t = k × direction, its normal k × t is -direction. What swings about a fixed
    point of a body that turns there has nothing of the turning.
    """
    fixed = [anchor.body == "ground" or name in scene.fixed for name, anchor in (start, end)]
    if sum(fixed) == 1:
        start, end = ((n, replace(a, body="ground") if f else a) for (n, a), f in zip((start, end), fixed, strict=True))
    rigid = any(scene.rigid(anchor.body) for _, anchor in (start, end))
    if end[1].body == "ground" or (rigid and start[1].body != "ground"):
        start, end, direction = end, start, -direction
    path = Path(direction.turned(), curvature)
    return Joining(joint, end[1].body, start[1].body, end[1].point, end[0], path, far=start[0])
