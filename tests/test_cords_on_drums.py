"""A cord on a drum leaves the rim where it is tangent, also when its end is drawn along or off a slanting line."""

from __future__ import annotations

import math

import pytest
from answered import solve

ALONG_ITSELF = """
title: A wheel turned by a slanting cable
given: {R: 0.6 m, r_h: 0.3 m}
points:
  O: [0, 0]
  T: [-4/5*r_h, 3/5*r_h]
  A: [-0.8 m * 3/5 - 4/5*r_h, -0.8 m * 4/5 + 3/5*r_h]
bodies:
  wheel: {disk: O, radius: R, hub: r_h}
  cable_end: {particle: A}
joints:
  - pin: {at: O, between: [ground, wheel]}
  - rope: {path: [A, T on wheel], name: cable}
motion: [v(A).x = -0.06 m/s, v(A).y = -0.08 m/s]
states:
  1: [t = 0]
  2: [t = 2 s]
find: {omega: omega(wheel) @ 2}
"""

ASIDE = """
title: A drum turned by a cable whose end is drawn aside
given: {r: 0.3 m}
points: {O: [0, 0], T: [-r, 0], A: [-r, -0.8 m]}
bodies:
  drum: {disk: O, radius: r}
  cable_end: {particle: A}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [A, T on drum], name: cable}
motion: [v(A).x = -0.1 m/s, v(A).y = -0.05 m/s]
states:
  1: [t = 0]
  2: [t = 2 s]
find: {omega: omega(drum) @ 2}
"""


def _turned(t: float, r: float = 0.3) -> float:
    """By how much the drum has turned but for a constant: r φ + L is the cable that has run off."""
    x, y = -r - 0.1 * t, -0.8 - 0.05 * t
    free = math.sqrt(x * x + y * y - r * r)
    return math.atan2(y, x) - math.atan2(free, r) + free / r


def test_a_cable_drawn_along_its_own_line() -> None:
    assert float(solve(ALONG_ITSELF)["omega"].values[0]) == pytest.approx(0.1 / 0.3)


def test_a_cable_drawn_aside() -> None:
    rate = (_turned(2 + 1e-5) - _turned(2 - 1e-5)) / 2e-5
    assert float(solve(ASIDE)["omega"].values[0]) == pytest.approx(rate, rel=1e-6)
