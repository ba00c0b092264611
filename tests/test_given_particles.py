"""Given says which particle is at a point whose name its letters have: v_F is the velocity of A."""

from __future__ import annotations

import pytest
from worked import page_of_file


def given(stem: str) -> str:
    """What is given, with single spaces."""
    page = page_of_file(stem)
    return page.partition(" Given ")[2].partition(" Find ")[0]


@pytest.mark.parametrize(("stem", "words"), [
    ("weight-lifted-by-a-jerk", "F(-0.2, 0) m (A), B(0.2, 2.5) m;"),
    ("bead-in-loop", "OP = R at 120° (P: ball)"),
    ("block-with-a-fading-push", "P(0, 0) (block)"),
    ("ex-1-14", "P at y = 500 mm on the line through O at θ (collar)"),
])  # fmt: skip
def test_a_particle_is_told_where_its_point_is(stem: str, words: str) -> None:
    assert words in given(stem)


def test_a_particle_with_the_name_of_its_point_needs_no_word() -> None:
    assert "(P" not in given("ellipse-in-time").replace("P(", "")


@pytest.mark.parametrize(("stem", "words"), [
    ("engine-whose-piston-is-fastest", "AB = r at θ, crank AB, rod BD;"),
    ("parallelogram-3-cranks", "crank_1 O1B1, crank_2 O2B2, crank_3 O3B3, coupler B1B3;"),
])  # fmt: skip
def test_a_rod_with_a_name_of_its_own_is_told_between_its_points(stem: str, words: str) -> None:
    assert words in given(stem)


def test_the_first_state_says_what_a_letter_that_is_sought_stands_for() -> None:
    assert "nozzle: |v| = v_0, direction of v = β, v_0 > 0; window:" in given("least-speed-to-a-target")
