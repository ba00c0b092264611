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
        ("ex-4-05", "P (R (R + r) / (R² + k_G²) - 1) = 0 k_G² = R r k_G = √(R r) = √(0.45 · 0.3) = 0.3674 m"),
        ("bead-in-loop", "2 v_0² = √3 g R v_0 = 3^(1/4) √(g R/2)"),
        ("spool-critical-angle", "R cos β = r_h β = arccos(r_h/R)"),
        ("spool-hauled-up-a-slope", "k_G² (P - m g sin β) = P R r_h"),
    ],
)
def test_the_formula_is_set_to_zero(stem: str, words: str) -> None:
    case = _case(stem)
    assert "The formula above, set to zero" in case
    assert words in case


def test_what_is_told_in_the_case_is_not_said_before_it() -> None:
    assert "friction would be zero" not in page_of_file("ex-4-05")


def test_a_formula_with_lengths_as_bare_numbers_is_no_reason() -> None:
    """6 - 5 μ h would have lost its units."""
    assert "moments about C" in _case("car-with-locked-wheels")
