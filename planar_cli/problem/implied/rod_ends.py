"""Which end of a rod stands on a line: the point through which that is drawn, or the end that lies on it."""

from __future__ import annotations

import math

from planar_cli.problem.implied.drawn_directions import DrawnDirections
from planar_cli.problem.scene.scene import Line, Rod

SAME = 1e-9
"""By less than this part of the sizes that are compared a point is off a line on which it lies."""


def standing_end(rod: Rod, line: Line, drawn: DrawnDirections) -> str | None:
    """The end that stands on a line, as far as numbers of the file tell; None: both may, or neither is known to."""
    ends = [end for end in (rod.start, rod.end) if end is not None]
    on = [end for end in ends if end == line.through or _lies_on(end, line, drawn)]
    return on[0] if len(on) == 1 else None


def _lies_on(end: str, line: Line, drawn: DrawnDirections) -> bool:
    one, other, angle = drawn.place(end), drawn.place(line.through), drawn.number(line.angle)
    if one is None or other is None or angle is None:
        return False
    x, y = one[0] - other[0], one[1] - other[1]
    size = max(*map(abs, one), *map(abs, other))
    return abs(y * math.cos(angle) - x * math.sin(angle)) <= SAME * size
