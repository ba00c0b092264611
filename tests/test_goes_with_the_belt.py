"""The speed of a state that is a letter with its line already: nothing more is told of it, and the way follows."""

from __future__ import annotations

from unicodedata import normalize

from worked import page_of_file


def test_a_package_that_goes_with_its_belt_has_the_speed_of_the_belt() -> None:
    page = normalize("NFC", page_of_file("package-set-down-on-a-belt"))
    assert "From 2 to end, constant velocity of P along x, ẋ = u: (5) x_2 + u (t_end - t_2) = L" in page
    assert "For x of P from 2" not in page
    assert "t_end = (L - x_2)/u + t_2" in page
