"""A law along the velocity of what begins at rest: followed step by step, it has no direction to begin with."""

from __future__ import annotations

import pytest
from answered import first, solve

BEND = """surfaces: {bend: {center: [0, 10 m], radius: 10 m}}
bodies: {A: {particle: [0, 0]}}
joints:
  - guide: {point: A, along: bend}
motion: [a(A).t = 2 m/s^2]
states:
  1: [FIRST]
  2: [t = 2 s]
find: {FIND}
"""


def test_it_does_not_stay_at_rest() -> None:
    """That v_x is zero says that it rests where its path goes along x: s = a_t t²/2, a_n = (a_t t)²/r."""
    text = BEND.replace("FIRST", "v(A).x = 0").replace("FIND", "s: path_length(A) @ 1->2, a: a(A).mag @ 2")
    found = solve(text)
    assert float(first(found["s"])) == pytest.approx(4)
    assert float(first(found["a"])) == pytest.approx((2**2 + 1.6**2) ** 0.5)


def test_what_has_a_speed() -> None:
    """s = v_1 t + a_t t²/2."""
    text = BEND.replace("FIRST", "v(A).x = 1 m/s").replace("FIND", "s: path_length(A) @ 1->2")
    assert float(first(solve(text)["s"])) == pytest.approx(6)


def test_the_speed_that_it_gets() -> None:
    text = BEND.replace("FIRST", "at rest").replace("FIND", "v: v(A).mag @ 2")
    assert float(first(solve(text)["v"])) == pytest.approx(4)
