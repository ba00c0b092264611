"""A force of a fixed direction at the rim or the hub of a wheel is not the pull of a cord: that is told."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

WHEEL = """plane: horizontal
points: {O: [0, 0], T: [0, 0.2 m], H: [0, 0.15 m], Q: [0, 0.1 m]}
bodies: {w: {disk: O, radius: 0.2 m, hub: 0.15 m, mass: 4 kg, points: [Q]}}
joints:
  - pin: {at: O, between: [ground, w]}
loads:
  - force: {body: w, ACTS, magnitude: 30 N, angle: 0 deg}
states:
  1: [at rest]
  2: [theta(w) = -60 deg]
find: {w: omega(w) @ 2}
"""


@pytest.mark.parametrize(
    ("acts", "told"), [("at: T", "rim"), ("wound_at: T", ""), ("at: Q", ""), ("at: H", "hub"), ("wound_at: H", "")]
)
def test_what_the_page_says(acts: str, told: str) -> None:
    problem, wrong = load_text(WHEEL.replace("ACTS", acts))
    assert problem is not None, wrong
    page = " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
    moves = f"The force at {acts[-1]} moves on with that point of w; a cord would go on pulling where it leaves the "
    assert (moves in page) == bool(told)
    assert f"{moves}{told}." in page or not told
