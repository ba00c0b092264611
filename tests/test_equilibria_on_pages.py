"""Bodies that stick are in equilibrium: no accelerations stand on their pages, and friction acts as it is drawn."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import Voice, narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    "name",
    [
        "friction/flattest-ladder-at-a-rough-wall",
        "friction/wedge-driven-under-a-block",
        "friction/block-held-on-slope",
        "friction/cabinet-on-a-tilting-floor",
        "rigid-bodies/built-in-beam-with-prop",
    ],
)
def test_what_is_held_is_in_equilibrium(name: str) -> None:
    page = _page(name)
    assert "Equilibrium: ΣF = 0" in page
    assert "Newton" not in page
    assert "Kinetic analysis" not in page
    assert "α" not in page


def test_the_flattest_ladder_has_the_equations_of_equilibrium() -> None:
    page = _page("friction/flattest-ladder-at-a-rough-wall")
    assert "STEP 1  Equilibrium" in page
    assert "free-body diagram; ΣF = 0, ΣM = 0" in page
    assert "F_A → at A,  N_B ← at B,  F_B ↑ at B   =   0\n" in page
    assert "→ ΣF_x:         F_A - N_B = 0\n" in page
    assert "β = arctan((1 - μ_1 μ_2) / (2 μ_1))" in page


def test_friction_about_to_slip_is_drawn_as_it_acts() -> None:
    """The wedge slides in under the block to the right, and out to the left: F = μ N both times."""
    page = _page("friction/wedge-driven-under-a-block").split("CASE  alone")[0]
    driven, drawn = page.split("CASE  out")
    assert "F_F ←" in driven
    assert "F_S ↘" in driven
    assert "F_F →" in drawn
    assert "F_S ↖" in drawn
    assert page.count("F_F = μ N_F\n") == 2
    assert "F_S = μ N_S\n" in driven
    assert "As before: (2) and (3)." in drawn
    assert "-μ" not in page
    assert "(assumed)" not in page


def test_a_normal_force_about_to_tip_is_drawn_beside_the_middle() -> None:
    """No student would draw a couple there."""
    page = _page("friction/cabinet-on-a-tilting-floor")
    assert "N_C ↖ at x ↙ from C_1" in page
    assert "x = b/2\n" in page
    assert "↺ ΣM_C1:   1/2 m g h sin β - N_C x = 0" in page
    assert "M_C " not in page


def test_a_lesson_on_equilibrium_speaks_of_no_acceleration() -> None:
    solution = worked(ROOT / "problems" / "friction" / "flattest-ladder-at-a-rough-wall.yaml")[0]
    page = Terminal(width=110).render(narrate(solution, Voice(audience="lesson")))
    assert "acceleration" not in page
    assert "moment of inertia" not in page
    assert "against the slip that is about to begin" in page


def test_what_may_move_is_not_in_equilibrium() -> None:
    """The box does not slip on its cart, which the cord draws along."""
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "Newton's second law" in page
    assert "Equilibrium" not in page
