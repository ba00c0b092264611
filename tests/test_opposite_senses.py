"""Bodies that do not rebound: where one counts downward and the other upward one letter would be false of one, and what
moves across the common normal has one velocity along it alone.
"""

from __future__ import annotations

from conftest import ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def test_one_velocity_in_opposite_senses_keeps_two_letters() -> None:
    text = (ROOT / "problems" / "impact" / "pile-driven-into-soil-of-constant-resistance.yaml").read_text()
    text = text.replace("along: 90 deg, name: leader", "along: -90 deg, name: leader")
    text = text.replace("  - impact", "  - guide: {point: Q, along: -90 deg, during: 1->2, name: leads}\n  - impact")
    # What is asked along the axis counts along it.
    text = text[: text.index("find:")] + "find: {v: v(ram).y @ 2, u: v(pile).y @ 3}\n"
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "one velocity along the common normal: (2) v_P,3 = -v_Qy,3 ram, pile:" in page
    assert "(m_1 - m_2)" not in page


OBLIQUE = """
plane: horizontal
given: {m_A: 0.3 kg, m_B: 0.5 kg}
bodies: {A: {particle: [0, 0], mass: m_A}, B: {particle: [0, 0], mass: m_B}}
joints:
  - impact: {between: [A, B], normal: 0 deg, restitution: 0, mu: 0}
states:
  1: [v(A).x = 5 m/s, v(A).y = 1 m/s, v(B).x = -2 m/s, v(B).y = 3 m/s]
  2: [just after 1]
find: {lost: KE(all) @ 1 - KE(all) @ 2}
"""


def test_what_moves_across_the_normal_has_one_velocity_along_it() -> None:
    problem, wrong = load_text(OBLIQUE)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "after the blow A and B have the same velocity v_Ax,2 along the common normal. A, B:" in page
