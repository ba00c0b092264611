"""`mode(C)` of a rolling joint, which has one mode only: it does not slip."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

TEXT = """
plane: vertical
given: {m: 2 kg, R: 0.1 m, beta: 20 deg}
points: {C: [0, 0], G: {from: C, distance: R, angle: 90 deg - beta}}
surfaces: {slope: {through: C, angle: -beta}}
bodies: {disk: {disk: G, radius: R, mass: m}}
joints:
  - rolling: {between: [disk, slope], at: C}
instant: [at rest]
find: {a: alpha(disk), how: mode(C), holds: mode(C) = stick, slides: mode(C) = slip}
"""


def test_what_rolls_does_not_slip() -> None:
    problem, wrong = load_text(TEXT)
    assert problem is not None
    assert not wrong
    page = Terminal(100).render(narrate(solve_problem(problem)))
    assert "how: it does not slip" in page
    assert "holds: yes" in page
    assert "slides: no" in page
