"""P′ is introduced before the first formula that has it: as the point of which body it moves."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "words"), [
    ("crank-pin-in-a-slotted-arm", "P′: the point fixed to the arm that coincides with P"),
    ("car-seen-from-a-bend", "B′: the point fixed to carA that coincides with B"),
    ("eccentric-cam-with-flat-follower", "G′: the point fixed to the follower that coincides with G"),
    ("pin-in-two-slotted-rods", "P′: the point fixed to BD that coincides with P"),
])  # fmt: skip
def test_a_primed_point_is_introduced(stem: str, words: str) -> None:
    page = page_of_file(stem)
    _, _, steps = page.partition("STEP 1")
    first = re.search(rf"{words[0]}′", steps)
    assert first is not None
    assert steps[first.start() :].startswith(words)
