"""A general position of a scene as data: the coordinates, and where they put every body."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from planar_cli.equation.pose import Pose
from planar_cli.problem.geometry import Vec

ZERO = sp.S.Zero


@dataclass(frozen=True, slots=True)
class Coordinate:
    """One freedom of the tree. `drawn`: its value as drawn (None: open). `speed`: the velocity unknown that goes with
    it; its rate is factor · speed + extra. `unit`: "m" or "rad". `words`: what it is. `shown`: the unit it is told in.
    """

    symbol: sp.Symbol
    unit: str
    drawn: sp.Expr | None
    speed: sp.Symbol
    factor: sp.Expr
    words: str
    body: str
    shown: str
    extra: sp.Expr = ZERO

    @property
    def rate(self) -> sp.Expr:
        """How fast it grows, in the velocity unknowns of its tree."""
        return self.factor * self.speed + self.extra


@dataclass(frozen=True, slots=True)
class Displacement:
    """Poses by body, places of points that no body carries along (points of contact), all coordinates;
    `formula`: bodies whose places the file itself writes with coordinates.
    """

    poses: Mapping[str, Pose]
    spots: Mapping[str, Vec]
    coordinates: tuple[Coordinate, ...]
    formula: frozenset[str]
