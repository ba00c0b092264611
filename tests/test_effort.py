"""Energy before Newton's law where several bodies move and only speeds and places are asked."""

from __future__ import annotations

from worked import page_of_file


def test_speed_and_way_of_several_bodies_follow_from_one_balance_of_energies() -> None:
    page = page_of_file("load-on-four-strands")
    assert "Principle Work and energy between the states." in page
    assert "ΣF" not in page
    assert "a_Ay is constant, 2" in page, "Newton's law is the check"


def test_where_a_force_is_asked_newtons_law_stays() -> None:
    assert "ΣF_y" in page_of_file("gears-turned-by-a-load")
