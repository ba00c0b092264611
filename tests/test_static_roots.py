"""Roots that show the value they would have without one of their terms: √(2 g h + m g²/k)."""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.report.notation.static_roots import with_static_roots

M, G, K, H = sp.symbols("m g k h", positive=True)
X = sp.Symbol("x", real=True)


@pytest.mark.parametrize(("expr", "told"), [
    (sp.sqrt(G * (M * G + 2 * K * H) / K), sp.sqrt(2 * G * H + M * G**2 / K)),
    (M * G + sp.sqrt(M * G * (M * G + 2 * K * H)), M * G * (1 + sp.sqrt(1 + 2 * K * H / (M * G)))),
    (M * G - sp.sqrt(M * G * (M * G + 2 * K * H)), M * G * (1 - sp.sqrt(1 + 2 * K * H / (M * G)))),
])  # fmt: skip
def test_roots_by_what_they_are_without_a_term(expr: sp.Expr, told: sp.Expr) -> None:
    assert with_static_roots(expr) == told
    numbers = {M: 2, G: 10, K: 300, H: 0.4}
    assert sp.N(expr.xreplace(numbers) - told.xreplace(numbers)) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("expr", [
    sp.sqrt(G * (M + K) / (M * H)),
    sp.sqrt((M * G - H) / (M * K)),
    sp.sqrt(X * G * (M * G + K)),
    2 * M * G + sp.sqrt(M * G * (M * G + 2 * K * H)),
])  # fmt: skip
def test_other_roots_stay(expr: sp.Expr) -> None:
    assert with_static_roots(expr) == expr
