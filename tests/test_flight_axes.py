"""After a blow on a slope the flight back to it is told in the axes of the slope, with speeds that are positive."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import page_of_file, page_of_text

SLOPE = (ROOT / "problems/impact/ball-on-a-rough-slope.yaml").read_text(encoding="utf-8")
STATED = """\
title: Ball that comes down on a rough slope
plane: vertical
given: {m: 50 g, h: 1.2 m, beta: 25 deg, e: 0.7, mu: 0.2}
unknowns: {v: m/s}
points: {O: [0, 0]}
surfaces: {slope: {through: O, angle: -beta}}
bodies: {ball: {particle: [0, 0], mass: m}}
joints:
  - impact: {name: bounce, between: [ball, slope], restitution: e, mu: mu, during: 1->2}
states:
  1: [t = 0, v = sqrt(2*g*h), v(ball).x = 0, v(ball).y = -v]
  2: [just after 1]
  3: [r(ball/O).across(-beta) = 0]
find: {J: impulse(bounce).across(-beta) @ 1->2, loss: KE(ball) @ 1 - KE(ball) @ 2, d: r(ball/O).along(-beta) @ 3}
"""


@pytest.mark.parametrize("said", [
    "v_2 = √(2 g h) = √(2 · 9.81 · 1.2) = 4.852 m/s",
    "ball: m v_2 ↓, J_N ↗, μ J_N ↖ = m v_t,3 ↘, m v_n,3 ↗",
    # The velocity before the blow is told in the same axes.
    "At 2, the velocity into the slope: (3) v_n,2 = v_2 cos β = 4.8522 cos 25° = 4.398 m/s",
    "At 2, the velocity down the slope: (4) v_t,2 = v_2 sin β = 4.852 sin 25° = 2.051 m/s",
    "v_n,3 = e v_n,2 = 0.7 · 4.3976 = 3.078 m/s",
    "(6): J_N = m (v_n,2 + v_n,3)",
    "↘ m v_t,2 - μ J_N = m v_t,3",
    "constant acceleration perpendicular to the slope, back on it after Δt: (8) v_n,3 Δt = 1/2 g Δt² cos β",
    "Δt = 2 v_n,3/(g cos β) = 2 · 3.0783 / (9.81 cos 25°) = 0.6925 s",
    "along the slope: (9) d = 1/2 g Δt² sin β + v_t,3 Δt = 1/2 · 9.81 · 0.6925² sin 25° + 0.5555 · 0.6925 = 1.379 m",
    "loss = 1/2 m (v_2² - v_n,3² - v_t,3²)",
])  # fmt: skip
def test_a_flight_in_the_axes_of_the_slope(said: str) -> None:
    assert said in page_of_file("ball-on-a-rough-slope")


@pytest.mark.slow
@pytest.mark.parametrize("said", [
    # The speed of the fall has one letter, and counts downward.
    "At 1: v = √(2 g h) = √(2 · 9.81 · 1.2) = 4.852 m/s",
    "ball: m v ↓, J ↗, μ J ↖ = m v_t,2 ↘, m v_n,2 ↗",
    "v_n,1 = v cos β = 4.8522 cos 25° = 4.398 m/s",
    "v_n,2 = e v_n,1 = 0.7 · 4.3976 = 3.078 m/s",
    "(6): J = m (v_n,1 + v_n,2)",
    "(7): v_t,2 = v_t,1 - μ J/m",
    "loss = 1/2 m (v² - v_n,2² - v_t,2²)",
])  # fmt: skip
def test_a_velocity_stated_by_a_constant_that_is_sought_is_called_by_it(said: str, tmp_path: Path) -> None:
    assert said in page_of_text(tmp_path, STATED)


def test_a_distance_is_positive_where_the_speed_along_the_slope_is_not(tmp_path: Path) -> None:
    """The slope rises to the right, up which the speed counts, and the ball goes down."""
    text = SLOPE.replace("-beta", "beta").replace("d: r(ball/O).along(beta) @ 4", "d: r(ball/O).mag @ 4")
    page = page_of_text(tmp_path, text.partition("note:")[0])
    assert "d = 1/2 g Δt² sin β - v_t,3 Δt = 1/2 · 9.81 · 0.6925² sin 25° - (-0.5555) · 0.6925 = 1.379 m" in page
