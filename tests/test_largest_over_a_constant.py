"""What is largest over a sought constant: the one that the relations allow; where several fit, the file must choose."""

from __future__ import annotations

from math import pi, sin

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

THROW = """
title: Longest throw along a slope
plane: vertical
unknowns: {beta: deg}
bodies: {P: {particle: [0, 0], mass: any}}
states:
  throw: [t = 0, v(P).mag = 10 m/s, v(P).angle = beta]
  lands: [y(P) = x(P)*tan(%s deg), r(P).mag is largest%s]
find: {d: r(P).mag @ lands, beta: beta}
"""


@pytest.mark.parametrize("slope", [30, 0, -30])
@pytest.mark.parametrize("way", [1, -1])
def test_the_side_that_is_stated(slope: float, way: int) -> None:
    """v²/(g (1 + sin)) along a slope that rises, at 45 deg + half of it; the other side is a slope that falls."""
    found = solve(THROW % (slope, f", x(P) {'>' if way > 0 else '<'} 0"))
    rise = way * slope * pi / 180
    assert first(found["d"]) == pytest.approx(100 / (9.81 * (1 + sin(rise))))
    assert first(found["beta"]) == pytest.approx(pi / 2 - way * (pi / 4 - rise / 2))


@pytest.mark.parametrize("slope", [30, 0, -30])
def test_two_sides_fit(slope: float) -> None:
    with pytest.raises(NoSolution, match=r"is largest` in several ways: beta = .*; beta = ") as wrong:
        solve(THROW % (slope, ""))
    assert "`x(P) > 0`" in (wrong.value.diagnostics[0].hint or "")


def test_a_smallest_value_is_no_other_way() -> None:
    """x is stationary on both sides, but largest only ahead: the throw behind is the smallest."""
    found = solve((THROW % (0, "")).replace("r(P).mag is", "x(P) is"))
    assert first(found["d"]) == pytest.approx(100 / 9.81)
    assert first(found["beta"]) == pytest.approx(pi / 4)
