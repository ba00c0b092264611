"""Bodies that do not rebound, of which one counts downward and the other upward: one letter would be false of one."""

from __future__ import annotations

from conftest import ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem


def test_one_velocity_in_opposite_senses_keeps_two_letters() -> None:
    text = (ROOT / "problems" / "impact" / "pile-driven-into-soil-of-constant-resistance.yaml").read_text()
    text = text.replace("along: 90 deg, name: leader", "along: -90 deg, name: leader")
    text = text.replace("  - impact", "  - guide: {point: Q, along: -90 deg, during: 1->2, name: leads}\n  - impact")
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "(3) v_P,3 = -v_Qy,3" in page
    assert "(m_1 - m_2)" not in page
