"""A general position of a scene as data: the coordinates, and where they put every body."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import sympy as sp

from planar_cli.equation.scene.pose import Pose
from planar_cli.equation.values.ledger import Kind, Ledger, Role
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import changing, record
from planar_cli.units import parse_unit

ZERO = sp.S.Zero


@record
class Coordinate:
    """One freedom of the tree; its rate is factor · speed + extra."""

    symbol: sp.Symbol
    start: sp.Symbol
    """Its value where the motion begins, of which a formula may hold where it is not drawn."""
    unit: str
    """ "m" or "rad"."""
    drawn: sp.Expr | None
    """Its value as drawn; None: open."""
    speed: sp.Symbol
    """The velocity unknown that goes with it."""
    factor: sp.Expr
    words: str
    """What it is."""
    body: str
    shown: str
    """The unit in which it is told."""
    extra: sp.Expr = ZERO
    against: str = ""
    """The axis against which it counts, x or y; "" for none."""
    zero: sp.Expr = ZERO
    """Where it is zero on that axis."""

    @property
    def rate(self) -> sp.Expr:
        """How fast it grows, in the velocity unknowns of its tree."""
        return self.factor * self.speed + self.extra


@changing
class CoordinateNames:
    """The symbols of the coordinates of one problem and of their starts: the same ones in all of its scenes."""

    made: dict[tuple[str, str], sp.Symbol] = field(default_factory=dict)
    """By the name that was wished for, and the body; of a start by the name of its coordinate and ""."""

    def coordinate(self, ledger: Ledger, name: str, body: str, unit: str) -> sp.Symbol:
        """The coordinate of a body."""
        return self._symbol(ledger, (name, body), name, unit, Role(Kind.COORDINATE))

    def start(self, ledger: Ledger, coordinate: sp.Symbol, unit: str) -> sp.Symbol:
        """The value of a coordinate where the motion begins."""
        role = Role(Kind.START, coordinate)
        return self._symbol(ledger, (coordinate.name, ""), f"{coordinate.name}_0", unit, role)

    def _symbol(self, ledger: Ledger, key: tuple[str, str], name: str, unit: str, role: Role) -> sp.Symbol:
        if key not in self.made:
            others = {s.name for s in self.made.values()}
            while name in others:
                name += "′"
            self.made[key] = ledger.fresh(name, unit, role=role)
        ledger.adopt(self.made[key], parse_unit(unit), role)
        return self.made[key]


@record
class Displacement:
    """Poses by body, places of points that no body carries along (points of contact), all coordinates;
    `formula`: bodies whose places the file itself writes with coordinates; `clockwise`: bodies whose angles grow
    clockwise.
    """

    poses: Mapping[str, Pose]
    spots: Mapping[str, Vec]
    coordinates: tuple[Coordinate, ...]
    formula: frozenset[str]
    clockwise: frozenset[str]
