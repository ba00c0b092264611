"""A mass centre that the file does not name is G, of one body among several G with its name; never the body itself."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("name", "line"), [
    ("hinged-bars-struck", "AB, momentum along y: (4) ↑ -J_By = m v_G,AB,y,2"),
    ("six-bar-class-3", "a_G,PC = α_PC × r_G,PC/P - ω_PC² r_G,PC/P"),
    ("free-bar-struck-at-its-end", "(1) ↺ H_G: 1/2 S l = I ω_2"),
    ("rod-falling-on-a-smooth-floor", "U of the weight of rod = m g (y_G,1 - y_G,2)"),
])  # fmt: skip
def test_the_letters_of_mass_centres(name: str, line: str) -> None:
    text = page_of_file(name)
    assert line in text
    assert not re.search(r"\b[vaxy]_(?:AB|BC|PC|QD|rod|bar)(?:[xy]|,[xy1-9])", text)


def test_a_letter_has_no_prime_where_nothing_on_its_part_of_the_page_is_called_so_without() -> None:
    text = page_of_file("spool-rolls-or-slips")
    assert "spool rolls without slipping: a_G = R α" in text
    assert "′" not in text
