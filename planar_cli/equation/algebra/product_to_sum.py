"""Products of sines and cosines as sums, as SymPy's step TR8 finds them, at a part of its price.

sin a cos b = (sin(a + b) + sin(a - b))/2 and the like (Fu, Zhong, Zeng 2006, rule TR8). SymPy multiplies out every
product on its way up and goes through all of the result again; here what a part comes to is remembered, and parts in
which no two functions of angles can meet are not looked into.
"""

from __future__ import annotations

from functools import lru_cache

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

KEPT = 20_000
"""So many parts are remembered."""


@lru_cache(maxsize=KEPT)
def as_sums(expr: sp.Expr, first: bool = True) -> sp.Expr:
    """What the step makes of an expression. `first`: numerators and denominators are multiplied out."""
    if _meeting(expr) < 2:
        return expr
    inside = tuple(as_sums(a, first) for a in expr.args)
    if inside != expr.args:
        expr = expr.func(*inside)
    powers = expr.is_Pow and expr.base.func in {sp.cos, sp.sin} and (expr.exp.is_integer or expr.base.is_positive)
    if not (expr.is_Mul or powers):
        return expr
    return _of_fraction(expr) if first else _of_product(expr)


@lru_cache(maxsize=KEPT)
def _meeting(expr: sp.Basic) -> int:
    """How many functions of angles are multiplied or divided by each other at most, here or in a part."""
    inside = [_meeting(a) for a in expr.args]
    most = max(inside, default=0)
    if isinstance(expr, TrigonometricFunction):
        return max(most, 1)
    if isinstance(expr, sp.Mul):
        return sum(inside)
    if isinstance(expr, sp.Pow):
        return max(most, inside[0] * (abs(int(expr.exp)) if expr.exp.is_Integer else 2))
    return most


def _of_fraction(expr: sp.Expr) -> sp.Expr:
    """A product or a power, seen as a fraction."""
    above, below = (sp.expand_mul(e) for e in expr.as_numer_denom())
    new_above, new_below = as_sums(above, first=False), as_sums(below, first=False)
    if new_above == above and new_below == below:
        return expr
    found = sp.gcd_terms(new_above / new_below)
    if found.is_Mul and found.args[0].is_Rational and len(found.args) == 2 and found.args[1].is_Add:
        found = sp.Mul(*found.as_coeff_Mul())
    return found


def _of_product(expr: sp.Expr) -> sp.Expr:
    """A product of powers."""
    cosines: list[sp.Expr] = []
    sines: list[sp.Expr] = []
    others: list[sp.Expr] = []
    for factor in sp.Mul.make_args(expr):
        base, times = factor, 1
        if factor.is_Pow and factor.exp.is_Integer and factor.exp > 0:
            base, times = factor.base, int(factor.exp)
        if base.func in {sp.cos, sp.sin}:
            (cosines if base.func == sp.cos else sines).extend([base.args[0]] * times)
        else:
            others.append(factor)
    if not (cosines and sines) and len(cosines) < 2 and len(sines) < 2:
        return expr
    while sines and cosines:
        a, b = sines.pop(), cosines.pop()
        others.append((sp.sin(a + b) + sp.sin(a - b)) / 2)
    while len(cosines) > 1:
        a, b = cosines.pop(), cosines.pop()
        others.append((sp.cos(a + b) + sp.cos(a - b)) / 2)
    while len(sines) > 1:
        a, b = sines.pop(), sines.pop()
        others.append((-sp.cos(a + b) + sp.cos(a - b)) / 2)
    left = [*map(sp.cos, cosines), *map(sp.sin, sines)]
    return as_sums(sp.expand_mul(sp.Mul(*others, *left)))
