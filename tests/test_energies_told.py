"""A share of an energy is told by the energies of which it is made; what is sought has its own name from the start."""

from __future__ import annotations

from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def test_a_share_of_an_energy_is_told_by_the_energies() -> None:
    page = page_of_file("box-that-tips-over")
    assert "T_1 = 1/2 m v_0² = 1/2 · 40 · 1.7194² = 59.13 J" in page
    # As it stands in the balance of energies.
    assert "T_2 = 1/2 I_C ω_2² = 9.067 · 1.8964² = 32.61 J" in page
    assert "share = 1 - T_2/T_1 = 1 - 3 h² / (4 (b² + h²)) = 1 - 3 · 1² / (4 (0.6² + 1²)) = 0.4485" in page


def test_an_energy_of_a_share_has_the_letter_of_its_page() -> None:
    """T is a time of the file, so that kinetic energies are E_k."""
    (text,) = (p.read_text() for p in PROBLEMS if p.stem == "box-that-tips-over")
    page = Terminal(200).render(narrate(solve_problem(load_text(text.replace("given: {", "given: {T: 4 s, "))[0])))
    assert "share = 1 - E_k,2/E_k,1" in page
    assert "T_1" not in page


def test_energies_of_several_bodies_are_told_in_the_order_of_their_states() -> None:
    page = page_of_file("ball-strikes-the-end-of-a-pinned-rod")
    before, after = page.index("T_1 = 1/2 m v_Bx,1²"), page.index("T_2 = 1/6 M l² ω_2² + 1/2 m v_Bx,2²")
    assert before < after < page.index("lost = ")


def test_what_is_sought_has_one_name() -> None:
    """v_0, which the file seeks, not the velocity of G at state 1."""
    page = page_of_file("box-that-tips-over")
    assert "↻ H_C: 1/2 m v_0 h = I_C ω_2" in page
    assert "v_Gx,1" not in page


def test_what_is_given_at_a_state_keeps_its_name() -> None:
    """The wind goes as fast as the cyclist, whose speed is given, for a reason."""
    page = page_of_file("wind-felt-by-a-cyclist")
    assert "At slow: w_x = v_cyclist,x,slow = 3.333 m/s" in page


def test_a_speed_that_a_balance_has_told_is_not_worked_out_anew() -> None:
    page = page_of_file("slider-crank-with-a-spring")
    assert "v_B,2 = r_c ω_crank,2 (tan θ_AB,2 cos θ_crank,2 - sin θ_crank,2) = -0.09696 ω_crank,2 in m/s" in page
    assert "At 2: v_B = v_B,2 = -0.09696 (-12.51) = 1.213 m/s" in page


def test_a_velocity_that_is_a_sum_has_the_sign_that_it_has_elsewhere() -> None:
    """Also where it is negative: v_P = v_P/W + v_W in the energies as in the answers."""
    page = page_of_file("pendulum-on-a-wagon")
    assert "v_P,2 = v_ball,wagon,2 + v_O,2 T_2 of ball" in page
    assert "v_ball = v_ball,wagon,2 + v_O,2 = " in page
    assert "v_P,2 = -v_ball,wagon,2" not in page
