"""States that are each complete by velocities: nothing drives what has no mass, and no motion joins the states."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Confirmation

TWO = """
title: One point at two times
bodies: {P: {particle: [0, 0]}}
states:
  slow: [v(P).x = 15 km/h, v(P).y = 0]
  fast: [v(P).x = 0, v(P).y = 25 km/h]
find: {a: v(P).mag @ slow, b: v(P).y @ fast}
"""
WIND = """
title: Wind as a cyclist feels it
unknowns: {w: km/h, beta: deg}
bodies: {man: {particle: [0, 0]}, wind: {particle: [10 m, 5 m]}}
motion: [v(wind).x = w*cos(beta), v(wind).y = w*sin(beta)]
states:
  slow: [v(man).x = 0, v(man).y = 15 km/h, v(wind/man).angle = 0]
  fast: [v(man).x = 0, v(man).y = 25 km/h, v(wind/man).angle = -45 deg]
  turned: [v(man).mag = 20 km/h, v(man).angle = 30 deg]
find: {w: w, beta: beta, felt: v(wind/man).mag @ turned}
"""
TURNED = """
title: A rod at two times
points: {A: [0, 0], B: [1 m, 0]}
bodies: {rod: {rod: [A, B]}}
states:
  slow: [v(A).x = 1 m/s, v(A).y = 0, omega(rod) = 2 rad/s]
  fast: [v(A).x = 0, v(A).y = 1 m/s, omega(rod) = 3 rad/s]
find: {a: v(B).y @ slow, b: omega(rod) @ fast}
"""


def _confirmed(text: str) -> Confirmation:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    found = solve_problem(problem).parts[0].confirmed
    assert found is not None
    return found


def test_a_point_at_two_times() -> None:
    found = solve(TWO)
    assert (first(found["a"]), first(found["b"])) == pytest.approx((15 / 3.6, 25 / 3.6))
    assert _confirmed(TWO).finds == {"a", "b"}


def test_a_wind_that_two_states_tell() -> None:
    """The wind is w = (10, 15) km/h: seen from the west at 15 km/h, from the north-west at 25 km/h."""
    found = solve(WIND)
    assert first(found["w"]) == pytest.approx(math.hypot(10, 15) / 3.6)
    assert first(found["beta"]) == pytest.approx(math.atan2(15, 10))
    seen = 10 - 20 * math.cos(math.radians(30)), 15 - 10
    assert first(found["felt"]) == pytest.approx(math.hypot(*seen) / 3.6)
    assert "felt" in _confirmed(WIND).finds


@pytest.mark.slow
def test_what_rests_on_a_place_is_not_compared() -> None:
    """How the rod lies in the later state nobody tells."""
    assert first(solve(TURNED)["b"]) == pytest.approx(3)
    assert "nothing drives rod" in _confirmed(TURNED).apart["b"]
