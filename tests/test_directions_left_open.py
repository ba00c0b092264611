"""Energy alone tells how fast something is; which way it moves must come from elsewhere, and is asked for."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem

THROW = """
title: Ball thrown at a slant, by energy
plane: vertical
method: energy
given: {m: 2 kg}
points: {A: [0, 0]}
bodies: {ball: {particle: A, mass: m}}
states:
  1: [t = 0, v(ball).mag = 10 m/s, v(ball).angle = 50 deg]
  2: [y(ball) = 2 m]
find: {v: v(ball).mag @ 2}
"""
CHUTE = """
title: Ball down a chute of which the form is not told
plane: vertical
method: energy
points: {A: [0, 3 m]}
bodies: {ball: {particle: A, mass: 2 kg}}
states:
  1: [at rest]
  2: [x(ball) = 4 m, y(ball) = 0]
find: {v: v(ball).mag @ 2}
"""


@pytest.mark.parametrize("text", [THROW, CHUTE])
def test_the_direction_is_asked_for(text: str) -> None:
    with pytest.raises(FileProblem) as refused:
        solve(text)
    (why,) = refused.value.diagnostics
    assert why.code == "PL570"
    assert "gives one equation for the rate of x of A in state 2 and the rate of y of A in state 2" in why.message
    assert "`v(ball).angle = -30 deg`" in (why.hint or "")


def test_with_the_direction_energy_gives_the_speed() -> None:
    found = solve(CHUTE.replace("y(ball) = 0]", "y(ball) = 0, v(ball).angle = -30 deg]"))
    assert first(found["v"]) == pytest.approx((2 * 9.81 * 3) ** 0.5)
