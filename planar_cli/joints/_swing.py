"""A straight tie between two points: one end swings about the other."""

from __future__ import annotations

from typing import Any

from planar_cli.problem.facts import Anchor, Joining, Path
from planar_cli.problem.geometry import Vec


def swing(joint: str, start: tuple[str, Anchor], end: tuple[str, Anchor], direction: Vec, curvature: Any) -> Joining:
    """The start slides along a circle about the end (with no curvature: straight across the direction).

    `start`, `end`: the name of each point and its anchor; `direction`: unit vector from start to end. The circle bends
    towards the end: with the tangent t = -k × direction, its normal k × t is the direction itself.
    """
    if start[1].body == "ground":
        start, end, direction = end, start, -direction
    path = Path(-direction.turned(), curvature)
    return Joining(joint, start[1].body, end[1].body, start[1].point, start[0], path, far=end[0])
