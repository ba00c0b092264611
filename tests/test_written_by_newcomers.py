"""Problems as a newcomer writes them, with answers worked out by hand: what once was refused or undecided."""

from __future__ import annotations

import math

import pytest
from answered import solve

HOHMANN = """
title: Hohmann transfer
plane: horizontal
given: {mu_E: 3.986e14 m^3/s^2, r_1: 6778 km, r_2: 42164 km}
unknowns: {v_1: m/s}
points: {O: [0, 0], S: [r_1, 0]}
bodies: {sat: {particle: S, mass: 500 kg}}
loads:
  - force: {body: sat, magnitude: mu_E*mass(sat)/r(sat/O).mag^2, towards: O}
states:
  1: [v(sat).x = 0, v(sat).y = v_1]
  2: [r(sat/O).mag is largest, r(sat/O).mag = r_2]
find: {v_1: v_1, v_2: v(sat).mag @ 2}
"""
SPRINGS = """
title: Three springs at a knot
plane: horizontal
given: {k: 200 N/m, F: 30 N}
unknowns: {x: m, y: m}
points: {A: [-1 m, 0], B: [0.5 m, 0.8 m], C: [0.5 m, -0.8 m], K: [x, y]}
bodies: {K: {particle: K, mass: 1 kg}}
loads:
  - spring: {between: [A, K], stiffness: k, natural_length: 0.8 m}
  - spring: {between: [B, K], stiffness: k, natural_length: 0.8 m}
  - spring: {between: [C, K], stiffness: k, natural_length: 0.8 m}
  - force: {body: K, magnitude: F, angle: 0 deg}
instant: [at rest, equilibrium]
find: {x: x, y: y}
"""
FALLING = """
title: Rod named from its free end, falls from upright past 180 degrees
plane: vertical
given: {L: 1 m, m: 2 kg}
points: {A: [0, 0], B: [-0.6 m, 0.8 m]}
bodies: {rod: {rod: [B, A], mass: m}}
joints:
  - pin: {at: A, between: [ground, rod]}
states:
  1: [at rest]
  2: [y(B) = -L]
find: {w: omega(rod) @ 2}
"""
FLYWHEEL = """
title: Flywheel brought to rest by friction torque proportional to its speed
plane: horizontal
given: {I: 5 kg*m^2, c: 0.4 N*m*s}
points: {O: [0, 0]}
bodies: {wheel: {disk: O, mass: 20 kg, inertia: I}}
joints:
  - pin: {at: O, between: [ground, wheel]}
loads:
  - torque: {body: wheel, moment: -c*omega(wheel)}
states:
  1: [t = 0, omega(wheel) = 1200 rpm]
  2: [omega(wheel) = 300 rpm]
find: {t: t @ 2, n: theta(wheel) @ 2 - theta(wheel) @ 1 in rev}
"""


def _found(text: str) -> dict[str, float]:
    return {name: float(f.values[0]) for name, f in solve(text).items()}


def test_the_speeds_of_a_transfer_orbit() -> None:
    """v² = 2 k (1/r - 1/(r_1 + r_2))."""
    k, near, far = 3.986e14, 6778e3, 42164e3
    expected = {f"v_{i}": math.sqrt(2 * k * (1 / r - 1 / (near + far))) for i, r in ((1, near), (2, far))}
    assert _found(HOHMANN) == pytest.approx(expected)


def test_three_springs_at_a_knot_placed_by_coordinates() -> None:
    """Where the forces along x balance, on the axis of symmetry."""
    found = _found(SPRINGS)
    x = found["x"]
    slant = math.hypot(0.5 - x, 0.8)
    forces = 30 - 200 * (1 + x - 0.8) + 2 * 200 * (slant - 0.8) * (0.5 - x) / slant
    assert (forces, found["y"]) == pytest.approx((0, 0), abs=1e-9)


def test_a_rod_named_from_its_free_end_that_falls_past_180_degrees() -> None:
    """m g (0.8 m + L) = I_A ω²/2."""
    assert abs(_found(FALLING)["w"]) == pytest.approx(math.sqrt(3 * 9.81 * 1.8))


def test_a_torque_in_proportion_to_the_angular_velocity() -> None:
    """t = I/c ln(ω_1/ω_2), φ = I/c (ω_1 - ω_2)."""
    found = _found(FLYWHEEL)
    assert found["t"] == pytest.approx(5 / 0.4 * math.log(4))
    assert found["n"] == pytest.approx(5 / 0.4 * 900 * 2 * math.pi / 60)
