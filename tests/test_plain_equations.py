"""The equations that a page takes where several have to be solved together, and how it solves them."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file


def test_what_several_equations_tell_outright_stands_first() -> None:
    """μ (N_A + N_B) = μ m g = m a gives a whatever the two normal forces are; then these follow, one at a time."""
    page = page_of_file("crate-on-cart").partition("CASE")[2]
    assert "(1), (2), (4) in (5): a_K = μ g = 0.3 · 9.81 = 2.943 m/s²" in page
    assert "together" not in page
    assert page.index("a_K = μ g") < page.index("N_B = m (g b - a_K h) / (2 b)")
    assert "N_B = 24.525 N > 0 it slips before it tips" in page


def test_single_bodies_instead_of_a_group_whose_inner_force_is_asked() -> None:
    page = page_of_file("rod-disk-wall")
    assert "disk, moments about C: (3) ↺ ΣM_C: R O_x = I_disk α_disk - M a_O R" in page
    assert "rod: (4) → ΣF_x: O_x - N_E = m a_O - √2/4 m l α_rod" in page
    assert "disk, rod, moments" not in page


@pytest.mark.parametrize("stem", ["double-pulley", "hoist-with-moving-pulley", "hoist-driven-by-gears"])
def test_a_group_in_which_one_body_turns_stays(stem: str) -> None:
    assert re.search(r"(pulley, A, B|pulley, load|gear_B, load), moments about", page_of_file(stem))


def test_many_equations_that_are_solved_together_stand_in_rows() -> None:
    page = page_of_file("chain-5")
    assert "row α_OA α_AB α_BC α_CD α_DE right side in N·m" in page
    assert "(11) 0.1915111 0.1969616 0.1409539 0.1285575 0.1666667 -3.442127" in page
    assert "(15) 3.0675045 2.5419804 1.4874345 1.0343459 0.8246507 -39.90310" in page
    assert "together: α_OA = 11.58 rad/s² α_AB = -19.49 rad/s² α_BC = -8.667 rad/s²" in page
    assert "(5): a_G,BC,x = 0.4924 · 11.583 + 0.30642 (-19.495) + 0.05130 (-8.667) - 2.384 = -3.099 m/s²" in page


def test_what_was_told_by_one_letter_gets_its_number() -> None:
    page = page_of_file("slider-crank-free")
    assert "(2): α_OA = 377.9 - 5.745 α_AB in rad/s²" in page
    assert "(2): α_OA = 377.9 - 5.745 (-11.05) = 441.4 rad/s²" in page


def test_a_body_that_tips_has_its_equations() -> None:
    page = page_of_file("crate-pushed-too-hard").rpartition("CASE")[2]
    assert "N_C and F_C meet, so that neither enters: (1) ↺ ΣM_K: 1/2 m g b - P y = I_K α" in page
    assert "|F_C| = 176.6 N < μ N_C = 0.4 · 600.3 = 240.1 N it does not slip" in page
    # C is the middle of the face, from which G is straight above.
    assert "a_G = α × r_G/C,edge r_G/C,edge = [-b/2, h/2] = [-0.3, 0.6] m" in page


def test_friction_below_its_limit_is_drawn_against_the_push() -> None:
    assert "F_C ← at C =" in page_of_file("crate-that-slips-or-tips").partition("CASE high")[2]


def test_a_letter_that_the_file_gives_by_a_formula_is_put_in_by_a_line() -> None:
    page = page_of_file("ball-pushed-without-friction")
    assert "with h = R: α = 5 F/(7 m R)" in page
