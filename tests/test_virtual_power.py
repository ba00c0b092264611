"""Virtual power in letters: planets on several sides of a sun share a load that no equation divides among them."""

from __future__ import annotations

import sympy as sp
from answered import solve
from worked import page_of_file

PLANETS = """
title: Planets on both sides of a sun
plane: horizontal
symbols: {r: m, m: kg, I: kg*m^2, M: N*m}
points: {O: [0, 0], A: [2*r, 0], B: [-2*r, 0]}
surfaces: {ring: {center: O, radius: 3*r}}
bodies:
  sun: {disk: O, radius: r, mass: m}
  arm: {points: [A, B], center: O, mass: m, inertia: I}
  planet_A: {disk: A, radius: r, mass: m}
  planet_B: {disk: B, radius: r, mass: m}
joints:
  - pin: {at: O, between: [ground, sun, arm]}
  - pin: {at: A, between: [arm, planet_A]}
  - pin: {at: B, between: [arm, planet_B]}
  - rolling: {between: [planet_A, sun], name: sun_A}
  - rolling: {between: [planet_B, sun], name: sun_B}
  - rolling: {between: [planet_A, ring], at: [3*r, 0], name: ring_A}
  - rolling: {between: [planet_B, ring], at: [-3*r, 0], name: ring_B}
loads: [{torque: {body: arm, moment: M}}]
instant: [at rest]
find: {alpha: alpha(arm)}
"""


def test_planets_in_letters() -> None:
    """T = (I + 16 I_sun + 2 (4 m r² + 4 I_planet)) ω²/2 = M θ, with I_sun = I_planet = m r²/2."""
    (alpha,) = solve(PLANETS)["alpha"].expressions or ()
    m, r, inertia, moment = (next(s for s in alpha.free_symbols if s.name == n) for n in ("m", "r", "I", "M"))
    assert sp.simplify(alpha - moment / (inertia + 20 * m * r**2)) == 0


def test_planets_that_start() -> None:
    page = page_of_file("planetary-gear-with-three-planets")
    assert "M = 2 I_sun b α_sun/r_S + (3 m_P b² + I_O) α_spider - I_planet,A b α_planet,A/r_P" in page
    assert "constant angular acceleration" in page
    assert "numerical" not in page.lower()
