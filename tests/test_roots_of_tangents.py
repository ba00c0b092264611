"""Equations in the tangent, sine and cosine of one angle: what is 1 together is 1, and the root has a closed form."""

from __future__ import annotations

import math
from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.roots.closed import closed_roots

A = sp.Symbol("alpha", real=True)
G, D, V = sp.symbols("g d v_0", positive=True)
VALUE = Valuation({G: Decimal("9.81"), D: Decimal(8), V: Decimal(15)})


@pytest.mark.parametrize(
    "residual",
    [
        1 + sp.tan(A) ** 2 - G * D * sp.sin(A) / (V**2 * sp.cos(A) ** 3),
        D / sp.cos(A) ** 2 - G * D**2 * sp.sin(A) / (V**2 * sp.cos(A) ** 3),
        1 / sp.cos(A) ** 2 - G * D / V**2 * sp.tan(A) * (1 + sp.tan(A) ** 2),
    ],
)
def test_one_and_the_square_of_a_tangent(residual: sp.Expr) -> None:
    truth = Decimal(repr(math.atan(225 / (9.81 * 8))))
    roots = closed_roots(residual, A, VALUE, truth, True)
    assert sp.atan(V**2 / (G * D)) in [r.expression for r in roots]


def test_a_jet_that_reaches_highest_on_a_wall() -> None:
    page = page_of_file("jet-that-reaches-highest-on-a-wall")
    assert "α = arctan(v_0²/(g d))" in page
    assert "Answer tan_α = v_0²/(g d) " in page
