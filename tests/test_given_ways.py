"""The way that a point has gone tells a state: along a curve, its place."""

from __future__ import annotations

from math import asinh, sqrt

import pytest
from answered import first, solve

PARABOLA = """
title: Bead at a constant speed along a parabola
given: {c: 0.05 1/m}
points: {P: [0, 0]}
surfaces: {track: {y: c*x^2}}
bodies: {bead: {particle: P}}
joints:
  - guide: {body: bead, along: track}
motion: [v(bead).mag = 6 m/s]
states:
  1: [t = 0, v(bead).x > 0]
  2: [path_length(bead) @ 1->2 = 12 m]
find: {x: x(bead) @ 2, t: t @ 2}
"""


def way(x: float) -> float:
    """Along y = c x² from its vertex, with c = 0.05 1/m."""
    slope = 0.1 * x
    return 5 * (slope * sqrt(1 + slope**2) + asinh(slope))


def test_a_place_on_a_curve() -> None:
    found = solve(PARABOLA)
    assert way(first(found["x"])) == pytest.approx(12)
    assert first(found["t"]) == pytest.approx(2)
