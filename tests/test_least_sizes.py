"""The smallest of what can not be negative: a limit above zero, or zero; of what stands squared the size is meant."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

BANK = """
title: Car on a banked curve
plane: vertical
given: {rho: 150 m, beta: BETA, mu: 0.3}
unknowns: {v: m/s}
points: {C: [0, 0]}
surfaces: {bank: {through: C, angle: beta, body: road}}
bodies:
  road: {points: [C], center: C}
  car: {particle: C, mass: any}
joints:
  - guide: {body: road, along: 0 deg}
  - contact: {between: [car, bank], at: C, mu_s: mu, name: tyres}
motion: [a(road).x = -v^2/rho]
instant: [at rest, mode(tyres) = stick, v is MOST]
find: {v: v}
"""


@pytest.mark.parametrize("most", ["largest", "smallest"])
def test_a_speed_that_stands_squared(most: str) -> None:
    beta, sense = math.radians(25), 1 if most == "largest" else -1
    expected = math.sqrt(150 * 9.81 * math.tan(beta + sense * math.atan(0.3)))
    assert_close(solve(BANK.replace("BETA", "25 deg").replace("MOST", most))["v"], expected)


def test_a_car_that_may_stand() -> None:
    """Friction holds it on a bank of 12 degrees at any small speed."""
    assert_close(solve(BANK.replace("BETA", "12 deg").replace("MOST", "smallest"))["v"], 0)
