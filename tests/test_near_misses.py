"""Of states that no value of an unknown leads to it is said how near the motion comes (solve/near_misses.py)."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution

THROW = """
title: Throw at a mark that is too high
plane: vertical
unknowns: {beta: deg}
bodies: {b: {particle: [0, 0], mass: any}}
states:
  1: [t = 0, v(b).mag = 10 m/s, v(b).angle = beta]
  2: [x(b) = 10 m, y(b) = 3 m]
find: {beta: beta}
"""


def test_a_mark_that_is_out_of_reach() -> None:
    """At x it comes as high as v²/(2 g) - g x²/(2 v²) = 0.1918 m, with tan beta = v²/(g x)."""
    with pytest.raises(NoSolution) as refused:
        solve(THROW)
    (told,) = refused.value.diagnostics
    assert told.code == "PL624"
    assert told.message.endswith("the motion comes nearest with beta = 45.55 deg, where the sides differ by 2.808 m")


ESCAPE = """
title: Body that only just escapes
plane: horizontal
unknowns: {u: m/s}
points: {O: [0, 0]}
bodies: {b: {particle: [2 m, 0], mass: 3 kg}}
loads:
  - force: {body: b, towards: O, magnitude: "(12 N*m^2)/r(b/O).mag^2"}
states:
  1: [t = 0, v(b).x = u, v(b).y = 0, u > 0]
  2: [t = infinity, v(b).mag = 0]
find: {u: u}
"""


def test_what_goes_off_without_end_is_told_by_its_place() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(ESCAPE)
    assert "`x(b) = infinity` for `t = infinity`" in refused.value.diagnostics[0].hint
    # m u²/2 = 12 N m²/(2 m)
    assert_close(solve(ESCAPE.replace("t = infinity", "x(b) = infinity"))["u"], 2)
