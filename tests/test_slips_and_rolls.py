"""What slips from the start of a motion, and what rolls at a state, is told by the velocity at the contact."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


@pytest.mark.parametrize(("stem", "said"), [
    # After a blow, by the velocity that it makes; from the start by what is given.
    ("billiard-ball", "Motion the ball slips at C: at 2, v_C = v_G,2 - R ω_2 = J/m to the right"),
    ("spinning-wheel-set-down", "Motion the wheel slips at C: at 1, v_C = -R w to the left"),
    ("ball-with-backspin", "Motion the ball slips at C: at 1, v_C = v_0 + r w = 4 + 0.1 · 120 = 16 m/s to the right"),
    ("billiard-ball", "At 2, the ball rolls without slipping: (2) v_G,2 = R ω_2"),
    ("spinning-wheel-set-down", "At 2, the wheel rolls without slipping: (4) v_G,2 = -R ω_2"),
])  # fmt: skip
def test_the_velocity_at_the_contact_is_told(stem: str, said: str) -> None:
    assert said in page_of_file(stem)


def test_what_is_found_later_is_no_reason() -> None:
    """The backspin that stops the ball is sought: that it slips is assumed."""
    page = page_of_file("ball-with-backspin")
    assert "Assume ball at C slips" in page[page.index("CASE stopping") :]


ON_A_BELT = """
title: Ball thrown on to a belt that runs against it
plane: vertical
symbols: {m: kg, R: m, v0: m/s, u: m/s, mu: 1}
points: {C: [0, 0], G: [0, R]}
surfaces: {belt: {through: C, angle: 0 deg, speed: -u}}
bodies: {ball: {sphere: G, radius: R, mass: m}}
joints:
  - contact: {between: [ball, belt], at: C, mu: mu}
states:
  1: [t = 0, v(G).x = v0, omega(ball) = 0]
  2: [v(G).x = -omega(ball)*R]
find: {t_2: t @ 2}
"""


def test_on_a_belt_that_runs_the_velocity_of_the_ball_alone_tells_nothing() -> None:
    problem, _ = load_text(ON_A_BELT)
    assert problem is not None
    page = Terminal().render(narrate(solve_problem(problem)))
    assert "Assume      ball at C slips" in page
    assert "rolls without slipping" not in page
