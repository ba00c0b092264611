"""A product with a minus sign as a number less a square."""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.report.notation.binomials import multiplied
from planar_cli.report.notation.notation import plain

A, B, E, M = sp.symbols("a b e m", positive=True)


@pytest.mark.parametrize(("product", "told"), [
    (-M * (E - 1) * (E + 1) / 2, "1/2 (1 - e²) m"),
    (A - M * (E - 2) * (E + 2), "(4 - e²) m + a"),
])  # fmt: skip
def test_a_number_less_a_square(product: sp.Expr, told: str) -> None:
    made = multiplied(product)
    assert plain(made) == told
    assert sp.expand(made - product) == 0


@pytest.mark.parametrize(
    "product", [M * (E - 1) * (E + 1), -M * (1 - E) * (1 + E), -M * (A - B) * (A + B), -M * (E - 1) * (E + 2)]
)
def test_other_products_stay(product: sp.Expr) -> None:
    assert multiplied(product) == product
