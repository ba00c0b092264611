"""Answers in letters are discussed by a special case in which they come to something known; it is no check."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file, page_of_text


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("atwood-machine", "Discussion With m_A = m_B: a_A = 0; T = m_B g."),
        ("dumbbell-dropped-on-a-floor", "With β = 90°: v_G = e v; ω = 0"),
        ("bob-under-a-free-cart-in-letters", "With m → 0: T = 2 π √(l/g)"),
        ("bar-hanging-from-a-pushed-collar", "With m → 0: a = F/M; N = M g"),
    ],
)
def test_a_case_whose_result_is_known(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


BOUNCE = """
title: Ball against a wall
plane: horizontal
symbols: {v_0: m/s, m: kg, e: 1}
points: {A: [0, 0]}
surfaces: {wall: {through: A, angle: 90 deg}}
bodies: {ball: {particle: A, mass: m}}
joints:
  - impact: {between: [ball, wall], restitution: e}
states:
  1: [v(ball).x = v_0, v(ball).y = 0]
  2: [just after 1]
find: {lost: KE(ball) @ 1 - KE(ball) @ 2}
"""


def test_a_coefficient_of_restitution_is_none_of_friction(tmp_path: Path) -> None:
    assert "Discussion Without rebound, e = 0: lost = 1/2 m v_0²." in page_of_text(tmp_path, BOUNCE)


@pytest.mark.parametrize("stem", ["ball-in-a-rotating-tube-in-letters", "atwood-let-go"])
def test_none_where_it_says_nothing_or_another_check_stands(stem: str) -> None:
    """Without rotation nothing moves; the place by constant acceleration is a check already."""
    assert " With w = 0" not in page_of_file(stem)
    assert " With m_A = m_B" not in page_of_file(stem)


def test_none_where_a_state_is_never_reached() -> None:
    """Equal weights that are let go never get to the second state."""
    page = page_of_file("atwood-let-go")
    assert "Discussion" not in page
    assert "Check s_A,2 = (m_A - m_B) g t_2² / (2 (m_A + m_B)) = s" in page


def test_a_case_that_the_file_assumes_not_to_be_is_none() -> None:
    """It assumes M > 3 m; that a number stands in the formula makes it no number that is known."""
    page = page_of_file("small-ball-on-a-large-one")
    assert "With M = m" not in page
    assert "3 √(2 g h)" not in page


def test_a_number_that_nobody_knows_beforehand_is_no_check() -> None:
    assert "Discussion With" not in page_of_file("bullet-that-sends-a-bob-full-circle")


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("atwood-machine", "Check checked by an independent multibody solution Discussion"),
        (
            "two-wheels-pressed-together",
            "Check work and energy: T_1 + U = 1/4 m_large R² ω_large,1² - μ F (R θ_large,2 + r θ_small,2) "
            "= 450 - 122.7 = 327.3 J; T_2 = 238.0 + 89.26 = 327.3 J (large, small) ·",
        ),
    ],
)
def test_what_is_printed_as_checked_was_checked(stem: str, words: str) -> None:
    """A formula with its letters put to a limit compares nothing; T with the speeds that T gave says nothing new."""
    page = page_of_file(stem)
    assert words in page
    assert "Σ (1/2 m v²" not in page
