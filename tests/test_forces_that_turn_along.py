"""A force of a fixed direction at the rim of a wheel is not the pull of a cord: the page says where it goes."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

WHEEL = """plane: horizontal
points: {O: [0, 0], T: [0, 0.2 m], Q: [0, 0.1 m]}
bodies: {w: {disk: O, radius: 0.2 m, mass: 4 kg, points: [Q]}}
joints:
  - pin: {at: O, between: [ground, w]}
loads:
  - force: {body: w, ACTS, magnitude: 30 N, angle: 0 deg}
states:
  1: [at rest]
  2: [theta(w) = -60 deg]
find: {w: omega(w) @ 2}
"""


@pytest.mark.parametrize(("acts", "told"), [("at: T", True), ("wound_at: T", False), ("at: Q", False)])
def test_what_the_page_says(acts: str, told: bool) -> None:
    problem, wrong = load_text(WHEEL.replace("ACTS", acts))
    assert problem is not None, wrong
    page = " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
    assert ("The force at T moves on with that point of w; a cord would go on pulling" in page) == told
