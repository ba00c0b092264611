"""What the accelerations rest on without having its letter, ω = 0 of a body that only begins to turn, has a line."""

from __future__ import annotations

from worked import page_of_file


def test_an_angular_velocity_that_vanishes_is_told() -> None:
    _, _, state = page_of_file("slider-crank-two-positions").partition("STATE 2")
    assert "ω_AB (x_B - r_c cos θ) = 0 hence ω_AB = 0" in state
    assert state.index("hence ω_AB = 0") < state.index("a_B = a_A + α_AB × r_B/A")


def test_what_the_file_gives_is_not_told_again() -> None:
    page = page_of_file("plate-sliding-on-table")
    assert "ω_plate = 0" in page.partition("STEP 1")[0]
    assert "ω = 0" not in page.partition("STEP 1")[2]
