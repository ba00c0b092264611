"""An equilibrium at 180° is shown, a force there has its line, and no root is taken where only its square is asked."""

from __future__ import annotations

from worked import page_of_file


def test_equilibrium_is_shown_where_the_angle_is_not_zero() -> None:
    page = page_of_file("simple-pendulum")
    assert page.count("at rest, it stays there") == 1
    assert "At θ = 180°: θ̈ = -g sin 180° / l = 0 at rest, it stays there" in page


def test_force_at_the_equilibrium_has_its_line_and_its_meaning() -> None:
    page = page_of_file("simple-pendulum")
    assert "with θ = 180°, θ̇ = 0: S_top = m g cos 180° = -m g" in page
    assert "S_top = -m g, that is compression" in page


def test_sign_of_a_root_is_not_told_where_only_its_square_is_asked() -> None:
    page = page_of_file("simple-pendulum")
    assert "root" not in page
    assert "1/2 θ̇² = g (cos θ - cos θ_0) / l ω_squared = θ̇² = 2 g (cos θ - cos θ_0) / l" in page
