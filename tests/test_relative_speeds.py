"""The speed at which two bodies meet stands in a formula as one difference."""

from __future__ import annotations

from worked import page_of_file


def test_what_restitution_gives_back() -> None:
    page = page_of_file("carriages-that-collide")
    assert "v_B,2 = (e m_A (v_A,1 - v_B,1) + m_A v_A,1 + m_B v_B,1)/(m_A + m_B)" in page
    assert "v_A,2 = v_B,2 - e (v_A,1 - v_B,1) = 4.06 - 0.7 (4 - 1) = 1.96 m/s" in page
