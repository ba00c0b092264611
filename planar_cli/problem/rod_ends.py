"""Which end of a rod stands on a line: the point through which that is drawn, or the end that lies on it."""

from __future__ import annotations

import math

from planar_cli.problem.expression import Side
from planar_cli.problem.known_values import KnownValues, NoNumber, Rough
from planar_cli.problem.scene import At, Line, Point, Polar, Rod, Symbol

SAME = 1e-9
"""By less than this part of the sizes that are compared a point is off a line on which it lies."""
DEEP = 50
"""So many points may be told by one another."""
Place = tuple[float, float]


class Ends:
    """Ends of rods beside lines, as far as numbers of the file tell where they are."""

    def __init__(self, points: tuple[Point, ...], given: tuple[Symbol, ...]) -> None:
        self.places = {p.name: p.place for p in points}
        self.values = KnownValues({s.name: s for s in given})

    def standing(self, rod: Rod, line: Line) -> str | None:
        """The end that stands on a line; None: both may, or neither is known to."""
        ends = [end for end in (rod.start, rod.end) if end is not None]
        on = [end for end in ends if end == line.through or self._lies_on(end, line)]
        return on[0] if len(on) == 1 else None

    def _lies_on(self, end: str, line: Line) -> bool:
        one, other = self._place(end), self._place(line.through)
        angle = self._number(line.angle)
        if one is None or other is None or angle is None:
            return False
        x, y = one[0] - other[0], one[1] - other[1]
        size = max(*map(abs, one), *map(abs, other))
        return abs(y * math.cos(angle) - x * math.sin(angle)) <= SAME * size

    def _place(self, name: str, depth: int = 0) -> Place | None:
        """Where a point is [SI]; None where a letter or a coordinate tells it, or another construction."""
        place = self.places.get(name)
        if isinstance(place, At):
            x, y = self._number(place.x), self._number(place.y)
            return None if x is None or y is None else (x, y)
        if isinstance(place, Polar) and depth < DEEP:
            origin = self._place(place.origin, depth + 1)
            way, angle = self._number(place.distance), self._number(place.angle)
            if origin is not None and way is not None and angle is not None:
                return origin[0] + way * math.cos(angle), origin[1] + way * math.sin(angle)
        return None

    def _number(self, side: Side) -> float | None:
        try:
            found = self.values.value(side)
        except NoNumber:
            return None
        return found.value if isinstance(found, Rough) else None if found is None else float(found)
