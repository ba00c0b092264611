"""The curve of a point that moves with one freedom, where a loop ties its coordinates and nothing closed tells how.

The loop is followed in numbers; the places to more than forty digits tell whether the curve is a line or a conic.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.curve_words import CURVE, Curve
from planar_cli.calculus.curves import curve_numeric
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NoValue
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.regimes.constraints import Constraint, drawn_starts, fixed_by, project
from planar_cli.solve.regimes.regime import Regime
from planar_cli.units import LENGTH

STEPS = 9
STEP = Decimal("0.031")
SMALL = Decimal("0.1")
"""A step of a place is measured by where it is, or by this part of an ordinary length."""
GIVEN = "x and y and what ties its coordinates"


@record
class Loops:
    """The conditions between coordinates that hold at any time, and the coordinates in them."""

    constraints: tuple[Constraint, ...]
    unknowns: tuple[sp.Symbol, ...]

    def driven_by(self, driver: sp.Symbol, at: Decimal) -> tuple[Constraint, ...]:
        """The same with one coordinate given."""
        number = sp.Rational(str(at))
        return (*self.constraints, Constraint(driver - number, "", ""))


def loops_of(regime: Regime) -> Loops:
    """Loops alone, without what `motion` says of places."""
    held = tuple(
        c for c in regime.general.constraints if c.kind == "loop" and regime.time not in c.residual.free_symbols
    )
    inside = set().union(*(c.residual.free_symbols for c in held)) if held else set()
    return Loops(held, tuple(c.symbol for c in regime.coordinates if c.symbol in inside))


def driver_of(regime: Regime, loops: Loops, varying: Sequence[sp.Symbol]) -> Coordinate | None:
    """A coordinate that alone tells all others of a place; None: there is more than one freedom."""
    if not loops.constraints or not set(varying) <= set(loops.unknowns):
        return None
    value = _started(regime, regime.general.instant.scene.valuations[0])
    for c in regime.coordinates:
        if c.symbol in varying:
            fixed = fixed_by(loops.driven_by(c.symbol, value(c.symbol)), loops.unknowns, value)
            if set(varying) <= fixed:
                return c
    return None


def followed_curve(regime: Regime, loops: Loops, driver: Coordinate, place: Vec, axes: tuple[str, str]) -> Curve:
    """The kind of the curve for every draw of the letters; its equation where there are none."""
    scene = regime.general.instant.scene
    curves = []
    for value in scene.valuations:
        length = scene.ledger.scales.exact(LENGTH)
        points = _followed(loops, driver, place, _started(regime, value), length)
        curves.append(curve_numeric(points, axes) if len(points) >= 2 * STEPS else Curve(CURVE, given_by=GIVEN))
    first = curves[0]
    if first.kind == CURVE or any(c.kind != first.kind for c in curves):
        return Curve(CURVE, given_by=GIVEN)
    if any(s.is_positive for s in scene.ledger.letters):
        return Curve(first.kind, given_by=GIVEN)
    return first


def _started(regime: Regime, value: Valuation) -> Valuation:
    return value.extended(drawn_starts(regime.coordinates, regime.general.instant.scene.ledger.scales))


def _followed(
    loops: Loops, driver: Coordinate, place: Vec, value: Valuation, length: Decimal
) -> list[tuple[Decimal, Decimal]]:
    """Places along the loop, both ways from the drawn position. `length`: an ordinary one of the scene."""
    points = []
    reach = STEP * (1 if driver.unit == "rad" else max(abs(value(driver.symbol)), SMALL * length))
    for way in (1, -1):
        here = value
        for k in range(1 if way < 0 else 0, STEPS + 2):
            target = value(driver.symbol) + way * k * reach
            try:
                moved = project(
                    loops.driven_by(driver.symbol, target), loops.unknowns, here.extended({driver.symbol: target})
                )
            except NoValue:
                break
            here = here.extended(moved)
            points.append((here(place.x), here(place.y)))
    return points
