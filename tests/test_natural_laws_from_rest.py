"""A law along the velocity of what begins at rest: followed step by step, it has no direction to begin with."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

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
    """The length of a path is followed; that a law of .t would hold for what never moves is no answer."""
    text = BEND.replace("FIRST", "v(A).x = 0").replace("FIND", "s: path_length(A) @ 1->2, a: a(A).mag @ 2")
    with pytest.raises(NoSolution, match=r"\.t of A, which begins at rest: it has no direction there") as told:
        solve(text)
    assert told.value.diagnostics[0].code == "PL556"


def test_what_has_a_speed() -> None:
    """s = v_1 t + a_t t²/2."""
    text = BEND.replace("FIRST", "v(A).x = 1 m/s").replace("FIND", "s: path_length(A) @ 1->2")
    assert float(first(solve(text)["s"])) == pytest.approx(6)


def test_the_speed_that_it_gets() -> None:
    text = BEND.replace("FIRST", "at rest").replace("FIND", "v: v(A).mag @ 2")
    assert float(first(solve(text)["v"])) == pytest.approx(4)
