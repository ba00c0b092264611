"""A speed that is given by its size all the time goes the way that a relation of the first state tells."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution

SLIDER = """
title: A rod whose ends slide on a floor and a wall
given: {u: 2 m/s}
points: {A: [0.6 m, 0], B: [0, 0.8 m]}
bodies: {rod: {rod: [A, B]}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
motion: [v(A).mag = u]
states:
  1: [t = 0, TOLD]
  2: [t = 0.1 s]
find: {x: x(A) @ 2, w: omega(rod) @ 2}
"""


@pytest.mark.parametrize(
    ("told", "sense"),
    [
        ("v(A).x > 0", 1), ("v(A).x < 0", -1), ("0 m/s > v(A).x", -1), ("v(A).x = -u", -1), ("v(A).x = u", 1),
        ("v(B).y > 0", -1), ("omega(rod) > 0", 1), ("omega(rod) < 0", -1), ("v(A).x < -1 m/s", -1),
    ],
)  # fmt: skip
def test_the_way_is_told(told: str, sense: int) -> None:
    """x = 0.6 m ± u t; y = √(l² - x²), and v_A = ω y."""
    found = solve(SLIDER.replace("TOLD", told))
    x = 0.6 + 0.2 * sense
    assert [float(found[n].values[0]) for n in ("x", "w")] == pytest.approx([x, 2 * sense / math.sqrt(1 - x * x)])


@pytest.mark.parametrize("told", ["v(A).x < -3 m/s", "v(A).x = 1 m/s"])
def test_what_contradicts_the_size_is_refused(told: str) -> None:
    with pytest.raises(NoSolution) as raised:
        solve(SLIDER.replace("TOLD", told))
    assert raised.value.diagnostics[0].mark.line == 11
