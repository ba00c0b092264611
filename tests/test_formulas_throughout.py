"""A quantity without a state, of a motion that a state begins: a formula in the place, without numbers."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

ROD = """
title: Rod let go
plane: vertical
given: {L: 2 m}
coordinates: {theta: deg}
points: {A: [0, 0], B: {from: A, distance: L, angle: theta}}
bodies: {rod: {rod: [A, B], mass: 3 kg}}
joints:
  - pin: {at: A, between: [rod, ground]}
states: {1: [theta = 0, at rest]}
find: {w: omega(rod)}
"""


def test_an_angular_velocity_as_a_function_of_the_angle() -> None:
    """From 1/2 I ω² = -m g L/2 sin θ, with I = m L²/3."""
    page = Terminal(110).render(narrate(solve_problem(load_text(ROD)[0])))
    assert "w = θ̇ = -√(-3 g sin θ / L)" in page
