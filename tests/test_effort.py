"""Energy before Newton's law where several bodies move and only speeds and places are asked."""

from __future__ import annotations

from worked import page_of_file


def test_speed_and_way_of_several_bodies_follow_from_one_balance_of_energies() -> None:
    page = page_of_file("load-on-four-strands")
    assert "Principle Work and energy between the states." in page
    assert "ΣF" not in page
    assert "= 5.844 m/s², constant; 2 " in page, "Newton's law is the check"


def test_where_a_force_is_asked_newtons_law_stays() -> None:
    assert "ΣF_y" in page_of_file("gears-turned-by-a-load")


def test_with_newtons_law_a_constant_acceleration_is_shorter_than_energies() -> None:
    page = page_of_file("ex-4-09")
    assert "Principle Newton's second law. Constant angular acceleration." in page
    assert "(6) θ̈ = ω_2²/(2 θ_2) = 2² / (2 · 3) = 0.6667 rad/s²" in page
    assert "Check work and energy: T_1 + U = 0 - 235.44 + 389.003 - 150 = 3.563 J = T_2" in page


def test_a_way_between_given_places_is_in_letters() -> None:
    assert "(5) θ_2 = h/R = 0.6/0.2 = 3 rad" in page_of_file("ex-4-09")
