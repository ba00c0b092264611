"""What is largest or smallest where an inequality of its state only just holds (solve/bounds.py)."""

from __future__ import annotations

import pytest
from answered import assert_close

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BUFFER = """
title: The stiffest buffer that presses with less than 60 N
plane: horizontal
unknowns: {k: N/m}
points: {O: [0, 0], P: [1 m, 0]}
bodies: {b: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: 1 m, name: buffer}
states:
  1: [v(b).x = -3 m/s]
  2: [v(b).x = 0, "tension(buffer) >= -60 N", k is largest]
find: {value: k}
"""


@pytest.mark.parametrize("limit", ["tension(buffer) >= -60 N", "-tension(buffer) < 60 N"])
def test_a_force_that_stays_below_its_limit(limit: str) -> None:
    """m v²/2 = F²/(2 k), so that k = F²/(m v²) = 3600/18 N/m."""
    problem, wrong = load_text(BUFFER.replace("tension(buffer) >= -60 N", limit))
    assert problem is not None, wrong
    solution = solve_problem(problem)
    assert_close(solution.parts[0].found[0], 200)
    page = " ".join(Terminal(400).render(narrate(solution)).split())
    assert "k is largest where its bound is reached, " + limit.replace(">=", "=").replace("<", "=") in page


BANKED = """
title: Banked curve
plane: vertical
given: {m: 1200 kg, R: 80 m, beta: 10 deg, mu_s: 0.3}
unknowns: {v: m/s}
points: {P: [0, 0]}
surfaces: {road: {through: P, angle: -beta}}
bodies: {car: {particle: P, mass: m}}
joints:
  - contact: {between: [car, road], at: P, mu_s: mu_s, name: C}
instant: [mode(C) = stick, a(P).x = -v^2/R, v is largest]
find: {v: v}
"""


def test_what_the_other_relations_fix_is_not_largest() -> None:
    """On a road that is fixed in the drawing a car that sticks has no acceleration, so that v = 0 is all there is."""
    problem, wrong = load_text(BANKED)
    assert problem is not None, wrong
    with pytest.raises(
        NoSolution, match=r"^the other relations fix v already, at 0: nothing is left for which it could be largest$"
    ):
        solve_problem(problem)
