"""What an attraction by the square of the distance brings, as the difference of two reciprocals: (1/r_B - 1/r_A) for
(r_A - r_B)/(r_A r_B).
"""

from __future__ import annotations

import sympy as sp


def with_reciprocals(expr: sp.Expr) -> sp.Expr:
    """Each product with such a difference in it, told so."""
    return expr.replace(lambda x: x.is_Mul and any(f.is_Add for f in x.args), _told) if expr.has(sp.Pow) else expr


def _told(product: sp.Expr) -> sp.Expr:
    for factor in product.args:
        terms = [t.as_coeff_Mul() for t in factor.args] if factor.is_Add else []
        if len(terms) != 2 or {c for c, _ in terms} != {1, -1} or not all(s.is_Symbol for _, s in terms):
            continue
        (plus,), (minus,) = ([s for c, s in terms if c == sign] for sign in (1, -1))
        if {1 / plus, 1 / minus} <= set(product.args):
            rest = [f for f in product.args if f not in (factor, 1 / plus, 1 / minus)]
            negative = sp.Mul(*rest).could_extract_minus_sign()
            inside = sp.Add(1 / plus, -1 / minus) if negative else sp.Add(1 / minus, -1 / plus)
            return sp.Mul(-sp.Mul(*rest) if negative else sp.Mul(*rest), inside)
    return product
