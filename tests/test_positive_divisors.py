"""Divisors that are negative whatever their letters are stand with the minus before the quotient."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.equation.algebra.bounds import certain_sign, with_positive_divisors

M, m, r = sp.symbols("M m r", positive=True)
phi = sp.Symbol("phi", real=True)
cosine = sp.cos(phi)


@pytest.mark.parametrize(("expr", "sign"), [
    (2 * m * cosine - M - 2 * m, -1), (m * cosine**2 - M - m, -1), (M + m - m * cosine, 1),
    (2 * m * cosine - M - m, 0), (M - m, 0), (m * cosine, 0), (r * m * (3 - cosine) + r * M, 1),
])  # fmt: skip
def test_signs_of_terms_with_the_same_letters(expr: sp.Expr, sign: int) -> None:
    assert certain_sign(expr) == sign


def test_the_minus_of_a_divisor_stands_before() -> None:
    assert with_positive_divisors(M / (r * (m * cosine - M - m))) == -M / (r * (M + m - m * cosine))
    assert with_positive_divisors(M / (m - M)) == M / (m - M)


@pytest.mark.parametrize(("stem", "told"), [
    ("wedge-drawn-to-a-wall-by-its-block", "-m g sin β / (M + 2 m - 2 m cos β), that is to the left"),
    ("bob-on-a-cart", "α = -(M + m) g sin φ / (l (M + m sin² φ)), that is clockwise"),
    ("collar-drawn-up-from-its-rod-by-a-spring", "need |F_rod| = 4/5 k (l_B - l_0) = 4/5 · 18 (1.6667 - 1) = 9.6"),
    ("collar-drawn-up-from-its-rod-by-a-spring", "= 4/5 · 18 (1.6667 - 1) = 9.6 lbf > -μ N = -0.3 (-1.2) = 0.36 lbf"),
])  # fmt: skip
def test_on_the_page(stem: str, told: str) -> None:
    assert told in page_of_file(stem)
