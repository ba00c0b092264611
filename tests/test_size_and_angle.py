"""A vector that an answer gives by size and direction has a line for each, with formula and numbers."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("ex-1-10", "|a_B| = √(0.2282² + 0.1704²) = 0.2848 m/s² direction of a_B = arctan("),
        ("ex-1-10", "direction of a_B = arctan(0.1704/0.2282) = 36.7° below -x"),
        ("pucks-at-an-angle", "direction of v_B = arctan(2.799/1.384) = 63.7° above +x"),
    ],
)
def test_size_and_direction(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_not_along_an_axis() -> None:
    assert "arctan" not in page_of_file("ex-1-14").partition("Answer")[0]


def test_a_size_that_the_page_has_is_not_told_again() -> None:
    page = page_of_file("collar-on-rotating-rod")
    assert page.count("√((-8.610)² + (-2.000)²)") + page.count("√(8.610² + 2.000²)") == 1
