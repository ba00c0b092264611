"""The mass centre and the moment of inertia of a half disk stand on a page once, in one shape."""

from __future__ import annotations

from worked import page_of_file


def test_the_moment_of_inertia_has_one_shape() -> None:
    page = page_of_file("half-disk-rocking")
    assert page.count("I = 1/2 m R² - m (4 R/(3 π))² = (1/2 - 16/(9 π²)) m R²") == 1
    assert "As before: I = (1/2 - 16/(9 π²)) m R²." in page
    assert "32/π²" not in page
    assert page.count("half disk, from O to its mass centre") == 1
