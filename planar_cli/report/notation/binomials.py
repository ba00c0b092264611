"""A number less a square, for a product with a minus sign: m (1 - e²) for -m (1 + e) (e - 1)."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import sympy as sp


def multiplied(expr: sp.Expr) -> sp.Expr:
    """The expression with every product -(a + 1) (a - 1) in it as 1 - a², also with other numbers."""
    if not any(p.is_Mul and _product(p) is not None for p in sp.preorder_traversal(expr)):
        return expr
    return expr.replace(lambda p: p.is_Mul and _product(p) is not None, _product)


def _product(product: Any) -> sp.Expr | None:
    """The product with one difference of squares; None: it has no minus sign, or no such pair of sums."""
    if product.as_coeff_Mul()[0].is_negative is not True:
        return None
    sums = [f for f in product.args if f.is_Add and len(f.args) == 2]
    for one, other in combinations(sums, 2):
        same = [t for t in one.args if t in other.args]
        turned = [t for t in one.args if -t in other.args]
        if len(same) == len(turned) == 1 and same[0].is_Symbol and turned[0].is_number:
            return sp.Mul(-1, *(f for f in product.args if f not in (one, other)), turned[0] ** 2 - same[0] ** 2)
    return None
