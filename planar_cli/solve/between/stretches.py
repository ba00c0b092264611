"""Stretches of a motion between states, and the laws by which coordinates move on them, as frozen data. SI units."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.displacement import Coordinate
from planar_cli.records import record


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
    """The free speed that it goes with, v = factor · speed; None: with none."""
    factor: sp.Expr = sp.S.One
    """See `speed`; 1 or a length."""
    effort: float = 0.0
    """What it takes to find it, beside what its integral costs."""


@record
class Stretch:
    """Between two states that follow each other, without a blow."""

    since: str
    """The state at its beginning."""
    stop: str
    """The state at its end."""
    laws: tuple[Law, ...]
    """How its coordinates move."""
    ends: tuple[Mapping[sp.Symbol, sp.Symbol], Mapping[sp.Symbol, sp.Symbol]]
    """By the symbol of the general position, those of both states."""
    time: sp.Symbol
    """The time in the general position."""
