"""What stands over the equations of a blow, and what its diagrams do without."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "said"), [
    ("carriages-that-collide", "A, B: conservation of momentum along x (no external impulse): (2)"),
    ("carriages-that-collide", "No rebound (e = 0): after the blow A and B have the same velocity v_B,2. A, B:"),
    ("bullet-into-a-hanging-panel", "panel, bullet, angular momentum about A, through which J_Ax and J_Ay pass: (1)"),
    # What does not rebound has one letter.
    ("carriages-that-collide", "(1) → m_A v_A,1 + m_B v_B,1 = (m_A + m_B) v_B,2"),
    ("pile-driven-into-soil-of-constant-resistance", "lost = 1/2 m_1 v_Q,2² - 1/2 (m_1 + m_2) v_P,3² = 1/2 · 300"),
    # All momenta are horizontal: the weights are no matter.
    ("carriages-that-collide", "momentum before + impulses = momentum after. A: m_A v_A,1 →, J ←"),
    # The guide presses on nothing.
    ("pile-driven-into-soil-of-constant-resistance", "pile: J ↓ = m_2 v_P,3 ↓"),
    ("pile-driven-into-soil-of-constant-resistance", "ram, pile: m_1 g ↓ at Q, m_2 g ↓ at P, R ↑ at P"),
])  # fmt: skip
def test_what_a_blow_says(stem: str, said: str) -> None:
    assert said in page_of_file(stem)


def test_a_velocity_that_is_given_is_not_said_again() -> None:
    """v_Ax = 4 m/s stands under Given, of what moves along x alone."""
    assert "At 1, as given" not in page_of_file("carriages-that-collide")


def test_a_contact_on_which_nothing_presses_has_no_impulse() -> None:
    """The friction under a ball that a cue strikes is finite, and the blow short."""
    said = "(the impulses of the weight, the normal force and the friction at C are negligible). ball: J → at S ="
    assert said in page_of_file("billiard-ball")


def test_a_law_is_told_with_the_solution_of_its_equations() -> None:
    printed = page_of_file("billiard-ball")
    assert "(5): α = μ N_C R/I_G = 5 μ g/(2 R)" in printed
    assert "For the angle of the ball" not in printed
    assert "For y of P" not in page_of_file("pile-driven-into-soil-of-constant-resistance")
