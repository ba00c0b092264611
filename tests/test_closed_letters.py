"""Results of an instant in the letters of the file in one chain, and reactions that nothing calls for."""

from __future__ import annotations

import unicodedata

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-4-06", ["I_A = m (L/4)² + I = 7/48 m L²", "(2): α = m g L/(4 I_A) = 12 g/(7 L)", "a_G = 1/4 L α = 3 g/7",
                 "(3): A_y = m (g - a_G) = 4/7 m g Answer"]),
    ("ex-4-04", ["α = m g L / (8 (1/32 m L² + I)) = 12 g/(11 L) (2): T", "= 4 √2/11 m g Answer"]),
    ("ring-on-a-pin", ["I_O = m R² + I_G = 2 m R²", "α = m g R/I_O = g/(2 R)"]),
])  # fmt: skip
def test_a_result_in_letters_is_one_chain(stem: str, lines: list[str]) -> None:
    told = page_of_file(stem)
    assert [line for line in lines if line not in told] == []


def test_a_long_formula_is_not_told_twice() -> None:
    """Of five links the letters of the file make large fractions; only what is asked is told by them."""
    assert "0.5035" not in page_of_file("chain-5-symbols")


def test_a_reaction_along_which_nothing_acts_is_zero() -> None:
    assert "rod: (3) ↓ ΣF_y: m g - A_y = m a_G → ΣF_x: A_x = 0 STEP 3" in page_of_file("ex-4-06")
    assert "O_x = 0" not in page_of_file("ex-4-09"), "nothing asks for the force of this pin"
    assert "so that" not in page_of_file("ring-on-a-pin")


def test_a_moment_of_inertia_by_a_distance_keeps_its_number() -> None:
    assert "I_O = m (l/2)² + I = 1/4 · 5 · 1.5² + 0.9375 = 3.75 kg·m²" in page_of_file("exercise-4-32")


def test_what_a_guide_presses_is_not_told_where_nothing_asks() -> None:
    assert "N_P = 0" not in page_of_file("bungee-jump")


@pytest.mark.parametrize(("stem", "lines"), [
    ("atwood-machine", ["(2): T_cord = m_A g + m_A a_Ay (1), (2) in (3): a_Ay = -(m_A - m_B) g / (m_A + m_B)",
                        "(2): T_cord = 2 m_A m_B g / (m_A + m_B) Answer"]),
    ("plans/block-on-wedge", ["(1) in (2): a_S =", "(3): a_P,wedge = -g sin β - a_S cos β = -(M + m) g sin β"]),
])  # fmt: skip
def test_what_is_put_in_and_where_a_formula_comes_from_is_said(stem: str, lines: list[str]) -> None:
    told = page_of_file(stem)
    assert [line for line in lines if line not in told] == []
    assert "in terms of" not in told


def test_an_acceleration_given_as_a_letter_is_that_letter() -> None:
    """In the lift what is asked is the unknown, and the lift's own acceleration is a_0 wherever it stands."""
    told = unicodedata.normalize("NFC", page_of_file("atwood-machine-in-a-lift"))
    assert "T - m_1 g = m_1 (a_0 - z̈)" in told
    assert "T = m_1 (g + a_0 - z̈) (1) in (2): z̈ = (m_1 - m_2) (g + a_0) / (m_1 + m_2)" in told
    assert "y_A = s - z differentiated twice: a_Ay = a_0 - z̈" in told
    assert told.count("s̈") == 1


def test_a_share_of_energies_shows_what_it_rests_on() -> None:
    page = page_of_file("box-that-tips-over")
    assert "share = 1 - T_2/T_1 = 1 - 3 h² / (4 (b² + h²)) = 1 - 3 · 1² / (4 (0.6² + 1²)) = 0.4485" in page
