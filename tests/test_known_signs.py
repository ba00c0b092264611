"""What has a known sign in a motion is not told by its size: with y < 0, |y| is -y."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.solve.between.roots.one_by_one import without_factors
from planar_cli.solve.regimes.equations import Equation

Y, R, K = sp.Symbol("y__2", real=True), sp.Symbol("R", positive=True), sp.Symbol("k", positive=True)


def told(residual: sp.Expr, kind: str, y: str) -> sp.Expr:
    """How an equation is told where y has this value."""
    value = Valuation({R: Decimal("0.4"), K: Decimal(100), Y: Decimal(y)})
    return without_factors(Equation(residual, kind, "smallest", "2"), value).residual


@pytest.mark.parametrize(("y", "size"), [("-0.4", -Y), ("0.4", Y)])
def test_a_cord_whose_length_is_a_size(y: str, size: sp.Expr) -> None:
    assert sp.expand(told(sp.Abs(Y) - R, "link", y) - (size - R)) == 0


def test_what_may_be_zero_keeps_its_size() -> None:
    assert told(sp.Abs(Y) - R, "link", "0").has(sp.Abs)


def test_a_condition_loses_what_its_size_cancels() -> None:
    residual = (1 + 2 * Y) * (R**2 + Y**2) / (R**2 - Y * sp.Abs(Y)) - R
    assert sp.expand(told(residual, "extreme", "-0.4") - (1 + 2 * Y - R)) == 0


def test_a_pulley_pulled_against_a_spring() -> None:
    page = page_of_file("pulley-pulled-against-a-spring")
    assert "(1) 1/2 k R (1 + 2 y_Q,2) = P r" in page
    assert "(2) 0 = 1/2 + R θ_2 + y_Q,2" in page
    assert "solved numerically" not in page


def test_of_a_product_that_vanishes_the_factor_that_does_is_told() -> None:
    """l ω sin θ = 0 while it turns: sin θ = 0; what vanishes altogether, or has one letter of the state, stays."""
    omega, theta = sp.Symbol("omega__2", real=True), sp.Symbol("theta__2", real=True)

    def left(residual: sp.Expr, turning: str, angle: Decimal) -> sp.Expr:
        value = Valuation({R: Decimal("0.4"), omega: Decimal(turning), theta: angle})
        return without_factors(Equation(residual, "given", "as given", "2"), value).residual

    speed = R * omega * sp.sin(theta)
    assert left(speed, "3", +PI) == sp.sin(theta)
    assert left(speed, "0", Decimal(1)) == omega
    assert left(speed, "0", +PI) == speed
    assert left(R * omega, "0", Decimal(1)) == R * omega
