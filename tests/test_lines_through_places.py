"""In a list of lines, too, a place may be written where it is used."""

from __future__ import annotations

import pytest
from answered import first, solve

PIN = """
title: Pin in two slots
points:
  O: [0, 0]
MORE
  P: {lines: LINES}
find: {x: x(P), y: y(P)}
"""


@pytest.mark.parametrize(
    "lines",
    [
        "[[O, 60 deg], [[0, 120 mm], 0 deg]]",
        "[[[0, 120 mm], 0 deg], [[0, 0], 60 deg]]",
        "[{through: [0, 120 mm], angle: 0 deg}, {through: O, angle: 60 deg}]",
        "[[O, 60 deg], [{from: O, distance: 120 mm, angle: 90 deg}, 0 deg]]",
    ],
)
def test_a_point_where_two_lines_cross(lines: str) -> None:
    found = solve(PIN.replace("LINES", lines).replace("MORE\n", ""))
    assert (first(found["x"]), first(found["y"])) == pytest.approx((0.12 / 3**0.5, 0.12))
