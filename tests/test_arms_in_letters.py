"""The arm of a force is multiplied out where that keeps its letters: no number hides lengths of the file."""

from __future__ import annotations

from worked import page_of_file


def test_a_moment_of_a_mass_times_an_acceleration_has_its_letters() -> None:
    page = page_of_file("rod-disk-wall")
    assert "N_E (√2 l/2 + R) - √2/4 m g l = 1/4 m l (√2 R + l) α_rod + m R (√2 l/4 + R) α_disk" in page
    assert "(4) in numbers: 0.3121 N_E - 0.5203 = 0.02530 α_disk + 0.02030 α_rod" in page


def test_a_long_sum_of_moments_has_its_masses_and_arms_before_it_is_collected() -> None:
    page = page_of_file("slider-crank-free")
    assert (
        "1.5 · 9.81 · 0.1436 - 0.5745 A_t = 0.01125 α_AB - 2 (-2.6112)² · 0.16777 - 1.5 (-2.6112)² · 0.083884" in page
    )
    assert "collected: 2.113 - 0.5745 A_t = -21.22 - 0.1822 α_OA + 0.1166 α_AB" in page
