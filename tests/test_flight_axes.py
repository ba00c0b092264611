"""After a blow on a slope the flight back to it is told in the axes of the slope, with speeds that are positive."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import page_of_file, page_of_text


@pytest.mark.parametrize("said", [
    # The speed of the fall has one letter, and counts downward.
    "At 1: v = √(2 g h) = √(2 · 9.81 · 1.2) = 4.852 m/s",
    "ball: m v ↓, J_N ↗, μ J_N ↖ = m v_t,2 ↘, m v_n,2 ↗",
    "v_n,2 = e v cos β = 0.7 · 4.852 cos 25° = 3.078 m/s",
    "constant acceleration perpendicular to the slope, back on it after Δt: (6) v_n,2 Δt = 1/2 g Δt² cos β",
    "Δt = 2 v_n,2/(g cos β) = 2 · 3.0783 / (9.81 cos 25°) = 0.6925 s",
    "along the slope: (7) d = 1/2 g Δt² sin β + v_t,2 Δt = 1/2 · 9.81 · 0.6925² sin 25° + 0.5555 · 0.6925 = 1.379 m",
    "loss = 1/2 m (v² - v_n,2² - v_t,2²)",
])  # fmt: skip
def test_a_flight_in_the_axes_of_the_slope(said: str) -> None:
    assert said in page_of_file("ball-on-a-rough-slope")


def test_a_distance_is_positive_where_the_speed_along_the_slope_is_not(tmp_path: Path) -> None:
    """The slope rises to the right, up which the speed counts, and the ball goes down."""
    text = (ROOT / "problems/impact/ball-on-a-rough-slope.yaml").read_text(encoding="utf-8").replace("-beta", "beta")
    text = text.replace("d: r(ball/O).along(beta) @ 3", "d: r(ball/O).mag @ 3").partition("note:")[0]
    page = page_of_text(tmp_path, text)
    assert "d = 1/2 g Δt² sin β - v_t,2 Δt = 1/2 · 9.81 · 0.6925² sin 25° - (-0.5555) · 0.6925 = 1.379 m" in page
