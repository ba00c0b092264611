"""A vector that an answer gives by size and direction has a line for each, with formula and numbers."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("ex-1-10", "|a_B,2| = √(a_t² + a_n²) = √(0.1² + 0.2667²) = 0.2848 m/s² direction of a_B,2 = arctan("),
        ("ex-1-10", "direction of a_B,2 = arctan(0.1704/0.2282) = 36.7° below -x"),
        ("pucks-at-an-angle", "direction of v_B = arctan(2.799/1.384) = 63.7° above +x"),
    ],
)
def test_size_and_direction(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_not_along_an_axis() -> None:
    assert "arctan" not in page_of_file("ex-1-14").partition("Answer")[0]


def test_a_size_that_the_page_has_is_not_told_again() -> None:
    page = page_of_file("collar-on-rotating-rod")
    assert page.count("√(8.2² + 3.3²)") == 1
    assert page.count("√(8.610² + 2.000²)") == 0


@pytest.mark.parametrize(
    ("stem", "before", "line"),
    [
        ("body-ladder-point-in-time", "v_My,later = ", "|v_M,later| = √(0.36² + 0.1999²)"),
        ("ball-bouncing-down-a-slope", "At 4: v_4 = ", "|v_4| = √(5.371² + 0.1270²)"),
        ("ring-on-two-turning-rods", "v = v_P ", "|v_P| = √(1.155² + 0.4²)"),
        ("car-seen-from-a-bend", "v_trans = v_B/A ", "|v_B/A| = √(15² + 20²)"),
    ],
)
def test_after_the_components(stem: str, before: str, line: str) -> None:
    """The same state, and the name that the vector has on the page."""
    page = page_of_file(stem)
    assert page.index(line) - page.index(before) < 150
    assert page.index(before) < page.index(line)


@pytest.mark.parametrize(("stem", "size"), [("pipe-bend", "7255 N"), ("polar-motion", "2.452 m/s")])
def test_a_size_under_another_name(stem: str, size: str) -> None:
    solving = page_of_file(stem).partition("Answer")[0]
    assert solving.count(f"= {size}") == 1
