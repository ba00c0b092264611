"""A law is written before it is used: of constant acceleration in letters, of an integral both of its sides."""

from __future__ import annotations

from worked import page_of_file


def test_constant_acceleration_has_its_formula_once() -> None:
    page = page_of_file("ex-1-06")
    assert "constant acceleration of the ball along y: v² = v0² + 2 a (y - y_0)" in page
    assert page.count("2 a (y - y_0)") == 1
    assert "0 = v0² - 2 g (y_top - h)" in page
    assert "v_half² = v0² - 2 g (y_half - h)" in page
    assert "the negative root: h/2 < h is passed only on the way down" in page


def test_an_equation_that_shows_every_term_needs_no_formula_before() -> None:
    page = page_of_file("ex-1-10")
    assert "ω_2 = ω_1 + α t_2" in page
    assert "ω_0" not in page


def test_no_two_signs_stand_in_a_row() -> None:
    """The ball runs back: the place at the end less that at the start is negative."""
    page = page_of_file("rolling-ball-off-a-wall")
    assert "v_G,4² = v_G,3² + 2 a_G (x_G,4 - x_G,3)" in page
    assert "+ -" not in page


def test_both_sides_of_an_integral_over_the_way_are_told() -> None:
    page = page_of_file("ex-1-08")
    assert "ω dω = α dθ from θ = 0, ω = 0 to any θ: ∫[0 → ω] ω dω" in page
    assert "1/2 ω² = g sin θ / r" in page


def test_the_work_of_a_force_that_changes_is_an_integral_first() -> None:
    page = page_of_file("crate-on-a-floor-that-gets-rougher")
    integral = "∫[0 → x_P,1] (-m g (μ_0 + q x_P)) dx_P"
    assert f"U of the drag rubbing = {integral} = -m g x_P,1 (μ_0 + 1/2 q x_P,1)" in page
    assert "W = U of the drag rubbing = T_1 - T_0 = -1/2 m v_0²" in page
    assert "∫[r_A → r_B] (-m g R²/r²) dr" in page_of_file("satellite-perigee-apogee")


def test_a_force_that_stays_the_same_needs_no_integral() -> None:
    assert "U of the pull = P (R + r) θ_2" in page_of_file("ex-4-08")


def test_a_datum_of_another_quantity_has_its_relation() -> None:
    assert "At 1, v_A to the left = v_1: r_h ω_1 = v_1 ω_1 = v_1/r_h = 0.1/0.3" in page_of_file("ex-1-10")


def test_the_size_and_angle_of_a_vector_in_letters_have_lines() -> None:
    page = page_of_file("ex-1-02")
    assert "|r_A2_from_A| = 1/2 r √((√3 - 1)² + (1 + √3)²) = √2 r" in page
    assert "direction of r_A2_from_A = arctan(2 + √3) = 75°" in page
    assert "|r_B2_from_B|" not in page
