"""The least speed at which something lifts off at once: where it only just leaves its path."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution

HUMP = """
title: Car that leaves the top of a hump
plane: vertical
given: {R: 50 m, beta: 0 deg}
unknowns: {v_0: m/s}
points: {C: [0, 0], P: {from: C, distance: R, angle: 90 deg - beta}}
surfaces: {hump: {center: C, radius: R}}
bodies: {car: {particle: P, mass: any}}
joints:
  - contact: {between: [car, hump], at: P, mu: 0, name: road}
instant: [v(car).along(-beta) = v_0, v(car).across(-beta) = 0, mode(road) = apart, v_0 is smallest]
find: {v_0: v_0, a: a(car).y}
"""


@pytest.mark.parametrize("beta", [0, 20])
def test_it_only_just_leaves(beta: int) -> None:
    """m g cos beta = m v²/R."""
    found = solve(HUMP.replace("beta: 0 deg", f"beta: {beta} deg"))
    expected = math.sqrt(9.81 * math.cos(math.radians(beta)) * 50)
    assert [float(found[name].values[0]) for name in ("v_0", "a")] == pytest.approx([expected, -9.81])


def test_the_largest_is_not_bounded() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(HUMP.replace("is smallest", "is largest"))
    assert refused.value.diagnostics[0].code == "PL613"
