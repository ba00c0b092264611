"""A coordinate that goes with others: by how much it changes, as the kinematics tell."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "line"), [
    ("heavy-disk-in-the-bight-of-a-rope", "From 1 to 2, by the kinematics, Δy_G = R Δθ: (8) θ_2 = h/R"),
    ("gears-turned-by-a-load", "From 1 to 2, by the kinematics, Δs_L = r R_1 Δθ_pinion/R_2: (8) θ_pinion,2 = "),
])  # fmt: skip
def test_how_a_coordinate_goes_with_others(stem: str, line: str) -> None:
    assert line in page_of_file(stem)
