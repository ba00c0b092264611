"""Two bodies that move alike, by symmetry, have one speed, and no place of which nothing else speaks."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize("line", [
    "From 1 to 2, B moves as A does, by symmetry. From 1 to 2, rod, A, B:",
    "I_O,1 = 2 m_A d_A,1² + I_0 + 2 I_A = 2 · 0.06211 · 0.4167² + 0.25 + 2 · 0.001553 = 0.2747 slug·ft²",
    "collected: I_O,1 w_0 = I_O,2 ω_rod,2",
    "T_2 = 1/2 I_O,2 ω_rod,2² + m_A v_A,rod,2²",
    "(2): v_A,rod,2 = √((4.944 - 1.714)/0.06211) = 7.211 ft/s",
    "v² = (d ω)² + v_rel² of what slides T_2 = 1/2 I_O,2 ω_rod,2² +",
    "T_3 = 1/2 I_O,2 ω_rod,3² = 1/2 · 0.7923 · 2.080² = 1.714 lbf·ft lost = T_2 - T_3 = 4.944 - 1.714 = 3.230 lbf·ft",
    "the internal forces between the bodies no net work",
])  # fmt: skip
def test_spheres_on_a_rod_have_one_speed(line: str) -> None:
    assert line in page_of_file("spheres-that-slide-out-to-stops")


@pytest.mark.parametrize("word", ["s_A", "s_B", "v_B,rod"])
def test_what_nothing_speaks_of_is_not_told(word: str) -> None:
    assert word not in page_of_file("spheres-that-slide-out-to-stops")


def test_balls_in_a_tube() -> None:
    page = page_of_file("two-balls-in-a-turning-tube")
    assert "s_Q" not in page
    assert "T_end = 1/2 I_O,end ω_end² + m_P v_P,tube,end²" in page
