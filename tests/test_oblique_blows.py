"""The blow of a particle on a rough slope is resolved along the tangent t and the normal n of the slope."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize("said", [
    "ball: m v_2 ↓, J_N ↗, μ J_N ↖ = m v_t,3 ↘, m v_n,3 ↗",
    "(5) v_n,3 = e v_n,2 = 0.7 · 4.3976 = 3.078 m/s",
    "(6): J_N = m (v_n,2 + v_n,3)",
    "(7): v_t,3 = v_t,2 - μ J_N/m",
    "v_along = v_t,3 = 0.5555 m/s",
])  # fmt: skip
def test_along_the_tangent_and_the_normal(said: str) -> None:
    assert said in page_of_file("ball-on-a-rough-slope")


def test_a_smooth_slope_and_a_level_floor_keep_their_axes() -> None:
    assert "v_t" not in page_of_file("ball-bouncing-down-a-slope")
