"""The mass centre and the moment of inertia of a half disk stand on a page once, in one shape."""

from __future__ import annotations

from worked import page_of_file


def test_the_moment_of_inertia_has_one_shape() -> None:
    page = page_of_file("half-disk-rocking")
    assert page.count("I = 1/2 m R² - m (4 R/(3 π))² = (1/2 - 16/(9 π²)) m R²") == 1
    assert "As before: I = (1/2 - 16/(9 π²)) m R²." in page
    assert "32/π²" not in page
    assert page.count("half disk, from O to its mass centre") == 1


def test_a_number_with_pi_in_a_sum_is_told_in_decimals() -> None:
    page = page_of_file("half-disk-rocking")
    assert "T = π √((9 π - 16) R / (2 g)) = 7.783 √(R/g)" in page
    assert "= -1.142 √(g/R), that is clockwise" in page
    assert "normal = (1 + 64 / (3 π (9 π - 16))) m g = 1.553 m g Check" in page


def test_a_factor_of_pi_alone_is_not() -> None:
    assert "T = 2 π √(7 (R - r) / (5 g)) Check" in page_of_file("ball-rolling-in-a-bowl")
