"""Bodies that turn together while some slide along others: energies by their common moment of inertia, and a blow that
changes nothing.
"""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

STEM = "spheres-that-slide-out-to-stops"


@pytest.mark.parametrize("said", [
    "T_2 = 1/2 I_O,2 ω_rod,2² + m_A v_A,rod,2²",
    "Just after 2, rod, A, B: the impulses between them are internal, and those from outside pass through O, so"
    " that H_O and I_O stay what they are: (3) ω_rod,3 = ω_rod,2 = 2.080 rad/s",
])  # fmt: skip
def test_energy_of_turning_and_of_sliding(said: str) -> None:
    assert said in page_of_file(STEM)


def test_what_is_told_of_an_equal_body_is_not_told_again() -> None:
    printed = page_of_file(STEM)
    assert "momentum before + impulses" not in printed
    assert "mass of other" not in printed


def test_what_slides_is_told_by_its_own_mass() -> None:
    """The tube is as heavy as both balls together."""
    (path,) = (p for p in PROBLEMS if p.stem == "two-balls-in-a-turning-tube")
    problem, wrong = load_text(path.read_text(encoding="utf-8").replace("mass: 4 kg", "mass: 1 kg"))
    assert problem is not None, wrong
    page = " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
    assert "T_end = 1/2 I_O,end ω_end² + m_P v_P,tube,end²" in page
