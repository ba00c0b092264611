"""Products multiplied out, as SymPy's `expand` does it, at a part of its price.

SymPy goes through all of an expression a dozen times, rebuilding it, and multiplies terms two by two as expressions.
Here every part is gone through once and remembered, and terms are multiplied as tables of powers. What a sum stands
under is multiplied out as well, beside its number: x/(2 y (a + b)) becomes x/(2 (a y + b y)).
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import comb, prod

import sympy as sp
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction, TrigonometricFunction

Powers = frozenset[tuple[sp.Expr, sp.Expr]]
"""A product without its number: (base, exponent) of each factor."""
Terms = dict[Powers, sp.Expr]
"""A sum: its products and their numbers."""
WIDEST = 20_000
"""What would come to more terms than this, those above the fraction stroke times those below, is left as it is."""
_KEPT = 50_000
_ONE: Powers = frozenset()


def expanded(expr: sp.Expr) -> sp.Expr:
    """All products, and powers with whole exponents, multiplied out."""
    return _out(expr) if _plain(expr) else _by_sympy(expr)


@lru_cache(maxsize=_KEPT)
def _by_sympy(expr: sp.Expr) -> sp.Expr:
    """What is not plain: the same equations are looked at for one unknown after the other."""
    return sp.expand(expr)


def wide(expr: sp.Expr) -> bool:
    """Would it come to so many terms that nobody would read them?"""
    above, below = _spread(expr)
    return above * below > WIDEST


@lru_cache(maxsize=_KEPT)
def _spread(expr: sp.Expr) -> tuple[int, int]:
    """At most how many terms there would be above the fraction stroke, and below it; of what stands in roots and
    functions, the most.
    """
    if not expr.args:
        return 1, 1
    parts = [_spread(a) for a in expr.args if isinstance(a, sp.Expr)]
    if expr.is_Add:
        return sum(above for above, _ in parts), max(below for _, below in parts)
    if expr.is_Mul:
        return prod(above for above, _ in parts), prod(below for _, below in parts)
    if expr.is_Pow and expr.exp.is_Rational and abs(expr.exp) >= 1:
        times = int(abs(expr.exp))
        above, below = (comb(n + times - 1, times) for n in parts[0])
        return (above, below) if expr.exp > 0 else (below, above)
    widest = max((above * below for above, below in parts), default=1)
    return (widest, 1) if widest > WIDEST else (1, 1)


@lru_cache(maxsize=_KEPT)
def _plain(expr: sp.Expr) -> bool:
    """Does it consist of sums, products, powers with numbers as exponents, and functions of angles or sizes?"""
    if expr.is_Symbol or expr.is_Rational or expr is sp.pi:
        return True
    if expr.is_Pow:
        return bool(expr.exp.is_Rational) and _plain(expr.base)
    known = TrigonometricFunction | InverseTrigonometricFunction | sp.atan2 | sp.Abs
    return bool(expr.is_Add or expr.is_Mul or isinstance(expr, known)) and all(_plain(a) for a in expr.args)


@lru_cache(maxsize=_KEPT)
def _out(expr: sp.Expr) -> sp.Expr:
    if not expr.args or expr.is_Rational:
        return expr
    if expr.is_Pow:
        return _power(_out(expr.base), expr.exp)
    parts = [_out(a) for a in expr.args]
    if expr.is_Add:
        return sp.Add(*parts)
    return _product(sp.Mul(*parts)) if expr.is_Mul else expr.func(*parts)


def _power(base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
    """The power of what is multiplied out already."""
    whole = base**exponent
    if base.is_Mul:
        whole = whole.expand(deep=False, power_base=True, mul=False, multinomial=False) if whole.is_Pow else whole
        return _product(whole)
    if not _left(whole):
        return whole
    if whole.exp < 0:
        return 1 / _power(base, -exponent)
    times = int(exponent)
    terms = _terms(base)
    found = terms
    for _ in range(times - 1):
        found = _times(found, terms)
    return _finished([_put(p, n, base ** (exponent - times)) for p, n in found.items()])


def _left(part: sp.Expr) -> bool:
    """Is it a power of a sum that can be multiplied out?"""
    return bool(part.is_Pow and part.base.is_Add and not -1 <= part.exp < 1)


def _product(whole: sp.Expr) -> sp.Expr:
    """A product whose factors are multiplied out already. A number stays before what is below the fraction stroke."""
    if not whole.is_Mul:
        return _power(whole.base, whole.exp) if _left(whole) else whole
    if not _unfinished(whole):
        return whole
    number, rest = whole.as_coeff_Mul(rational=True)
    above, below = (_multiplied(sp.Mul.make_args(part)) for part in sp.fraction(rest))
    under = 1 / _finished([_put(p, n, sp.S.One) for p, n in below.items()])
    return _finished([_put(p, n * number, under) for p, n in above.items()])


def _unfinished(term: sp.Expr) -> bool:
    """Is there something left to multiply out in a product?"""
    if not term.is_Mul:
        return _left(term)
    below = [f for f in term.args if f.is_Pow and f.exp.is_negative]
    return any(f.is_Add or _left(f) for f in term.args) or (
        len(below) > 1 and any(f.base.is_Add and f.exp == -1 for f in below)
    )


def _finished(terms: list[sp.Expr]) -> sp.Expr:
    """The sum of terms. Roots that have met their like are sums anew, to be multiplied out in their turn."""
    return sp.Add(*(_product(t) if _unfinished(t) else t for t in terms))


def _multiplied(factors: Iterable[sp.Expr]) -> Terms:
    """The product of sums."""
    found: Terms = {_ONE: sp.S.One}
    for factor in factors:
        found = _times(found, _terms(_power(factor.base, factor.exp) if _left(factor) else factor))
    return found


def _terms(expr: sp.Expr) -> Terms:
    """The terms of a sum."""
    found: Terms = {}
    for term in sp.Add.make_args(expr):
        number, powers = _term(term)
        found[powers] = found.get(powers, sp.S.Zero) + number
    return found


@lru_cache(maxsize=_KEPT)
def _term(term: sp.Expr) -> tuple[sp.Expr, Powers]:
    number, rest = term.as_coeff_Mul(rational=True)
    return number, frozenset(f.as_base_exp() for f in sp.Mul.make_args(rest) if f != 1)


def _times(one: Terms, other: Terms) -> Terms:
    found: Terms = {}
    if len(one) < len(other):
        one, other = other, one
    for a, m in one.items():
        for b, n in other.items():
            powers = _together(a, b)
            number = m * n
            found[powers] = found[powers] + number if powers in found else number
    return found


@lru_cache(maxsize=_KEPT)
def _together(one: Powers, other: Powers) -> Powers:
    if not one or not other:
        return one or other
    powers = dict(one)
    for base, exponent in other:
        total = powers.get(base, sp.S.Zero) + exponent
        if total:
            powers[base] = total
        else:
            del powers[base]
    return frozenset(powers.items())


def _put(powers: Powers, number: sp.Expr, by: sp.Expr) -> sp.Expr:
    """One term, times something."""
    return sp.Mul(number, *(base**exponent for base, exponent in powers), by) if number else sp.S.Zero
