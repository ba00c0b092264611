"""A couple that is asked as what the moments on a driven body lack is told by the body's diagram and its moments."""

from __future__ import annotations

from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

HOIST = next(p for p in PROBLEMS if p.stem == "body-hoist-starting-softly")


def test_the_drum_has_its_diagram_and_its_moments() -> None:
    page = page_of_file("body-hoist-starting-softly")
    assert "drum at 1, moments about O, with the couple M_1 that drives it:" in page
    assert "T_rope ↓ at T, M_1 ↺ = I_drum α ↺" in page
    assert "↺ ΣM_O: M_1 - T_rope,1 R = M k_O² α_1 STEP 3" in page


def test_another_couple_is_none() -> None:
    """Twice the moment of the rope balances nothing."""
    text = (
        HOIST.read_text(encoding="utf-8").replace("+ tension(rope)*R)", "+ 2*tension(rope)*R)").partition("answers:")[0]
    )
    page = Terminal(200).render(narrate(solve_problem(load_text(text)[0])))
    assert "that drives it" not in page
