"""A coordinate that is given in time is driven where nothing else moves: the drive does work through it alone."""

from __future__ import annotations

from math import atan

import pytest
from answered import assert_close, solve

ROD = """
title: Rod that hangs from a support with a given acceleration
plane: vertical
coordinates: {s: m, theta: deg}
given: {L: 1 m}
points: {A: [s, 0], B: {from: A, distance: L, angle: theta - 90 deg}}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - guide: {point: A, along: 0 deg}
motion: [DRIVEN = 3 m/s^2]
"""
STEADY = (
    ROD + "instant: [alpha(rod) = 0, omega(rod) = 0, theta < 90 deg, theta > -90 deg]\nfind: {value: theta in deg}\n"
)
STARTS = ROD + "instant: [at rest, theta = 0]\nfind: {value: alpha(rod)}\n"


@pytest.mark.parametrize("driven", ["ddot(s)", "a(A).x"])
def test_the_support_is_pushed_and_not_the_middle(driven: str) -> None:
    """tan theta = -a/g; m L²/3 alpha = -m a L/2."""
    assert_close(solve(STEADY.replace("DRIVEN", driven))["value"], -atan(3 / 9.81), 9)
    assert_close(solve(STARTS.replace("DRIVEN", driven))["value"], -4.5, 9)
