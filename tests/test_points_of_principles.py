"""The formulas at the head of a page speak of its own points, and of nothing that it does not use."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.report.words.points_of_principles import in_letters


@pytest.mark.parametrize(("stem", "told"), [
    ("ex-1-03", "Position vectors: r_P = r_G + r_P/G."),
    ("ex-1-02", "Position vectors: r_B = r_A + r_B/A."),
    ("wheel-on-conveyor", "Rigid bodies: v_G = v_C + ω × r_G/C."),
    ("disk-on-fixed-disk", "Rigid bodies: v_C = v_G + ω × r_C/G, a_C = a_G + α × r_C/G - ω² r_C/G."),
    ("four-bar", "Rigid bodies: v_B = v_A + ω × r_B/A, a_B = a_A + α × r_B/A - ω² r_B/A."),
])  # fmt: skip
def test_the_letters_are_those_of_the_page(stem: str, told: str) -> None:
    assert told in page_of_file(stem)


def test_only_points_are_renamed() -> None:
    assert in_letters("a_B = a_A + α × r_B/A - ω² r_B/A", ("P,2", "O")) == "a_P,2 = a_O + α × r_P,2/O - ω² r_P,2/O"


@pytest.mark.parametrize("stem", ["radar-that-tracks-an-aircraft", "radar-and-an-airplane-in-a-loop"])
def test_derivatives_of_a_distance_alone_use_no_polar_components(stem: str) -> None:
    assert "Polar coordinates" not in page_of_file(stem)


@pytest.mark.parametrize("stem", ["collar-on-rotating-rod", "can-driven-along-a-groove"])
def test_polar_components_that_are_used_are_told(stem: str) -> None:
    assert "Polar coordinates: v_r = ṙ" in page_of_file(stem)
