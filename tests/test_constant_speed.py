"""Forces on what moves without acceleration, and the least of them: no equation is left out with the acceleration."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from answered import first, solve

HAULED = """
title: Crate hauled up a slope at constant speed
plane: vertical
{known}
points: {{C: [0, 0]}}
surfaces: {{slope: {{through: C, angle: beta}}}}
bodies: {{crate: {{particle: C, mass: m}}}}
joints:
  - contact: {{between: [crate, slope], at: C, mu: mu}}
loads:
  - force: {{body: crate, magnitude: P, angle: alpha + beta}}
instant: [v(crate).along(beta) > 0, a(crate).along(beta) = 0{extreme}]
find: {{{find}}}
"""
NUMBERS = "given: {m: 10 kg, mu: 0.3, beta: 20 deg}"
BETA = math.radians(20)


def test_a_force_that_keeps_a_speed() -> None:
    known = NUMBERS.replace("}", ", alpha: 10 deg}") + "\nunknowns: {P: N}"
    found = solve(HAULED.format(known=known, extreme="", find="P: P, N: N(C)"))
    alpha = math.radians(10)
    force = 98.1 * (math.sin(BETA) + 0.3 * math.cos(BETA)) / (math.cos(alpha) + 0.3 * math.sin(alpha))
    assert first(found["P"]) == pytest.approx(force)
    assert first(found["N"]) == pytest.approx(98.1 * math.cos(BETA) - force * math.sin(alpha))


def test_the_same_in_letters() -> None:
    known = "symbols: {m: kg, mu: 1, beta: deg, alpha: deg}\nunknowns: {P: N}"
    found = solve(HAULED.format(known=known, extreme="", find="P: P"))["P"].expressions
    m, mu, beta, alpha, g = sp.symbols("m mu beta alpha g", positive=True)
    force = m * g * (sp.sin(beta) + mu * sp.cos(beta)) / (sp.cos(alpha) + mu * sp.sin(alpha))
    assert found is not None
    assert sp.simplify(found[0] - force) == 0


def test_the_least_force() -> None:
    """Not the force that lifts it, where the contact is at its limit too, nor the same force with two minus signs."""
    known = f"{NUMBERS}\nunknowns: {{P: N, alpha: deg}}"
    found = solve(HAULED.format(known=known, extreme=", P is smallest", find="P: P, alpha: alpha"))
    assert first(found["alpha"]) == pytest.approx(math.atan(0.3))
    assert first(found["P"]) == pytest.approx(98.1 * math.sin(BETA + math.atan(0.3)))


CUT = """
title: Bar hung by two inclined cords, one of which has been cut
plane: vertical
symbols: {m: kg, L: m, c: m}
unknowns: {beta: deg}
points: {A: [0, 0], B: [L, 0], P: {from: A, distance: c, angle: 180 deg - beta}}
bodies: {bar: {rod: [A, B], mass: m}}
joints:
  - rope: {path: [P, A], name: left}
instant: [at rest, tension(left) is largest, 0 deg < beta, beta < 80 deg]
find: {beta: beta, T: tension(left)}
"""


def test_the_angle_of_the_largest_tension_in_letters() -> None:
    """T = m g sin β/(1 + 3 sin² β) is largest for sin² β = 1/3: squares of the sine alone have closed roots."""
    found = solve(CUT)
    m, g = sp.symbols("m g", positive=True)
    beta, tension = found["beta"].expressions, found["T"].expressions
    assert beta is not None
    assert tension is not None
    assert float(beta[0]) == pytest.approx(math.asin(1 / math.sqrt(3)))
    assert sp.simplify(tension[0] - m * g / (2 * sp.sqrt(3))) == 0
