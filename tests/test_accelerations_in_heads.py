"""An acceleration that was found before stands in the heading of the motion with it."""

from __future__ import annotations

from worked import page_of_file


def test_the_letter_with_its_value_needs_no_heading_of_its_own() -> None:
    page = page_of_file("impact/pile-driver")
    assert "constant acceleration of A downward, s̈_A = a_A,3 = -450.8 ft/s²: v² = v_0² + 2 a (s - s_0)" in page
    assert "For the way of A" not in page


def test_a_heading_that_would_break_inside_its_formula_stays() -> None:
    page = page_of_file("block-shot-along-a-carrier")
    assert "For the way of B along its path: s̈_B = a_B,carrier,4 = 2.160 m/s²" in page
