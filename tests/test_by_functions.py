"""A rate at a state follows from the function of the place that is asked too; no balance gives it again."""

from __future__ import annotations

from worked import page_of_file


def test_a_pendulum_has_its_speed_from_the_function() -> None:
    page = page_of_file("simple-pendulum")
    assert page.index("S = m (g cos θ + l") < page.index("At 2:") < page.index("v_low = ")
    assert "work and kinetic energy" not in page
    assert "Work and energy" not in page


def test_what_is_told_between_states_besides_keeps_its_order() -> None:
    assert "work and kinetic energy" in page_of_file("ex-4-10")
