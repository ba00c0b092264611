"""How a page writes what ropes and tracks keep: sums without a minus sign before each term, tracks by their names."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "equation"),
    [
        ("three-blocks-on-one-cable", "(1) v_A + v_B + 2 v_C = 0"),
        ("three-blocks-on-one-cable", "(2) a_A + a_B + 2 a_C = 0"),
        ("heavy-disk-in-the-bight-of-a-rope", "(4) a_By + a_Gy + R α = 0"),
    ],
)
def test_a_sum_that_is_nought_has_no_minus_before_each_term(stem: str, equation: str) -> None:
    assert equation in page_of_file(stem)


def test_a_curved_track_is_called_by_its_name() -> None:
    page = page_of_file("ball-in-a-forked-slot")
    assert "ball moves along the slot; across it a_ball is its normal part:" in page
