"""An impulse by the momenta as they stand in their equation, where that is shorter than what comes of it."""

from __future__ import annotations

from worked import page_of_file


def test_the_arm_stays_together() -> None:
    page = page_of_file("wheel-over-a-kerb")
    assert "J_Kx = m ((R - h) ω_2 - v_0) = 10 ((0.3 - 0.06) · 4.3333 - 1.5) = -4.6 N·s" in page
