"""A balance in which a body turns about its instantaneous centre needs no relation between velocities before it."""

from __future__ import annotations

from worked import page_of_file


def test_no_step_of_velocities_that_nothing_uses() -> None:
    page = page_of_file("ex-4-10")
    assert "B is the instantaneous centre of AB" in page
    assert "v_B = v_A + ω × r_B/A" not in page
    assert "STEP 1 Work and energy" in page


def test_a_relation_on_which_another_body_rests_stays() -> None:
    """The slider has a speed of its own, which the energies need."""
    assert "Velocities:" in page_of_file("slider-crank-with-a-spring")


def test_the_energy_about_that_centre_is_the_check() -> None:
    assert "about B: I_B = 1/12 m l² + 1/4 m l² = 0.5333 kg·m²; 1/2 I_B ω_2² = 19.36 J = U" in page_of_file("ex-4-10")
