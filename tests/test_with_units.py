"""Equations in letters tell the units of the lengths, forces and moments among them that no letter names."""

from __future__ import annotations

from worked import page_of_file


def test_an_arm_without_a_letter_has_its_unit() -> None:
    page = page_of_file("bicycle-driven-and-braked")
    assert (
        "↺ ΣM_B: m_frame g (b - 0.45 m) + m_rear g b + F_C R - N_C b = m_frame a_G (R - 1.1 m) - I_rear α_rear" in page
    )
    assert "= (72 · 9.81 (1.05 - 0.45) + 2 · 9.81 · 1.05 + 0.25 · 1.043" in page
    assert "+ 27.83 · 0.35 - 72 · 0.3651 (0.35 - 1.1))/1.05 = 451.5 N" in page


def test_a_moment_without_a_letter_has_its_unit() -> None:
    page = page_of_file("body-rotor-with-varying-torque")
    assert "ΣM_O: -5 N·m = I_O α (5): α = -(5 N·m)/I_O = -5/0.9 = -5.556 rad/s²" in page


def test_lengths_in_feet() -> None:
    page = page_of_file("drum-braked-by-a-lever")
    assert "ΣM_C: μ_k N (0.8333 ft - R) + N (1 ft) - P (3 ft) = 0" in page
    assert "N = P (3 ft) / (1 ft + μ_k (0.8333 ft - R)) = 3 · 20 / (1 + 0.35 (5/6 - 0.6667)) = 56.69 lbf" in page
