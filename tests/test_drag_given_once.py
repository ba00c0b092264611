"""What a drag is given by is told once, in its magnitude."""

from __future__ import annotations

from worked import page_of_file


def test_the_coefficient_of_a_drag_is_told_in_its_magnitude() -> None:
    page = page_of_file("shell-in-air-that-hits-after-three-seconds")
    assert "drag = 0.04 kg/m · |v|²" in page
    assert "quadratic of the drag" not in page
