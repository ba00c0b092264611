"""A velocity that the file gives of a point is put into the relations of what goes on from there."""

from __future__ import annotations

from worked import page_of_file


def test_the_rod_follows_from_the_given_velocity_of_its_pin() -> None:
    page = page_of_file("ex-4-07")
    assert "(2) ω_rod = v_O/IO = 1/0.21213 = 4.714 rad/s" in page


def test_not_by_way_of_the_wheel_with_two_signs_that_cancel() -> None:
    page = page_of_file("wheel-that-pushes-a-rod")
    assert "(2) v = (x_B - R) ω_rod" in page
    assert "ω_rod = v/(x_B - R) =" in page
