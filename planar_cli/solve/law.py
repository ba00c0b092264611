"""The law by which one coordinate moves."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.records import record

if TYPE_CHECKING:
    from planar_cli.calculus.vibrations import Vibration
    from planar_cli.equation.scene.displacement import Coordinate

ANOMALY = "anomaly"
"""The kind of the equations of an ellipse under an attraction K m/r²."""
RELATIVE = "relative"
"""The kind of a relation that says how one thing moves relative to another with the same acceleration."""
MIRRORED, AT_MIDPOINT, HALF_SWINGS = "mirrored", "at the midpoint", "half swings"
"""The kinds of what a harmonic motion from rest tells without the time: where it is at rest again, how fast it is at
the midpoint; and of how long it takes from rest to rest.
"""
FROM_REST = (MIRRORED, AT_MIDPOINT, HALF_SWINGS)
IN_THE_END = "in the end the speed no longer changes"
"""The words of a relation at t = infinity that says that an acceleration is zero there."""


@record
class Law:
    """How one coordinate moves: q̇ = f (order 1) or q̈ = f (order 2)."""

    coordinate: Coordinate
    """The coordinate q."""
    order: int
    """1 or 2."""
    f: sp.Expr
    """The rate in t, q and its own speed v, m/s or rad/s, m/s² or rad/s²."""
    v: sp.Symbol
    """The symbol of the own speed in `f`."""
    speed: sp.Symbol | None = None
    factor: sp.Expr = sp.S.One
    """The free speed that it goes with, v = factor · speed (None: with none); the factor is 1 or a length."""
    effort: float = 0.0
    """What it takes to find it, beside what its integral costs."""
    steady: bool = False
    """Is an acceleration the same all the time?"""
    constant: tuple[sp.Symbol, sp.Expr] | None = None
    """The letter of a rate that does not change, in which `f` is written, and its formula; None: it has none."""
    vibration: Vibration | None = None
    """The letters in which the motion of a linear law is told; None: it has none."""
    terminal: tuple[sp.Symbol, sp.Expr, sp.Expr] | None = None
    """The letter of the speed at which a drag balances what drives, its formula, and `f` by it; None: it is told
    without.
    """
