"""A relative velocity that is given by size and direction: the sum of velocities, then its components."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.report.words.spoken import begun


def test_the_sum_stands_before_its_components() -> None:
    page = page_of_file("boat-with-two-courses")
    assert "Given: v_stream = u at 30°: (1) along x: v_stream,x = u cos 30° = 8 cos 30° = 6.928 m/s" in page
    total = "v_boat = v_stream + v_boat/stream, where v_boat/stream = w at -β: (3) along y: v_boat,y = "
    assert f"{total}v_stream,y - w sin β = 0 (4) along x: v_boat,x = v_stream,x + w cos β" in page
    assert "the size of the velocity" not in page


def test_the_smallest_speed_is_sought_and_not_given() -> None:
    page = page_of_file("boat-with-two-courses")
    told = "by (2), (3): w_min = u/(2 sin β) This is smallest where sin β is largest, and sin β ≤ 1: (5) sin β = 1"
    assert told in page
    assert "derivative" not in page
    assert "-90°" not in page


@pytest.mark.parametrize(("words", "told"), [
    ("w_1 is smallest", "w_1 is smallest"),
    ("w is smallest", "w is smallest"),
    ("the cord is taut", "The cord is taut"),
    ("a cord is taut", "A cord is taut"),
])  # fmt: skip
def test_letters_stay_small(words: str, told: str) -> None:
    assert begun(words) == told
