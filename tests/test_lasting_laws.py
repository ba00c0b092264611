"""A constant velocity that goes on while something else begins, and a first speed that is sought."""

from __future__ import annotations

from worked import page_of_file


def test_what_goes_on_unchanged_has_one_law() -> None:
    page = page_of_file("police-chase")
    assert "t_gap = 30 · 9.5 = 285 m" in page
    assert "x_A,go" not in page
    assert "mean velocity times the time, x_B:" in page


def test_a_first_speed_that_is_sought_has_no_equation() -> None:
    page = page_of_file("wheel-over-a-kerb").partition("CASE")[2]
    assert "wheel: m v_0 → at G" in page
    assert "v_Gx,1" not in page


def test_what_another_datum_gives_keeps_its_letter() -> None:
    assert "v_cyclist,x,slow = 12 km/h" in page_of_file("wind-felt-by-a-cyclist")
    assert "h = s_splash" in page_of_file("stone-in-well")
