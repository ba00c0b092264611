"""Quotients of sums divided out where a term has the whole divisor as a factor: u q/(M - q t) - g for
(u q - g (M - q t))/(M - q t); and under a root by a letter that all terms but one have: √(2 g h - k s²/m).
"""

from __future__ import annotations

from typing import Any

import sympy as sp

HALF = sp.Rational(1, 2)


def divided_out(expr: sp.Expr) -> sp.Expr:
    """The expression with every such quotient in it divided out."""
    roots = {p: q for p in expr.atoms(sp.Mul) if (q := _root_divided(p)) is not None}
    expr = expr.xreplace(roots) if roots else expr
    if not any(p.is_Mul and _quotient(p) is not None for p in sp.preorder_traversal(expr)):
        return expr
    return expr.replace(lambda p: p.is_Mul and _quotient(p) is not None, _divided)


def _root_divided(product: Any) -> sp.Expr | None:
    """√(2 g h - k s²/m) of √(2 m g h - k s²)/√m, with a number before it; None: more than one term lacks the letter, or
    there is no such root, or more beside it.
    """
    sums = [f for f in product.args if f.is_Pow and f.exp == HALF and f.base.is_Add]
    below = [f.base for f in product.args if f.is_Pow and f.exp == -HALF]
    if len(sums) != 1 or len(below) != 1 or not below[0].is_Symbol:
        return None
    (root,), (letter,) = sums, below
    others = [f for f in product.args if f is not root and f != letter**-HALF]
    if not all(f.is_number for f in others) or sum(letter not in sp.Mul.make_args(t) for t in root.base.args) != 1:
        return None
    whole = sp.sqrt(sp.Add(*(t / letter for t in root.base.args)))
    return sp.Mul(*others, whole)


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
