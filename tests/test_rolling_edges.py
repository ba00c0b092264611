"""A straight edge that rolls on a rim: the normal turns with the edge; as much of it as of the rim passes the foot."""

from __future__ import annotations

import math

from answered import assert_close, solve
from mpmath import cos, findroot, sin

PLANK = """
title: Plank that rocks on a fixed trunk
plane: vertical
given: {R: 0.5 m, L: 2 m, m: 10 kg}
points: {O: [0, 0], A: [-L/2, R], B: [L/2, R], C: [0, R]}
surfaces: {trunk: {center: O, radius: R}}
bodies: {plank: {rod: [A, B], mass: m}}
joints:
  - rolling: {between: [plank, trunk], at: C}
"""

SWINGS = """
states: {1: [t = 0, omega(plank) = 1 rad/s], 2: [omega(plank) = 0]}
find: {phi: theta(plank) @ 2 in rad, x: x(plank) @ 2, t: t @ 2, N_1: N(C) @ 1, N_2: N(C) @ 2}
"""

RACK = """
title: Rack on a pinion that is run up
points: {C: [0.4 m, 0], D: [0.2 m, -40 mm], E: [0.6 m, -40 mm]}
bodies: {pinion: {disk: C, radius: 40 mm}, rack: {rod: [D, E]}}
joints:
  - pin: {at: C, between: [ground, pinion]}
  - rolling: {between: [pinion, rack]}
  - guide: {body: rack, along: 0 deg}
motion: [alpha(pinion) = 4 rad/s^2]
states: {1: [t = 0, omega(pinion) = 0], 2: [t = 3 s]}
find: {v: v(rack).x @ 2, s: x(rack) @ 2 - x(rack) @ 1}
"""


def test_a_plank_on_a_trunk() -> None:
    """Centre at R (-sin θ + θ cos θ, cos θ + θ sin θ); (L²/12 + R² θ²) θ̈ = -R² θ θ̇² - g R θ cos θ."""
    g, r, own = 9.81, 0.5, 1 / 3
    found = solve(PLANK + SWINGS)
    phi = float(findroot(lambda q: own / 2 - g * r * (cos(q) + q * sin(q) - 1), 0.26))
    assert_close(found["phi"], phi)
    assert_close(found["x"], r * (phi * math.cos(phi) - math.sin(phi)))
    assert_close(found["N_1"], 10 * (g + r))
    turning = -g * r * phi * math.cos(phi) / (own + r**2 * phi**2)
    assert_close(found["N_2"], 10 * (r * phi * turning + g * math.cos(phi)))
    # ∫ dθ/θ̇ from 0 to phi, of the equation of motion integrated by itself.
    assert_close(found["t"], 0.42022046671, 9)


def test_its_small_oscillations() -> None:
    found = solve(PLANK + "states: {eq: [equilibrium]}\nfind: {T: period(eq)}\n")
    assert_close(found["T"], 2 * math.pi * math.sqrt(2**2 / 12 / (9.81 * 0.5)))


def test_a_rack_over_time() -> None:
    found = solve(RACK)
    assert_close(found["v"], 12 * 0.04)
    assert_close(found["s"], 18 * 0.04)
