"""A piston where its speed is greatest: looked for as an extreme, and as the place where it has no acceleration.

There the acceleration of one body has cancelled beside those of the others, and relations of the coordinate repeat
those of the joints. The place is worked out here from the formula of the stroke.
"""

from __future__ import annotations

from decimal import Decimal

import mpmath
import pytest
from answered import assert_close, solve

from planar_cli.solve.multibody.agreement import ENOUGH, FULL, agreeing

ENGINE = """
title: Engine
given: {r: 75 mm, l: 200 mm}
coordinates: {theta: deg}
points:
  A: [0, 0]
  B: {from: A, distance: r, angle: theta}
  D: {y: 0, distances: {B: l}, side: right}
bodies: {crank: {rod: [A, B]}, rod: {rod: [B, D]}, piston: {particle: D}}
joints:
  - pin: {at: A, between: [ground, crank]}
  - pin: {at: B, between: [crank, rod]}
  - pin: {at: D, between: [rod, piston]}
  - guide: {point: D, along: 0 deg}
motion: [omega(crank) = 2000 rpm cw]
"""


def fastest() -> mpmath.mpf:
    """The angle [rad] at which r cos θ + √(l² - r² sin² θ) changes most quickly."""

    def stroke(t: mpmath.mpf) -> mpmath.mpf:
        return 75 * mpmath.cos(t) + mpmath.sqrt(200**2 - (75 * mpmath.sin(t)) ** 2)

    return mpmath.findroot(lambda t: mpmath.diff(stroke, t, 2), 1.2)


@pytest.mark.parametrize("told", ["v(piston).x is largest", "a(piston).x = 0"])
def test_where_it_is_fastest(told: str) -> None:
    solved = solve(f"{ENGINE}\ninstant: ['{told}', theta > 0, theta < 180 deg]\nfind: {{theta: theta}}")
    assert_close(solved["theta"], mpmath.nstr(fastest(), 15))


def test_what_has_cancelled_is_measured_beside_the_largest_of_its_kind() -> None:
    left, largest = Decimal("-3.6e-42"), Decimal(5000)
    assert ENOUGH <= agreeing(left, Decimal(0), largest) <= FULL
    assert agreeing(Decimal("-3.6e-3"), Decimal(0), largest) < ENOUGH
    assert agreeing(left, Decimal(0), Decimal("1e-40")) < ENOUGH
