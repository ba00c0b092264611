"""Roots of squares written out, as they come of the sine and cosine of an arctangent: 1/√(1 + h (2 R - h)/(R - h)²) is
(R - h)/R where R is greater than h.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.exact import Valuation

LONGEST = 60
"""A longer formula is left as it is."""


def with_whole_roots(expr: sp.Expr, value: Valuation) -> sp.Expr:
    """The formula with such roots, multiplied out; itself where that leaves a root."""
    if longer(expr, LONGEST) or not any(map(_is_root, expr.atoms(sp.Pow))):
        return expr
    found = sp.cancel(sp.together(expr.replace(_is_root, lambda e: _written_out(e, value))))
    return expr if any(map(_is_root, found.atoms(sp.Pow))) else found


def _is_root(e: sp.Basic) -> bool:
    return isinstance(e, sp.Pow) and abs(e.exp) == sp.Rational(1, 2) and bool(e.base.free_symbols)


def _written_out(root: sp.Pow, value: Valuation) -> sp.Expr:
    """√(a² b) as a √b, where the number of a tells its sign."""
    outside, inside = sp.S.One, sp.S.One
    for factor in sp.Mul.make_args(sp.factor(sp.together(root.base))):
        base, power = factor.as_base_exp()
        number = value.known(base) if power.is_Integer and power % 2 == 0 else None
        if number:
            outside *= (base if number > 0 else -base) ** (power / 2)
        else:
            inside *= factor
    return outside ** (2 * root.exp) * inside**root.exp
