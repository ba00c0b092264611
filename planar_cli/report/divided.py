"""Quotients of sums divided out where a term has the whole divisor as a factor: u q/(M - q t) - g for
(u q - g (M - q t))/(M - q t).
"""

from __future__ import annotations

from typing import Any

import sympy as sp


def divided_out(expr: sp.Expr) -> sp.Expr:
    """The expression with every such quotient in it divided out."""
    if not any(p.is_Mul and _quotient(p) is not None for p in sp.preorder_traversal(expr)):
        return expr
    return expr.replace(lambda p: p.is_Mul and _quotient(p) is not None, _divided)


def _quotient(product: Any) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """A sum, a sum by which it is divided, and the other factors of a product; None: there is no such pair, or no term
    of the first holds the second.
    """
    sums = [f for f in product.args if f.is_Add]
    divisors = [f.base for f in product.args if f.is_Pow and f.exp == -1 and f.base.is_Add]
    if len(sums) != 1 or len(divisors) != 1:
        return None
    (above,), (below,) = sums, divisors
    if not any(f in (below, -below) for term in above.args for f in sp.Mul.make_args(term)):
        return None
    return above, below, product * below / above


def _divided(product: Any) -> sp.Expr:
    found = _quotient(product)
    assert found is not None
    above, below, rest = found
    whole: list[sp.Expr] = []
    left: list[sp.Expr] = []
    for term in above.args:
        factors = sp.Mul.make_args(term)
        sense = 1 if below in factors else -1 if -below in factors else 0
        if sense:
            whole.append(sense * sp.Mul(*(f for f in factors if f != sense * below)) * rest)
        else:
            left.append(term)
    remaining = sp.Add(*left) * rest
    if remaining.could_extract_minus_sign() and any(t.could_extract_minus_sign() for t in below.args):
        remaining, below = -remaining, -below
    return sp.Add(*whole, remaining / below)
