"""A wheel whose centre the file writes with a coordinate: how far it rolls follows from the way of its centre."""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt

import pytest
from answered import first, solve

WALL = """
title: Rod on a wall and a wheel
plane: vertical
given: {m: 12 kg, m_w: 4 kg, l: 1.2 m, R: 0.15 m, BEGIN: 60 deg}
coordinates: {theta: deg}
points:
  K: [0, R]
  Q: [0, 0]
  B: {from: K, distance: l*cos(theta), angle: 0 deg}
  A: {from: K, distance: l*sin(theta), angle: 90 deg}
  C: {from: B, distance: R, angle: -90 deg}
surfaces:
  floor: {through: Q, angle: 0 deg}
bodies:
  AB: {rod: [A, B], mass: m}
  wheel: {disk: B, radius: R, mass: m_w}
joints:
  - pin: {at: B, between: [AB, wheel]}
  - rolling: {between: [wheel, floor]AT}
  - guide: {point: A, along: 90 deg}
states:
  1: [theta = BEGIN, at rest]
  2: [theta = 30 deg]
find:
  omega: omega(AB) @ 2
  turned: theta(wheel) @ 2 - theta(wheel) @ 1
"""
SLOPE = """
title: Wheel down a slope
plane: vertical
given: {m: 2 kg, R: 0.3 m, beta: 20 deg, BEGIN: 0.1 m, d: 2 m}
coordinates: {s: m}
points:
  Q: [0, 0]
  C: {from: Q, distance: s, angle: -beta}
  G: {from: C, distance: R, angle: 90 deg - beta}
surfaces: {slope: {through: Q, angle: -beta}}
bodies: {wheel: {disk: G, radius: R, mass: m}}
joints:
  - rolling: {between: [wheel, slope]AT}
states:
  1: [t = 0, s = BEGIN, at rest]
  2: [s = BEGIN + d]
find: {omega: omega(wheel) @ 2, turned: theta(wheel) @ 2 - theta(wheel) @ 1}
"""
WAYS = [(name, at) for name in ("beginning", "0") for at in ("", ", at: C")]


def _written(text: str, coordinate: str, name: str, at: str) -> str:
    """With a name for the place where it begins, which may be one that a coordinate's start could have too."""
    begin = f"{coordinate}_0" if name == "0" else name
    return text.replace("BEGIN", begin).replace("AT}", f"{at}}}")


@pytest.mark.parametrize(("name", "at"), WAYS)
def test_a_rod_that_pushes_a_wheel_away(name: str, at: str) -> None:
    """m g l (sin 60° - sin 30°)/2 = m l² ω²/6 + 3/4 m_w (l ω sin 30°)²; R Δφ = -l (cos 30° - cos 60°)."""
    found = solve(_written(WALL, "theta", name, at))
    work = 12 * 9.81 * 0.6 * (sin(radians(60)) - sin(radians(30)))
    assert first(found["omega"]) == pytest.approx(sqrt(work / (12 * 1.44 / 6 + 0.75 * 4 * 1.44 / 4)))
    assert first(found["turned"]) == pytest.approx(-1.2 * (cos(radians(30)) - cos(radians(60))) / 0.15)


@pytest.mark.parametrize(("name", "at"), WAYS)
def test_a_wheel_down_a_slope(name: str, at: str) -> None:
    """v² = 4/3 g d sin β."""
    found = solve(_written(SLOPE, "s", name, at))
    assert first(found["omega"]) == pytest.approx(-sqrt(4 / 3 * 9.81 * 2 * sin(pi / 9)) / 0.3)
    assert first(found["turned"]) == pytest.approx(-2 / 0.3)
