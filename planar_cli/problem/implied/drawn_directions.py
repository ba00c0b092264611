"""Directions and places of the drawing in numbers, where the file gives them by numbers: None where it does not."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.problem.checks.chains import long_chains
from planar_cli.problem.language.expression import Part, PointPair, Side
from planar_cli.problem.scene.known_values import KnownValues
from planar_cli.problem.scene.scene import At, Body, Particle, Place, Point, Polar, Symbol

Pair = tuple[float, float]
DEEPEST = 20
"""Points that are drawn one from the other."""


class DrawnDirections:
    """The drawing of one file, as far as it is plain numbers [m], from the axes or from another point."""

    def __init__(self, given: Sequence[Symbol], points: Sequence[Point], bodies: Sequence[Body] = ()) -> None:
        # What is told by too long a chain is refused later on.
        chained = next(long_chains(given, points), None) is not None
        self._values = KnownValues({} if chained else {g.name: g for g in given})
        self._places: dict[str, Place] = {p.name: p.place for p in points}
        particles = {b.name: b.shape.place for b in bodies if isinstance(b.shape, Particle)}
        self._places |= {name: place for name, place in particles.items() if isinstance(place, At)}
        self._called = {name: place for name, place in particles.items() if isinstance(place, str)}

    def number(self, side: Side) -> float | None:
        """What a side amounts to in SI units."""
        return self._values.number(side)

    def direction(self, part: Part) -> Pair | None:
        """The direction of a component; of a pair of points as long as their distance."""
        match part:
            case Part(kind="x"):
                return 1.0, 0.0
            case Part(kind="y"):
                return 0.0, 1.0
            case Part(kind="along" | "across", direction=told) if told is not None:
                found = self._pair(told) if isinstance(told, PointPair) else self._at_angle(told)
                return found if found is None or part.kind == "along" else (-found[1], found[0])
        return None

    def place(self, name: str) -> Pair | None:
        """Where a point is drawn."""
        return self._place(name, DEEPEST)

    def _at_angle(self, angle: Side) -> Pair | None:
        number = self.number(angle)
        return None if number is None else (math.cos(number), math.sin(number))

    def _pair(self, pair: PointPair) -> Pair | None:
        to, origin = self.place(pair.to), self.place(pair.origin)
        return None if to is None or origin is None else (to[0] - origin[0], to[1] - origin[1])

    def _place(self, name: str, depth: int) -> Pair | None:
        place = self._places.get(self._called.get(name, name))
        if isinstance(place, At):
            x, y = self.number(place.x), self.number(place.y)
            return None if x is None or y is None else (x, y)
        if isinstance(place, Polar) and depth:
            origin, distance = self._place(place.origin, depth - 1), self.number(place.distance)
            way = self._at_angle(place.angle)
            if origin is not None and distance is not None and way is not None:
                return origin[0] + distance * way[0], origin[1] + distance * way[1]
        return None
