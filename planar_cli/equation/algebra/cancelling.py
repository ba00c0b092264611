"""Fractions whose numerator and denominator have no common factor left, as SymPy's `cancel` makes them.

SymPy takes nearly all of its time to bring the expression into the form of a fraction of polynomials; here that is done
by the parts of this stage, and the polynomials alone are its own.
"""

from __future__ import annotations

from functools import lru_cache

import sympy as sp
from sympy.polys.rings import sring

from planar_cli.equation.algebra.common_factors import factor_terms, together, usual
from planar_cli.equation.algebra.expansion import expanded

_KEPT = 20_000


@lru_cache(maxsize=_KEPT)
def cancelled(expr: sp.Expr) -> sp.Expr:
    """One fraction of two polynomials without a common factor."""
    if not usual(expr):
        return sp.cancel(expr)
    if not expr.args or expr.is_Rational:
        return expr
    above, below = (expanded(e) for e in sp.fraction(together(factor_terms(expr))))
    if below.is_Number:
        return expanded(above / below)
    ring, (first, second) = sring((above, below), expand=False)
    if not ring.ngens:
        return expanded(above / below)
    first, second = first.cancel(second)
    return first.as_expr() / second.as_expr()
