"""Of equations that give several unknowns together one is told with the others put in, from which a result follows."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text


def test_restitution_is_put_into_the_momentum() -> None:
    page = page_of_file("carriages-that-collide")
    assert "(1) in (2): m_A v_A,1 + m_B v_B,1 = m_A (v_B,2 - e (v_A,1 - v_B,1)) + m_B v_B,2 hence: v_B,2 =" in page


def test_the_square_of_a_speed_is_put_into_the_energy() -> None:
    page = page_of_file("cylinder-that-rolls-off-a-cylinder")
    assert "m g (R + r) (1 - cos φ_leaves) = 3/4 m g (R + r) cos φ_leaves hence: cos φ_leaves = 4/7" in page


def test_of_three_equations_two_are_put_into_the_third() -> None:
    assert "(2), (3) in (1): M t_2 - v r (m + I_f/r²) = I_r v/r" in page_of_file("ex-4-18")


def test_what_only_numbers_give_keeps_its_equations_in_numbers() -> None:
    page = page_of_file("ball-on-a-cord-that-goes-slack")
    assert "(5) ↺ H_O: 2.771 = 0.8 r_3² φ̇_3 in kg·m²/s" in page
    assert "(4), (5) together: r_3 = 0.5108 m" in page


def test_unknowns_that_are_put_into_an_equation_in_numbers_are_told_by_its_letter() -> None:
    page = page_of_file("slider-crank-free")
    assert "(2): α_OA = 377.9 - 5.745 α_AB in rad/s² (6): A_t = 197.5 - 0.03333 α_OA = 185.0 + 0.1915 α_AB in N" in page
    assert (
        "A_t = 197.5 - 0.03333 α_OA = 185.0 + 0.1915 α_AB in N (2), (6) in (7): α_AB = -14.07/1.273 = -11.05 rad/s²"
        in page
    )


def test_a_closed_form_at_a_state_comes_from_the_solution_of_the_equations() -> None:
    page = page_of_file("two-rods-falling-flat")
    assert "(5): N_C = 1/2 m g + 1/6 m l α_AB" in page
    assert "(5): N_C = 1/4 m g" in page


NOTHING = """
title: A bar that hangs from another and does not pull at it
plane: vertical
given: {a: 2 ft, W: 30 lbf, M: 12 lbf*ft}
points: {A: [0, 0], B: [a, 1 ft], C: [2*a, 0], E: [2*a, 2 ft]}
bodies:
  AB: {rod: [A, B], weight: W}
  BE: {rod: [B, E], weight: 10 lbf}
  EC: {rod: [E, C], weight: 10 lbf}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BE]}
  - pin: {at: E, between: [BE, EC]}
  - pin: {at: C, between: [ground, EC]}
loads: [torque: {body: EC, moment: M}]
instant: [at rest]
find: {A: reaction(A), B: reaction(B/AB), alpha: alpha(AB)}
"""


def test_what_is_left_of_terms_that_cancel_is_zero(tmp_path: Path) -> None:
    """Of masses that are weights by g nothing cancels exactly."""
    page = page_of_text(tmp_path, NOTHING)
    assert "B_t = 0 lbf" in page
    assert "α_AB = (-30 - 2.236 · 0)/1.554 = -19.31 rad/s²" in page
    assert "10⁻" not in page
