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
    ],
)
def test_a_case_whose_result_is_known(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


@pytest.mark.parametrize("stem", ["ball-in-a-rotating-tube-in-letters", "atwood-let-go"])
def test_none_where_it_says_nothing_or_another_check_stands(stem: str) -> None:
    """Without rotation nothing moves; the place by constant acceleration is a check already."""
    assert " with w = 0" not in page_of_file(stem)
    assert " with m_A = m_B" not in page_of_file(stem)
