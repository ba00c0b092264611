"""By d'Alembert's principle one side of a balance is zero, also where the page counts in numbers."""

from __future__ import annotations

from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ROD = """plane: vertical
method: dalembert
points: {O: [0, 0], B: [1 m, 0]}
bodies: {rod: {rod: [O, B], mass: 4 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
instant: [at rest]
find: {alpha: alpha(rod), R: reaction(O).y}
"""


def test_a_balance_with_nothing_on_its_right() -> None:
    """α = 3 g/(2 l) clockwise, R = m g/4."""
    problem, wrong = load_text(ROD)
    assert problem is not None, wrong
    page = " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
    assert "↻ ΣM_O: 4 · 9.81 · 0.5 - 1.333 α = 0 in N·m" in page
    assert "α = 14.715 rad/s² clockwise" in page
    assert "R = O_y = 9.81 N" in page


def test_inertial_forces_and_their_check() -> None:
    """They oppose the accelerations, and their sum with the forces about another point is zero too."""
    page = page_of_file("ex-4-15")
    assert "The inertial force m a opposes the acceleration, the inertial couple I α the angular acceleration." in page
    assert "spool: ↻ ΣM_G = 30 - 17.63 - 12.37 = 0 N·m" in page
    assert "friction would be zero; for a larger k_G it is to the left." in page
