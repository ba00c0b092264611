"""Of several faces that press, each distance has its own letter, in the equations and where it is compared."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

STACKED = """
plane: vertical
given: {m_1: 50 kg, m_2: 30 kg, b: 0.6 m, h: 1.2 m, P: 50 N, mu: 0.5}
points: {C: [0, 0], G: [0, h/2], D: [0, h], H: [0, 3*h/2], T: [-b/2, 7*h/4]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies:
  one: {plate: G, width: b, height: h, mass: m_1}
  two: {plate: H, width: b, height: h, mass: m_2, points: [T]}
joints:
  - contact: {between: [one, floor], at: C, mu: mu}
  - contact: {between: [two, one], at: D, mu: mu}
loads: [{force: {body: two, at: T, magnitude: P, angle: 0 deg}}]
instant: [at rest]
find: {stays: mode(C) = stick}
"""


def test_each_face_has_its_letter() -> None:
    problem, wrong = load_text(STACKED)
    assert problem is not None, wrong
    page = " ".join(Terminal(width=200).render(narrate(solve_problem(problem))).split())
    assert "x_C = 0.1338 m < b/2 = 0.3 m it does not tip" in page
    assert "x_D = 0.1529 m < b/2 = 0.3 m it does not tip" in page
    assert page.count("↺ ΣM_D:") == 1
    assert "M_C/N_C" not in page
