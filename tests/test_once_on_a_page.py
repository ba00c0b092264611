"""Nothing stands twice on a page: no closed form beside the formula that is it already, no vector by a detour."""

from __future__ import annotations

from worked import page_of_file


def test_no_closed_form_beside_the_same_formula() -> None:
    """I_G = m k_G² names what the closed form writes out; F_C is found by other results, and keeps its own."""
    page = page_of_file("ex-4-05")
    assert "in letters: α" not in page
    assert "in letters: F_C = P (R (R + r) / (R² + k_G²) - 1)" in page


def test_a_velocity_that_is_given_is_not_found_from_what_follows() -> None:
    page = page_of_file("ex-4-07")
    assert "v_O = [1, 0] m/s given" in page
    assert page.count("v_O = ω_disk × r_O/C") == 1


def test_a_vector_that_says_the_answer_stands_once_before_it() -> None:
    page = page_of_file("ex-1-13")
    assert "a_P = v_P²/ρ e_n = [-(0.08/m) v², (0.04/m) v²]" in page
    assert "a, x" not in page


def test_a_case_tells_only_what_differs() -> None:
    """The kinematics of one line are as before, the moment of inertia too, and one force is gone from the diagram."""
    case = page_of_file("ex-4-05").partition("CASE")[2]
    assert "no friction Kinematic analysis as before: (1). STEP 2" in case
    assert "spool: the diagram as before, without F_C Without friction at C" in case
    assert "moment of inertia" not in case
