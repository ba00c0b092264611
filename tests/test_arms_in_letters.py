"""The arm of a force is multiplied out where that keeps its letters: no number hides lengths of the file."""

from __future__ import annotations

from worked import page_of_file


def test_a_moment_of_a_mass_times_an_acceleration_has_its_letters() -> None:
    page = page_of_file("rod-disk-wall")
    assert "√2/2 N_E l - √2/4 m g l = 1/4 m l² α_rod + I_rod α_rod - √2/4 m a_O l" in page


def test_moments_about_an_instantaneous_centre_have_the_components_of_accelerations_and_named_arms() -> None:
    page = page_of_file("slider-crank-free")
    assert "(3) a_G,AB,x = -12.23 - 0.08660 α_OA + 0.04330 α_AB in m/s²" in page
    assert "= m_AB a_G,AB,x → at G_AB, m_AB a_G,AB,y ↑ at G_AB, I_AB α_AB ↺" in page
    assert "moments about C at (x_B, √3 x_B), the instantaneous centre of AB, where the lines of A_n and" in page
    assert (
        "(7) ↺ ΣM_C: 1/2 m_AB g (x_B - r/2) + A_t (r - 2 x_B) = √3 m_AB a_G,AB,x (x_B - r/4) + √3 m_B a_B x_B"
        " + 1/2 m_AB a_G,AB,y (r/2 - x_B) + I_AB α_AB"
    ) in page


def test_an_equation_in_accelerations_that_are_known_gets_their_numbers() -> None:
    page = page_of_file("slider-crank-driven")
    assert "(6): A_t = (2.113 - 0.01125 · 116.9 - 0.8112 (-16.68) + 0.2154 (-17.32) - 1.1682 (-13.353))/0.5745" in page


def test_a_long_sum_of_moments_has_its_masses_and_arms_before_it_is_collected() -> None:
    page = page_of_file("chain-5")
    assert "= 0.02 α_CD + 0.04167 α_DE - 1.5 · 0.03473 a_G,CD,x + 1.5 · 0.19696 a_G,CD,y" in page


def test_half_of_a_rod_that_coordinates_place_is_told_by_its_length() -> None:
    assert "1/2 m_AB b α_AB ↖ at G_AB" in page_of_file("four-bar-driven")
