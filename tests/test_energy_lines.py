"""A balance of energies from rest comes in letters and with every term as a number, without a list of its terms."""

from __future__ import annotations

from worked import page_of_file


def test_every_term_has_its_number_and_none_is_lumped() -> None:
    page = page_of_file("ex-4-09")
    assert "(3) in numbers: 0.225 F - 235.4 - 150 = 0.363 + 3.2 in J" in page
    assert "U of the pull" not in page


def test_an_energy_told_of_the_same_states_is_not_told_again() -> None:
    page = page_of_file("ex-4-09")
    part = page.partition("From 1 to 2, A: work and kinetic energy:")[2]
    assert part.split()[:6] == "U of the tension in the".split()
    assert "T_2 = 1/2 m_A v²" not in part


def test_lines_of_heights_and_stretches_stay() -> None:
    page = page_of_file("ex-4-10")
    assert "U of the spring CB = 1/2 k (s_1² - s_2²)" in page
