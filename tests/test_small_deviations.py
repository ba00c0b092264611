"""Of small oscillations the forces stand to the first order in the deviation, and energies check the frequency."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "lines"),
    [
        (
            "hinged-beam-critical-damping",
            ["F_E = k L δ - 1/2 m g", "F_F = 1/2 c L δ̇", "ΣM_A: -1/4 c L² δ̇ - k L² δ = I_A α"],
        ),
        (
            "inverted-pendulum",
            ["F_W = -k a δ", "ΣM_O: (m_B g l + 1/2 m_b g l - k a²) δ = I_bar α + 1/2 m_b l α · l/2 + m_B l α · l"],
        ),
        ("disk-held-by-a-spring", ["F_V = 2 k_2 δ", "ΣM_C: (k_1 + 4 k_2) R δ = I_G α - m a_G R"]),
    ],
)
def test_forces_are_linear(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert "to the first order in δ" in page
    for told in lines:
        assert told in page
    assert "sin φ)²" not in page


def test_short_ones_stand_as_they_are() -> None:
    page = page_of_file("block-between-two-springs")
    assert "first order" not in page
    assert "k_2 (b - x - l_2) - k_1 (x - l_1)" in page


def test_a_motion_between_states_needs_the_whole_force() -> None:
    """In the case in which it is let go, the page tells the exact forces; their linear equation serves the others."""
    page = page_of_file("bar-with-spring-and-damper")
    first = page.partition("CASE undamped")[0]
    assert "first order" not in first
    assert "pull of the spring coil: F_coil = k (AK - h)" in first
    assert "As in case light, with c = 0 and δ a small deviation" in page


@pytest.mark.parametrize(
    ("stem", "check"),
    [
        ("inverted-pendulum", "E_k = 1/2 · 1.813 δ̇², V = 1/2 · 13.96 δ² in J; ω_0 = √(13.96/1.813) = 2.774 rad/s"),
        ("hinged-beam-critical-damping", "E_k = 1/6 m L² δ̇², V = 1/2 k L² δ²; ω_0² = 3 k/m"),
        ("half-disk-rocking", "V = 2 m g R δ²/(3 π); ω_0² = 8 g / ((9 π - 16) R)"),
    ],
)
def test_energies_check_the_frequency(stem: str, check: str) -> None:
    assert check in page_of_file(stem)


def test_no_energies_of_an_unstable_equilibrium() -> None:
    page = page_of_file("inverted-pendulum")
    assert "energies near" not in page.partition("CASE soft")[2]


def test_a_spring_is_drawn_as_it_lies_at_rest() -> None:
    """To the first order in δ it pulls along the line in which it lies in the equilibrium, level here."""
    page = page_of_file("disk-held-by-a-spring")
    assert "F_V ← at S" in page
    assert "F_S ↓ at Q" in page_of_file("bar-with-a-mass-on-a-spring")


def test_a_rolling_body_is_summed_about_its_contact() -> None:
    """What has squares of speeds is of the second order: it is left out with a word, and no vector is torn in two."""
    page = page_of_file("toy-on-a-round-end").partition("CASE limit")[0]
    assert "terms with ω² are of the second order in it and left out" in page
    assert "a_G = a_O + α × r_G/O = y_G α ←" in page
    assert "= m y_G α ← at G, I α ↺" in page
    assert "ΣM_C: -m g (r - y_G) δ = I_C α" in page
    assert "Solved for δ̈, this is the equation of motion: (1): δ̈ + m g (r - y_G) δ / (m y_G² + I) = 0" in page
    assert "is stable, as y_G < r: displaced, it returns" in page
    assert "is unstable, as y_G > r: displaced, it moves further away" in page
    assert "cos θ" not in page


def test_a_limit_rests_on_the_mass_centre_alone() -> None:
    """Where nothing swings no dynamics is told; the statement stands in the letter of the mass centre."""
    limit = page_of_file("toy-on-a-round-end").partition("CASE limit")[2]
    assert "y_G = r 1/2 m_2 h = 4 m_1 r/(3 π) with y_G put in 2 r² = 3 h² with m_1, m_2 put in" in limit
    assert "(1): h = √6 r/3 = √6 · 0.1 / 3 = 0.08165 m = 81.65 mm" in limit
    assert "Kinetic analysis" not in limit
    assert "θ" not in limit


def test_a_number_that_nothing_needs_is_not_worked_out_again() -> None:
    """Of another height only the lever decides; the moment of inertia is needed for the period alone."""
    page = page_of_file("toy-on-a-round-end")
    assert page.count("I = m_1 (y_G - y_1)² + m_2 (y_2 - y_G)² + I_1 + I_2") == 1
    assert page.count("I_2 = m_2") == 1
    assert "As before, now with m_2 = 0.9 kg, y_2 = 0.145 m, m = 1.685 kg, y_G = 0.1043 m" in page
