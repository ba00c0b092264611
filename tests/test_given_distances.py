"""The distance of a constructed point from where it is measured has the letter of the file."""

from __future__ import annotations

from worked import page_of_file


def test_a_rod_to_a_constructed_point_has_its_length() -> None:
    page = page_of_file("four-bar-driven")
    assert "I_C = 1/4 m_CB c² + I_CB = 1/4 · 2 · 0.4² + 0.02667 = 0.1067 kg·m²" in page
    assert "F_Bx = -(B_n (d - x_B) + B_t y_B)/c = " in page
    assert "√(y_B² + (d - x_B)²)" not in page
