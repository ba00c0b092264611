"""By d'Alembert's principle one side of a balance is zero, also where the page counts in numbers."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
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
