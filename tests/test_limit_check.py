"""Answers in letters are checked by a special case whose result is known beforehand."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("atwood-machine", "Check with m_A = m_B: a_A = 0; T = m_B g"),
        ("dumbbell-dropped-on-a-floor", "with β = 90°: v_G = e v; ω = 0"),
        ("bob-under-a-free-cart-in-letters", "with m → 0: T = 2 π √(l/g)"),
        ("bar-hanging-from-a-pushed-collar", "with m → 0: a = F/M; N = M g"),
    ],
)
def test_a_case_whose_result_is_known(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


@pytest.mark.parametrize("stem", ["ball-in-a-rotating-tube-in-letters", "atwood-let-go"])
def test_none_where_it_says_nothing_or_another_check_stands(stem: str) -> None:
    """Without rotation nothing moves; the place by constant acceleration is a check already."""
    assert " with w = 0" not in page_of_file(stem)
    assert " with m_A = m_B" not in page_of_file(stem)


def test_a_case_that_the_file_assumes_not_to_be_is_none() -> None:
    """It assumes M > 3 m; a small ball that falls with v on a large one that comes up with v leaves with 3 v."""
    page = page_of_file("small-ball-on-a-large-one")
    assert "with M = m" not in page
    assert "with m → 0: v = 3 √(2 g h) ·" in page


def test_a_number_that_nobody_knows_beforehand_is_no_check() -> None:
    assert "Check with" not in page_of_file("bullet-that-sends-a-bob-full-circle")
