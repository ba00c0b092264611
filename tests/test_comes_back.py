"""A motion with blows is walked once, from state to state; what comes back does so with the same speed."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file


def test_the_path_is_walked_once() -> None:
    page = page_of_file("ball-bouncing-twice")
    places = [
        page.index(said) for said in ("v_1 = -", "t_1 = √", "J = m", "v_4 = -", "t_4 = 2", "y_6 = v_5²", "t_6 = v_5")
    ]
    assert places == sorted(places)


@pytest.mark.parametrize("said", [
    "From 2 to 4, the ball comes back to the same height, with the same speed: (7) v_4 = -v_2 = -5.050 m/s",
    "J = m (v_2 - v_1) = 0.15 (5.050 - (-6.264)) = 1.697 N·s",
])  # fmt: skip
def test_short_words_and_names(said: str) -> None:
    page = page_of_file("ball-bouncing-twice")
    assert said in page
    assert not re.search(r"J_N", page)
