"""A body that stands on a surface with one corner and comes down on it with another: that one strikes too."""

from __future__ import annotations

from math import radians, sin, sqrt

import pytest
from answered import number, solve

G = 9.81
ROD = """
title: Rod that slips down on a smooth floor until it lies flat
plane: vertical
given: {{m: 8 kg, L: 1.5 m}}
points: {{A: [0, 0], B: {{from: A, distance: L, angle: {angle}}}}}
surfaces: {{floor: {{through: A, angle: 0 deg}}{more}}}
bodies: {{rod: {{rod: [A, B], mass: m}}}}
joints:
  - contact: {{between: [rod, floor], at: A, mu: 0}}
  - {strikes}
states:
  1: [t = 0, at rest]
  flat: [y(B) = 0]
  lies: [just after flat]
find:
  before: omega(rod) @ flat
  after: omega(rod) @ lies
  J_B: impulse(clap/rod).y @ flat->lies
  J_A: impulse(A/rod).y @ flat->lies
"""
IMPACT = "impact: {{between: [rod, {}], at: B, restitution: {}, name: clap{}}}"
BETWEEN = ", during: flat->lies"
BLOCK = """
title: Tilted block falls back on its face
plane: vertical
given: {m: 20 kg, b: 0.4 m, h: 0.8 m}
points:
  A: [0, 0]
  D: {from: A, distance: b, angle: 10 deg}
  M: {midpoint: [A, D]}
  G: {from: M, distance: h/2, angle: 100 deg}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {block: {plate: G, width: b, height: h, angle: 10 deg, mass: m, points: [A, D]}}
joints:
  - contact: {between: [block, floor], at: A, mu: 0.6}
  - impact: {between: [block, floor], at: D, restitution: 0, mu: 0.6, during: 2->3, name: slap}
states:
  1: [t = 0, at rest]
  2: [theta(block) = 0]
  3: [just after 2]
find: {before: omega(block) @ 2, after: omega(block) @ 3}
"""


def _rod(strikes: str, angle: str = "60 deg", more: str = "") -> dict[str, float]:
    found = solve(ROD.format(strikes=strikes, angle=angle, more=more))
    return {name: float(number(f)) for name, f in found.items()}


@pytest.mark.parametrize("restitution", [0.0, 0.5])
@pytest.mark.parametrize("during", ["", BETWEEN])
@pytest.mark.parametrize("more", ["", ", table: {through: A, angle: 0 deg}"])
def test_the_other_end_strikes_the_same_floor(restitution: float, during: str, more: str) -> None:
    """As it does a second floor on the same line. From v_B and J_A, J_B: both ends stay on, or leave, the floor."""
    found = _rod(IMPACT.format("table" if more else "floor", restitution, during), more=more)
    omega = sqrt(3 * G * sin(radians(60)) / 1.5)
    assert found["before"] == pytest.approx(-omega, rel=1e-6)
    assert found["after"] == pytest.approx(restitution * omega, abs=1e-6)
    assert found["J_B"] == pytest.approx((1 + restitution) * 8 * 1.5 * omega / 3, rel=1e-6)
    assert found["J_A"] == pytest.approx((1 + restitution) * 8 * 1.5 * omega / 6, rel=1e-6)


def test_a_contact_that_takes_hold_there_stops_it() -> None:
    found = _rod("contact: {between: [rod, floor], at: B, mu: 0, name: clap, during: flat->lies}")
    assert found["after"] == pytest.approx(0, abs=1e-9)
    assert found["J_B"] == pytest.approx(8 * sqrt(3 * G * sin(radians(60)) * 1.5) / 3, rel=1e-6)


def test_it_does_not_fall_through() -> None:
    """Nobody dates the blow: it happens where the end arrives, and the rod lies there."""
    text = ROD.format(strikes=IMPACT.format("floor", 0, ""), angle="60 deg", more="")
    head = text.partition("states:")[0]
    found = solve(f"{head}states: {{1: [t = 0, at rest], 2: [t = 1 s]}}\nfind: {{y: y(B) @ 2, N: N(A) @ 2}}\n")
    assert float(number(found["y"])) == pytest.approx(0, abs=1e-6)
    assert float(number(found["N"])) == pytest.approx(8 * G / 2, rel=1e-6)


def test_a_block_rocks_back() -> None:
    """About D after the blow: I_D ω' = I_A ω - m b² ω/2, with I_A = m (b² + h²)/3."""
    found = solve(BLOCK)
    b, h = 0.4, 0.8
    i_a = (b**2 + h**2) / 3
    ratio = float(number(found["after"]) / number(found["before"]))
    assert ratio == pytest.approx((i_a - b**2 / 2) / i_a, rel=1e-6)
