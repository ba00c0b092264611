"""Diagrams of impulses over a time, what is taken for granted of bodies without mass, and the check by one work."""

from __future__ import annotations

from worked import page_of_file


def test_impulses_over_a_time_are_drawn_before_their_equations() -> None:
    page = page_of_file("ex-4-18")
    assert (
        "From 1 to 2, from rest: impulses = momenta at 2 (J: impulse of a reaction; the vertical impulses do not enter)"
        in page
    )
    assert "rear: M t_2 ↻, J_OAx → at O_A, J_F,A → at A = I_r ω_rear,2 ↻" in page
    assert "frame, rear, front: J_F,A → at A, J_F,B ← at B = m v_G,2 → at G" in page
    assert page.count("= m v_G,2 → at G") == 1


def test_an_impulse_counts_as_it_acts_and_inner_ones_cancel() -> None:
    """The road holds the front wheel back; of the whole cycle no impulse of an axle enters."""
    page = page_of_file("ex-4-18")
    assert "(1) ↻ H_O,A: M t_2 - J_F,A r = I_r ω_rear,2" in page
    assert "(2) → J_F,A - J_F,B = m r ω_rear,2" in page
    assert "↻ H_O,B: J_F,B r = I_f ω_rear,2" in page


def test_balances_without_such_impulses_need_no_diagram() -> None:
    assert "impulses = momenta" not in page_of_file("ex-4-12")


def test_a_body_without_mass_that_moves_on_is_told() -> None:
    told = "Of rear and front only their rotation is added: their masses are included in that of frame, or negligible."
    assert told in page_of_file("ex-4-18")
    assert "rotation is added" not in page_of_file("two-wheels-pressed-together")


def test_the_work_of_one_source_is_the_kinetic_energy() -> None:
    told = "work and energy: U = M θ_rear,2 = 10 · 52.15 = 521.5 J = T_2"
    assert told in page_of_file("ex-4-18")
