"""Signs that the ranges of sines and cosines decide: 2 - cos θ is positive whatever θ is, and |2 - cos θ| is 2 - cos θ.

Nothing is drawn here: the sign of sin θ, or of R - r cos θ, is left open.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms

Range = tuple[sp.Expr, sp.Expr]
ANY: Range = (-sp.oo, sp.oo)
UNIT: Range = (-sp.S.One, sp.S.One)


def certain_sign(expr: sp.Expr) -> int:
    """1: never negative; -1: never positive; 0: that depends on its letters."""
    if expr.is_nonnegative or expr.is_nonpositive:
        return 1 if expr.is_nonnegative else -1
    whole = factor_terms(expr) if expr.is_Add else expr
    if whole.is_Mul:
        sign = 1
        for factor in whole.args:
            sign *= certain_sign(factor)
        return sign
    if whole.is_Pow and whole.exp.is_Integer and whole.exp.is_odd:
        return certain_sign(whole.base)
    if whole.is_Pow and whole.exp.is_Rational and whole.exp.q % 2 == 0:
        return 1  # All is real here, and an even root is not negative.
    low, high = _range(whole)
    return 1 if low >= 0 else -1 if high <= 0 else 0


def with_certain_signs(expr: sp.Expr) -> sp.Expr:
    """Without the bars, and the sign functions, of what has one sign whatever its letters are."""
    signs = {s: certain_sign(s.args[0]) for s in expr.atoms(sp.Abs, sp.sign) if s.args[0].is_real is not False}
    told = {s: way * (s.args[0] if isinstance(s, sp.Abs) else 1) for s, way in signs.items() if way}
    return expr.xreplace(told) if told else expr


def with_positive_divisors(expr: sp.Expr) -> sp.Expr:
    """The minus of a divisor that is never positive before its quotient: -F/(M + m - m cos β)."""
    turned = {}
    for p in (p for p in expr.atoms(sp.Pow) if p.exp == -1):
        negative = {f: -f for f in sp.Mul.make_args(p.base) if f.is_Add and certain_sign(f) == -1}
        if negative:
            turned[p] = (-1) ** len(negative) / sp.Mul(*(negative.get(f, f) for f in sp.Mul.make_args(p.base)))
    return expr.xreplace(turned) if turned else expr


def _range(expr: sp.Expr) -> Range:
    """Between which numbers an expression surely lies."""
    if expr.is_number:
        return (expr, expr) if expr.is_real else ANY
    if isinstance(expr, sp.sin | sp.cos):
        return UNIT
    if expr.is_Add:
        return _sum(_of_sizes(expr.args))
    if expr.is_Mul:
        number, rest = expr.as_coeff_Mul()
        if number == 1:
            return _product(_range(f) for f in expr.args)
        low, high = _range(rest)
        return (number * low, number * high) if number > 0 else (number * high, number * low)
    if expr.is_Pow and expr.exp.is_Integer and expr.exp > 0:
        low, high = _range(expr.base)
        ends = low**expr.exp, high**expr.exp
        if expr.exp.is_odd:
            return ends
        return (sp.S.Zero if low < 0 < high else sp.Min(*ends)), sp.Max(*ends)
    return (sp.S.Zero if expr.is_nonnegative else -sp.oo), (sp.S.Zero if expr.is_nonpositive else sp.oo)


def _sum(ranges: Iterator[Range]) -> Range:
    """The range of a sum."""
    ends = list(zip(*ranges, strict=True))
    return sp.Add(*ends[0]), sp.Add(*ends[1])


def _product(ranges: Iterator[Range]) -> Range:
    """The range of a product of what is bounded."""
    low, high = sp.S.One, sp.S.One
    for one, other in ranges:
        if not all(e.is_finite for e in (one, other)):
            return ANY
        ends = low * one, low * other, high * one, high * other
        low, high = sp.Min(*ends), sp.Max(*ends)
    return low, high


def _of_sizes(terms: Iterable[sp.Expr]) -> Iterator[Range]:
    """The ranges of the terms of a sum, those with the same letters that are never negative together: m (cos θ - 2)."""
    shared: dict[sp.Expr, list[sp.Expr]] = {}
    for term in terms:
        sizes = [f for f in sp.Mul.make_args(term) if f.as_base_exp()[0].is_Symbol and f.is_nonnegative]
        size = sp.Mul(*sizes)
        shared.setdefault(size, []).append(term / size)
    for size, factors in shared.items():
        low, high = _sum(_amplitudes(tuple(factors)))
        if size == 1:
            yield low, high
        else:
            yield (sp.S.Zero if low >= 0 else -sp.oo), (sp.S.Zero if high <= 0 else sp.oo)


def _amplitudes(terms: tuple[sp.Expr, ...]) -> Iterator[Range]:
    """The ranges of the terms of a sum; a sin θ + b cos θ is one wave, √(a² + b²) high."""
    waves: dict[sp.Expr, list[sp.Expr]] = {}
    for term in terms:
        number, rest = term.as_independent(sp.sin, sp.cos, as_Add=False)
        if isinstance(rest, sp.sin | sp.cos) and number.is_number:
            waves.setdefault(rest.args[0], []).append(number)
        else:
            yield _range(term)
    for numbers in waves.values():
        height = sp.sqrt(sp.Add(*(n**2 for n in numbers)))
        yield -height, height
