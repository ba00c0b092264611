"""In which unit an answer is shown where nobody asks for one."""

from __future__ import annotations

from answered import solve

DECLARED = """
title: A rod at an angle that is sought
plane: vertical
given: {m: 2 kg, l: 0.8 m, M: 4 N*m}
unknowns: {beta: deg}
points: {O: [0, 0], A: [l*cos(beta), l*sin(beta)]}
bodies: {rod: {rod: [O, A], mass: m}}
joints: [{pin: {at: O, between: [ground, rod]}}]
loads: [{torque: {body: rod, moment: M}}]
instant: [at rest, alpha(rod) = 0, beta > 0]
find: {beta: beta}
"""


def test_an_unknown_is_shown_in_the_unit_with_which_it_is_declared() -> None:
    found = solve(DECLARED)["beta"]
    assert found.unit.text == "deg"
