"""The angle at which what is carried round begins to slip: the position itself is sought, and the carrier is driven."""

from __future__ import annotations

from math import atan, cos, pi, sin

import pytest
from answered import first, solve

DRUM = """
title: Package on a drum
plane: vertical
given: {R: 0.3 m, v: %s m/s}
coordinates: {phi: deg}
points: {O: [0, 0], P: {from: O, distance: R, angle: %s}}
bodies:
  drum: {disk: O, radius: R}
  package: {particle: P, mass: 0.5 kg}
joints:
  - pin: {at: O, between: [ground, drum]}
  - contact: {between: [package, drum], at: P, mu: 0.6}
motion: [omega(drum) = -v/R]
instant: [mode(P) = stick, phi is %s, phi > 0, phi < 90 deg]
find: {phi: phi, N: N(P)}
"""


@pytest.mark.parametrize("speed", [0.5, 1])
@pytest.mark.parametrize(("angle", "sense"), [("90 deg - phi", "largest"), ("phi", "smallest")])
def test_the_angle_of_slip(speed: float, angle: str, sense: str) -> None:
    """sin = mu (cos - v²/(g R)), so sin(phi - friction angle) = -sin(friction angle) v²/(g R).

    What sticks has one speed along the rim; seen along x and y, that is no second fact about the position.
    """
    found = solve(DRUM % (speed, angle, sense))
    from_top = first(found["phi"]) if sense == "largest" else pi / 2 - first(found["phi"])
    assert sin(from_top - atan(0.6)) == pytest.approx(-sin(atan(0.6)) * speed**2 / (9.81 * 0.3))
    assert first(found["N"]) == pytest.approx(0.5 * (9.81 * cos(from_top) - speed**2 / 0.3))
