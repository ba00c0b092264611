"""How long expressions are: as SymPy counts their operations, each part once."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

_KEPT = 50_000


@lru_cache(maxsize=_KEPT)
def operations(expr: sp.Expr) -> int:
    """How many operations an expression has: as SymPy's `count_ops` counts them, part by part, each remembered."""
    if expr.is_Rational:
        return int(expr.p < 0) + int(expr.q != 1)
    if not expr.args or not isinstance(expr, sp.Expr):
        return 0 if expr.is_Symbol else int(sp.count_ops(expr))
    if expr.is_Mul:
        return _of_product(expr)
    if expr.is_Add:
        signs = [_negative(t) for t in expr.args]
        terms = sum(operations(-t if negative else t) for t, negative in zip(expr.args, signs, strict=True))
        return terms + len(signs) - 1 + int(all(signs))
    if expr.is_Pow and expr.exp == -1:
        return 1 + operations(expr.base)
    if expr.is_Pow or (isinstance(expr, sp.Function) and not expr.is_Piecewise):
        return 1 + sum(operations(a) for a in expr.args)
    return int(sp.count_ops(expr))


def _negative(expr: sp.Expr) -> bool:
    """Does a minus sign stand before it?"""
    first = expr.args[0] if expr.is_Mul else expr
    return bool(first.p < 0 if first.is_Rational else first.is_Number and first.is_negative)


def _without_stroke(product: sp.Expr) -> bool:
    """Do all factors surely stand above a fraction stroke?"""
    return not product.is_Number and all(
        f.is_Symbol or f.is_Add or f.is_Integer or (f.is_Pow and f.exp.is_Rational and f.exp.p > 0)
        for f in sp.Mul.make_args(product)
    )


def _of_product(product: sp.Expr) -> int:
    """The operations of a product: its sign, the fraction stroke, and what stands above and below it."""
    sign = int(_negative(product))
    if sign:
        product = product.as_two_terms()[1] if product.args[0] == -1 else -product
    above, below = (product, sp.S.One) if _without_stroke(product) else sp.fraction(product)
    if above.is_Integer:
        return sign + 1 + int(above.p < 0) + operations(below)
    if below != 1:
        return sign + 1 + operations(above) + (0 if below.is_Integer else operations(below))
    if not (product.is_Mul or product.is_Add):
        return sign + operations(product)
    # Of a sum with a minus sign before it SymPy counts the terms only.
    return sign + sum(operations(a) for a in product.args) + (len(product.args) - 1 if product.is_Mul else 0)
