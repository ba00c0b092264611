"""What all terms of a sum have in common put before it, and sums over one fraction stroke.

These are SymPy's `factor_terms` and `together`, with the same results. There each term is an object of three others and
every step makes new ones; here a term is a number and a table of whole exponents, and what a part comes to is
remembered.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import gcd, lcm

import sympy as sp
from sympy.core.exprtools import decompose_power
from sympy.core.mul import _keep_coeff

Powers = dict[sp.Expr, int]
"""Base -> exponent, negative below the fraction stroke. A root is a base of its own."""
Term = tuple[sp.Rational, Powers]
_KEPT = 50_000


@lru_cache(maxsize=_KEPT)
def together(expr: sp.Expr) -> sp.Expr:
    """Sums over one fraction stroke, also inside powers and products, not inside functions."""
    if not usual(expr):
        return sp.together(expr)
    if not expr.args or expr.is_Rational or expr.is_Function:
        return expr
    if expr.is_Add:
        return _sum_together([together(a) for a in expr.args])
    if expr.is_Pow:
        return together(expr.base) ** expr.exp
    return expr.func(*(together(a) for a in expr.args))


@lru_cache(maxsize=_KEPT)
def factor_terms(expr: sp.Expr) -> sp.Expr:
    """What the terms of each sum have in common stands before it."""
    if not usual(expr):
        return sp.factor_terms(expr)
    if not expr.args or expr.is_Rational:
        return expr
    if expr.is_Pow or expr.is_Function:
        args = tuple(factor_terms(a) for a in expr.args)
        return expr if args == expr.args else expr.func(*args)
    content, rest = _content(expr)
    if rest.is_Add:
        parts = [factor_terms(a) for a in rest.args]
        if all(a.as_coeff_Mul()[0].is_negative for a in parts):
            content, parts = -content, [-a for a in parts]
        rest = _common_out(parts)
    elif rest.args:
        rest = rest.func(*(factor_terms(a) for a in rest.args))
    return _keep_coeff(content, rest, clear=False, sign=True)


@lru_cache(maxsize=_KEPT)
def usual(expr: sp.Expr) -> bool:
    """Are its numbers rational or roots, and its exponents rational?"""
    if not expr.args:
        return bool(expr.is_Symbol or expr.is_Rational or expr is sp.pi)
    if (expr.is_Pow and not expr.exp.is_Rational) or isinstance(expr, sp.exp):
        return False
    known = isinstance(expr, sp.Add | sp.Mul | sp.Pow | sp.Function)
    return known and all(isinstance(a, sp.Expr) and usual(a) for a in expr.args)


# --- the parts of factor_terms ----------------------------------------------------------------------------------------


@lru_cache(maxsize=_KEPT)
def _content(expr: sp.Expr) -> tuple[sp.Rational, sp.Expr]:
    """The number that all of an expression has as a factor, and the rest; a fraction only where all terms have one."""
    if expr.is_Mul:
        number, rest = sp.S.One, []
        for a in expr.args:
            own, part = _content(a)
            number *= own
            if part != 1:
                rest.append(part)
        return number, sp.Mul(*rest)
    if not expr.is_Add:
        found: tuple[sp.Rational, sp.Expr] = expr.as_content_primitive(radical=False, clear=False)
        return found
    number, rest = sp.Add(*(_keep_coeff(*_content(a)) for a in expr.args)).primitive()
    if not number.is_Integer and rest.is_Add:
        number, below = number.as_numer_denom()
        divided = rest / below
        if any(a.as_coeff_Mul()[0].is_Integer for a in divided.args):
            return number, divided
        number /= below
    return number, rest


def _common_out(parts: list[sp.Expr]) -> sp.Expr:
    """A sum of what has no number in common: its common powers before it."""
    terms = [_term(p) for p in parts]
    number, common = _shared(terms)
    inner = sp.Add(*(_expr(n / number, _less(p, common)) for n, p in terms))
    # A number before a sum alone goes into it here, as it does wherever SymPy multiplies the two.
    number, before = _expr(number, common).as_coeff_Mul()
    if not number.is_Integer and inner.is_Add:
        above, below = number.as_numer_denom()
        divided = inner / below
        if any(a.as_coeff_Mul()[0].is_Integer for a in divided.args):
            inner, number = divided, above
    return _keep_coeff(number, before * inner, clear=False)


# --- sums of terms ----------------------------------------------------------------------------------------------------


def _sum_together(parts: list[sp.Expr]) -> sp.Expr:
    """Terms over their common denominator, with what they share before them."""
    terms = [_term(p) for p in parts if p != 0]
    if not terms:
        return sp.S.Zero
    if len(terms) == 1:
        number, powers = terms[0]
        common, above, below = sp.S.One, _product({b: e for b, e in powers.items() if e > 0}), powers
    else:
        number, shared = _shared(terms)
        terms = [(n / number, _less(p, shared)) for n, p in terms]
        below = {}
        for _, powers in terms:
            for base, exponent in powers.items():
                if exponent < 0:
                    below[base] = min(exponent, below.get(base, 0))
        above = sp.Add(*(_expr(n, _less(p, below)) for n, p in terms))
        common = _product(shared)
    common = number * common
    if above.is_Add:
        own, above = above.primitive()
        common *= own
    under = _product({b: -e for b, e in below.items() if e < 0})
    number, common = common.as_coeff_Mul()
    return _keep_coeff(number, common * above / under)


@lru_cache(maxsize=_KEPT)
def _term(expr: sp.Expr) -> Term:
    number, factors = expr.as_coeff_mul()
    powers: Powers = {}
    for factor in factors:
        base, exponent = decompose_power(factor)
        exponent = int(exponent)
        if base.is_Add:
            own, base = base.primitive()
            number *= own**exponent
        total = powers.get(base, 0) + exponent
        if total:
            powers[base] = total
        else:
            del powers[base]
    return number, powers


def _shared(terms: Iterable[Term]) -> Term:
    """The number and the powers that all terms have, on the same side of the fraction stroke."""
    (first, *others) = terms
    number, common = first[0], dict(first[1])
    for n, powers in others:
        number = sp.Rational(gcd(number.p, n.p), lcm(number.q, n.q))
        for base, exponent in list(common.items()):
            own = powers.get(base, 0)
            if own * exponent <= 0:
                del common[base]
            else:
                common[base] = min(exponent, own) if own > 0 else max(exponent, own)
    return number, common


def _less(powers: Powers, common: Powers) -> Powers:
    left = dict(powers)
    for base, exponent in common.items():
        total = left.get(base, 0) - exponent
        if total:
            left[base] = total
        else:
            left.pop(base, None)
    return left


def _expr(number: sp.Rational, powers: Powers) -> sp.Expr:
    return number * _product(powers)


def _product(powers: Powers) -> sp.Expr:
    return sp.Mul(*(base**exponent for base, exponent in powers.items()))
