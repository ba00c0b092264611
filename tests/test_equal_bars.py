"""Two equal bars that fall flat: why the other bar turns the other way, rests at its end, and what is solved for."""

from __future__ import annotations

from worked import page_of_file


def test_two_bars_on_one_page() -> None:
    """a_G of BC is that of its diagram, and α_BC is told, not solved for."""
    text = page_of_file("two-rods-falling-flat")
    assert "r_C/B = [l cos θ, -l sin θ], so that BC is inclined at θ the other way: (3) ω_BC = -θ̇" in text
    assert "C is the instantaneous centre of BC: v_C = -2 l θ̇ sin θ = 0" in text
    assert "each = 1/2 m (1/2 l θ̇_2)² + 1/2 (1/12 m l²) θ̇_2² = 1/6 m l² θ̇_2²" in text
    assert "- ω_BC² r_G,BC/B = [-3/2 l ω_AB², 1/2 l α_AB]" in text
    assert "(4) α_BC = -α_AB" in text
    assert "3 unknowns: N_C, α_AB, A_y" in text
    assert "(5) in (6): α_AB = -3 g/(2 l)" in text


def test_a_velocity_that_is_no_plain_reason_is_not_told() -> None:
    text = page_of_file("slider-crank-with-a-spring")
    assert "B is the instantaneous centre of AB" in text
    assert "B is the instantaneous centre of AB:" not in text
