"""A point of a body on a fixed pin: its speed is r ω, at right angles to its arm; and what stands in which order."""

from __future__ import annotations

from worked import page_of_file


def test_the_speed_of_a_rim_point_is_that_of_the_rim() -> None:
    page = page_of_file("ex-1-09")
    assert "|v_B,2| = R ω = 0.6 · 0.3333 = 0.2 m/s" in page
    assert "direction of v_B,2 = θ_2 + 90° = 38.2° + 90° = 128.2° perpendicular to OB" in page


def test_an_acceleration_has_the_size_of_its_parts() -> None:
    assert "|a_B,2| = √(a_t² + a_n²) = √(0.1² + 0.2667²) = 0.2848 m/s²" in page_of_file("ex-1-10")


def test_what_is_asked_at_the_first_state_stands_before_the_way() -> None:
    page = page_of_file("ex-1-09")
    first = page.index("v_B = R ω = 0.6 · 0.3333 = 0.2 m/s")
    assert first < page.index("From 1 to 2") < page.index("x_B,2")


def test_the_reason_of_a_cord_is_given_once() -> None:
    page = page_of_file("ex-1-10")
    assert page.count("The cable keeps its length and does not slip on the wheel:") == 1
    assert "(1), differentiated: (2) a_A = r_h α" in page
