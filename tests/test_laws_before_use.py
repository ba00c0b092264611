"""A law is written before it is used: of constant acceleration in letters, of an integral both of its sides."""

from __future__ import annotations

from worked import page_of_file


def test_constant_acceleration_has_its_formula_once() -> None:
    page = page_of_file("ex-1-06")
    assert "constant acceleration, y of ball: v² = v_0² + 2 a (y - y_0)" in page
    assert page.count("2 a (y - y_0)") == 1
    assert "0 = v0² - 2 g (y_ball,top - h)" in page
    assert "v_ball,y,half² = v0² - 2 g (y_ball,half - h)" in page


def test_an_equation_that_shows_every_term_needs_no_formula_before() -> None:
    page = page_of_file("ex-1-10")
    assert "ω_2 = ω_1 + α t_2" in page
    assert "ω_0" not in page


def test_both_sides_of_an_integral_over_the_way_are_told() -> None:
    page = page_of_file("ex-1-08")
    assert "θ̇ dθ̇ = θ̈ dθ: ∫[0 → θ̇] θ̇ dθ̇" in page
    assert "1/2 θ̇² = g sin θ / r" in page
