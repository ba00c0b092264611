"""How long a part of a motion takes is found by itself, without the clock that would have run before it."""

from __future__ import annotations

from worked import page_of_file


def test_the_fall_before_the_blow_has_no_time() -> None:
    page = page_of_file("pile-driven-into-soil-of-constant-resistance")
    assert "dt: the time from 3 to 4" in page
    assert "0 = v_P,3 + a_P dt" in page
    assert "dt = -v_P,3/a_P = -3.759/(-150.2) = 0.02503 s" in page
    assert "t_2 =" not in page


def test_a_time_that_is_asked_itself_stays() -> None:
    page = page_of_file("slanting-rod-falls-on-a-floor")
    assert "t_2 = √(" in page
    assert "t_flat = -θ_3/ω_3 =" in page


def test_a_place_after_that_time_is_told_by_it() -> None:
    assert "y_G,4 = y_G,3 + v_Gy,3 t_flat - 1/2 g t_flat²" in page_of_file("slanting-rod-falls-on-a-floor")


def test_a_time_that_goes_when_two_equations_are_solved_is_not_needed() -> None:
    page = page_of_file("ball-on-a-rough-slope")
    assert "v_n,3 Δt = 1/2 g Δt² cos β" in page
    assert "t_2 =" not in page
    assert "t_4 =" not in page


def test_that_bodies_stay_in_contact_is_checked() -> None:
    page = page_of_file("pile-driven-into-soil-of-constant-resistance")
    assert "Check N_ram = m_1 (g - a_P) = 48000 N > 0" in page
