"""Dead positions of a linkage: conditions that fix the angle between two bodies have closed roots."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.equation.values.waves import right_angle, wave_put_in
from planar_cli.report.notation.trigonometric_numbers import right_angles
from planar_cli.solve.between.route.angles_between import by_the_angle_between
from planar_cli.solve.regimes.equations import Equation

A, C = sp.symbols("theta_a theta_c", real=True)
R, H = sp.symbols("r h", positive=True)
VALUE = Valuation({R: Decimal("0.12"), H: Decimal("0.3"), A: Decimal(1), C: Decimal(1) - PI / 2})


def told(residual: sp.Expr) -> sp.Expr:
    """A condition of a state as it is told."""
    return by_the_angle_between(Equation(residual, "given", "still", "1"), frozenset({A, C}), VALUE).residual


def test_a_fraction_that_vanishes_with_one_cosine() -> None:
    assert told(R * sp.cos(A - C) / (H * sp.sin(A) + R * sp.cos(A - C))) == sp.cos(A - C)


def test_other_conditions_stay() -> None:
    for residual in (R * sp.cos(A - C) + H, R * sp.sin(A) + H * sp.cos(C), sp.cos(A)):
        assert told(residual) == residual


def test_a_tangent_of_one_angle_and_waves_of_the_other() -> None:
    residual = sp.tan(A) * sp.sin(C) + sp.cos(C)  # cos(A - C)/cos A
    assert told(residual) == sp.cos(A - C)


def test_the_angle_from_the_other() -> None:
    assert right_angle(sp.cos(A - C), C, VALUE) == A - sp.pi / 2
    assert right_angle(sp.cos(A - C), A, VALUE) == C + sp.pi / 2
    assert right_angle(R * sp.sin(A - C) - H, A, VALUE) is None


def test_a_sine_put_into_the_square_of_its_cosine() -> None:
    largest = H * sp.sin(A - C) * sp.sin(A) ** 2 - R * sp.cos(A - C) ** 2 * sp.cos(A)
    line = R * sp.sin(A - C) - H * sp.cos(A)
    put = next(p for p, _ in wave_put_in([largest, line], VALUE) if C not in p.free_symbols)
    assert sp.simplify(put - (H**2 - R**2) / R * sp.cos(A)) == 0


def test_right_angles_beside_degrees() -> None:
    expr, texts = right_angles(A - 3 * sp.pi / 2, {A: "203.6°"})
    assert list(texts.values()) == ["270°"]
    assert sorted(map(str, expr.args)) == ["-270 degrees", "theta_a"]
    assert right_angles(A + sp.pi / 7, {A: "203.6°"}) == (A + sp.pi / 7, {})
    assert right_angles(A - sp.pi / 2, {A: "3.553"}) == (A - sp.pi / 2, {})


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("body-shaper-time-ratio", "θ_arm,left = arccos(-r_c/h) = arccos(-0.12/0.3) = 113.6°"),
        ("body-shaper-time-ratio", "(6) in (5): cos θ_arm,back = 0"),
        ("body-shaper-time-ratio", "θ_crank,left = π/2 + θ_arm,left = 90° + 113.6° = 203.6°"),
        ("body-offset-slider-crank-strokes", "φ_1 = arcsin(e/(l - r_c))"),
        ("rod-through-a-swivelling-sleeve", "(1), (2) together: sin θ_AB,up = 0.4"),
    ],
)
def test_pages(name: str, said: str) -> None:
    page = page_of_file(name)
    assert said in page
    assert "solved numerically" not in page
