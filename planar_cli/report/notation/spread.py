"""A common denominator that was made for one term is taken back into the sum: m a² + 2/5 m R² + I, not
1/5 (5 m a² + 2 m R² + 5 I).
"""

from __future__ import annotations

import sympy as sp

SMALL = 6
"""Over letters, (2 g h + v²) / (2 h), such a denominator stays where it is."""


def spread(expr: sp.Expr) -> sp.Expr:
    """The same value, term by term."""
    if not expr.is_Add and not expr.is_Mul:
        return expr
    terms = [_term(t) for t in sp.Add.make_args(expr)]
    same = all(a is b for a, b in zip(terms, sp.Add.make_args(expr), strict=True))
    return expr if same else sp.Add(*terms)


def each_half(energy: sp.Expr) -> sp.Expr:
    """Kinetic energies that have no more in common than their 1/2, each with its own: 1/2 I ω² + 1/2 m v²."""
    number, rest = energy.as_coeff_Mul()
    if number == 1 or not rest.is_Add:
        return energy
    return sp.Add(*(number * term for term in rest.args))


def _term(term: sp.Expr) -> sp.Expr:
    number, rest = term.as_coeff_Mul()
    factors = sp.Mul.make_args(rest)
    sums = [f for f in factors if f.is_Add]
    if not number.is_Rational or number.q == 1 or len(sums) != 1:
        return term
    if number.q <= SMALL and any(f.as_base_exp()[1].could_extract_minus_sign() for f in factors):
        return term
    (total,) = sums
    shared = _shared(total, int(number.q))
    if shared == 1:
        return term
    inside = sp.Add(*(_term(t / shared) for t in total.args))
    return sp.Mul(number * shared, *(inside if f is total else f for f in factors))


def _shared(total: sp.Expr, denominator: int) -> int:
    """The largest part of the denominator that divides the numbers of half of the terms; 1: there is none."""
    numbers = [t.as_coeff_Mul()[0] for t in total.args]
    if not all(n.is_Integer for n in numbers) or any(t.is_number or _has_root(t) for t in total.args):
        return 1
    divisors = (d for d in range(denominator, 1, -1) if denominator % d == 0)
    return next((d for d in divisors if 2 * sum(n % d == 0 for n in numbers) >= len(numbers)), 1)


def _has_root(term: sp.Expr) -> bool:
    """Is a root of a number among its factors, beside which a fraction reads worse: 3 √3 v/4?"""
    return any(f.is_Pow and f.is_number for f in sp.Mul.make_args(term))
