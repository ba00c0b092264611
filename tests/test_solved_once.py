"""What is solved in letters on the way to one unknown is not solved again: only its numbers are new."""

from __future__ import annotations

import unicodedata

from worked import page_of_file


def _page(stem: str) -> str:
    return unicodedata.normalize("NFC", page_of_file(stem))


def test_a_formula_stands_once_and_then_its_numbers() -> None:
    page = _page("gear-pair")
    assert page.count("α_B = -r_A α_A/r_B") == 1
    assert "α_B = -0.1 · 27.5 / 0.25 = -11 rad/s²" in page


def test_an_equation_that_stands_outright_is_not_written_with_others_put_in() -> None:
    page = _page("crate-on-cart")
    assert "F_B = μ m g - μ N_A" not in page
    assert "F_B = μ N_B = 0.3 · 24.525 = 7.3575 N" in page
