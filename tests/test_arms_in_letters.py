"""The arm of a force is multiplied out where that keeps its letters: no number hides lengths of the file."""

from __future__ import annotations

from worked import page_of_file


def test_a_moment_of_a_mass_times_an_acceleration_has_its_letters() -> None:
    page = page_of_file("rod-disk-wall")
    assert "√2/2 N_E l - √2/4 m g l = 1/4 m l² α_rod + I_rod α_rod - √2/4 m a_O l" in page


def test_a_long_sum_of_moments_has_its_masses_and_arms_before_it_is_collected() -> None:
    page = page_of_file("slider-crank-free")
    assert (
        "1.5 · 9.81 · 0.1436 - 0.5745 A_t = 0.01125 α_AB - 2 (-2.6112)² · 0.16777 - 1.5 (-2.6112)² · 0.083884" in page
    )
    assert "collected: 2.113 - 0.5745 A_t = -21.22 - 0.1822 α_OA + 0.1166 α_AB" in page
