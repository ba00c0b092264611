"""For which value of a datum something vanishes is told by the formula that was found for it, where that is short."""

from __future__ import annotations

import unicodedata

import pytest
from worked import page_of_file


def _case(stem: str) -> str:
    return unicodedata.normalize("NFC", page_of_file(stem)).partition("CASE ")[2]


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        (
            "ex-4-05",
            "m a_G - P = P (R (R + r) / (R² + k_G²) - 1) = 0 k_G² = R r k_G = √(R r) = √(0.45 · 0.3) = 0.3674 m",
        ),
        ("spool-critical-angle", "(1) in (2): α = P (R cos β - r_h) / (m (R² + k_G²)) = 0"),
        ("bead-in-loop", "2 v_0² = √3 g R v_0 = 3^(1/4) √(g R/2)"),
        ("spool-critical-angle", "R cos β = r_h β = arccos(r_h/R)"),
        ("spool-hauled-up-a-slope", "k_G² (P - m g sin β) = P R r_h"),
    ],
)
def test_the_formula_is_set_to_zero(stem: str, words: str) -> None:
    case = _case(stem)
    assert "The formula above, set to zero" in case
    assert words in case


def test_a_datum_that_the_general_solution_has_a_formula_for_is_open_in_its_lines() -> None:
    """h = R: the line found F_C = 5 F h/(7 R) - F, zero for another h; what else is asked follows."""
    case = _case("ball-pushed-without-friction")
    assert "(3): F_C = m a_G - F = 5 F h/(7 R) - F = 0 5 h = 7 R h = 7 R/5 a_best = a_G = 5 F h/(7 m R) = F/m" in case
    assert "free-body diagram" not in case


def test_a_force_is_drawn_where_its_formula_says() -> None:
    """H(0, h) falls on G only for h = R."""
    assert "F → at H," in page_of_file("ball-pushed-without-friction")


def test_what_is_told_in_the_case_is_not_said_before_it() -> None:
    assert "friction would be zero" not in page_of_file("ex-4-05")


def test_a_formula_with_lengths_as_bare_numbers_is_no_reason() -> None:
    """6 - 5 μ h would have lost its units."""
    assert "moments about C" in _case("car-with-locked-wheels")
