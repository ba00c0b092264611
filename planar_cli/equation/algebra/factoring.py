"""Factors of an expression, as SymPy's `factor` finds them, where one look decides: at a part of its price.

SymPy factors polynomials of many letters by evaluating, factoring modulo a prime and lifting (Wang 1978), whose steps
are many however simple the polynomial is; on one of a hundred terms it may not come back. Numerators of mechanics are
nearly all of first or second degree in some letter (a force, an acceleration, the square of a speed), and for these
there is nothing to search (Gauss: a factor free of the letter divides all its coefficients):

- a polynomial a x + b without a common factor of a and b is irreducible;
- a x² + b x + c without one is irreducible unless b² - 4 a c is a square, which it is not if it is none at one place.

So the greatest common divisors are taken out, letter by letter. What is left is given to SymPy where it is short.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from math import gcd, isqrt, prod

import sympy as sp
from sympy.core.mul import _keep_coeff
from sympy.polys.rings import PolyRing

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded

Monomial = tuple[int, ...]
Terms = dict[Monomial, int]
"""A polynomial with whole coefficients: exponents of its letters -> coefficient."""
_LONGEST, _HIGHEST = 60, 12
"""A polynomial of more terms, or of a higher degree, that none of its letters decides is left as it is."""
_PLACES = ((2, 3, 5, 7, 11, 13, 17, 19), (3, 10, 4, 1, 9, 8, 6, 5), (29, 7, 12, 31, 5, 2, 21, 18))
"""Whole numbers put in for the letters, over and over, where a discriminant is looked at."""
_KEPT = 20_000


@lru_cache(maxsize=_KEPT)
def factored(expr: sp.Expr) -> sp.Expr:
    """One fraction of products of irreducible factors over the rational numbers."""
    number, factors = sp.S.One, dict[sp.Expr, sp.Expr]()
    for base, power in _parts(together(expr)):
        if base.is_Number and power.is_Integer:
            number *= base**power
            continue
        for factor, times in _of_power(base, power):
            factors[factor] = factors.get(factor, sp.S.Zero) + times
    for factor in [f for f, k in factors.items() if f.is_Number and k.is_Integer]:
        number *= factor ** factors.pop(factor)
    return _keep_coeff(number, sp.Mul(*(f**k for f, k in factors.items())))


def _parts(whole: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The powers whose product an expression is."""
    for part in sp.Mul.make_args(whole):
        yield (part.base, part.exp) if part.is_Pow and part.base != sp.E else (part, sp.S.One)


def _of_power(base: sp.Expr, power: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The factors of a power. Under a root only what is surely positive comes out of it."""
    number, found = _factors(base)
    if power.is_integer:
        if number != 1:
            yield number, power
        yield from ((f, k * power) for f, k in found)
        return
    inside = [(f, k) for f, k in found if not f.is_positive]
    yield from ((f, k * power) for f, k in found if f.is_positive)
    if number.is_positive:
        yield number, power
    else:
        inside.append((number, sp.S.One))
    kept = sp.Mul(*(f**k for f, k in inside))
    if kept != 1:
        yield kept, power


@lru_cache(maxsize=_KEPT)
def _factors(base: sp.Expr) -> tuple[sp.Expr, tuple[tuple[sp.Expr, sp.Expr], ...]]:
    """A number, and the irreducible factors of a sum with how often each is one."""
    if not base.is_Add:
        return sp.S.One, ((base, sp.S.One),)
    flat = expanded(base)
    if flat.is_Number:
        return flat, ()
    if not flat.free_symbols and flat.is_algebraic:
        return sp.S.One, ((flat, sp.S.One),)
    poly = sp.Poly(flat, expand=False)
    if not (poly.domain.is_ZZ or poly.domain.is_QQ):
        number, found = poly.factor_list()
        return number, tuple((f.as_expr(), sp.Integer(k)) for f, k in found)
    below, whole = poly.clear_denoms(convert=True)
    terms = {m: int(c) for m, c in whole.rep.to_dict().items()}
    content, powers, rest = _primitive(terms)
    gens = poly.gens
    factors = [(gens[i], sp.Integer(n)) for i, n in enumerate(powers) if n]
    # Of each factor the first term is positive: the sign is that of the whole's first term.
    content *= 1 if rest[max(rest)] > 0 else -1
    if len(rest) > 1:
        factors += [(_expression(f, gens), sp.Integer(times)) for f, times in _irreducible(rest, gens)]
    return sp.Rational(content, below), tuple(factors)


def _expression(terms: Terms, gens: tuple[sp.Expr, ...]) -> sp.Expr:
    """A polynomial as a sum, with its first term positive."""
    sign = 1 if terms[max(terms)] > 0 else -1
    return sp.Add(*(sp.Mul(sign * c, *(g**n for g, n in zip(gens, m, strict=True) if n)) for m, c in terms.items()))


# --- irreducible factors ----------------------------------------------------------------------------------------------


def _primitive(terms: Terms) -> tuple[int, Monomial, Terms]:
    """The number and the powers of letters that all terms have, and what is left of them."""
    content = gcd(*terms.values())
    powers = tuple(map(min, *terms)) if len(terms) > 1 else next(iter(terms))
    left = {tuple(n - p for n, p in zip(m, powers, strict=True)): c // content for m, c in terms.items()}
    return content, powers, left


def _irreducible(terms: Terms, gens: tuple[sp.Expr, ...]) -> Iterator[tuple[Terms, int]]:
    """The irreducible factors of a primitive polynomial that no letter divides, up to their signs."""
    degrees = list(map(max, *terms)) if len(terms) > 1 else list(next(iter(terms)))
    low = [i for i, n in enumerate(degrees) if n == 1] + [i for i, n in enumerate(degrees) if n == 2]
    # A letter with a coefficient of one term decides at once.
    best = min(low, key=lambda i: (degrees[i], min(len(c) for c in _coefficients(terms, i).values())), default=None)
    if best is None:
        yield from _searched(terms, gens)
        return
    by_power = _coefficients(terms, best)
    common = _common(list(by_power.values()))
    if any(any(m) for m in common):
        yield from _irreducible(common, gens)
        terms = _divided(terms, common)
        by_power = _coefficients(terms, best)
    if degrees[best] == 1 or not _square(by_power):
        yield terms, 1
    else:
        yield from _searched(terms, gens)


def _searched(terms: Terms, gens: tuple[sp.Expr, ...]) -> Iterator[tuple[Terms, int]]:
    """What SymPy finds."""
    if len(terms) > _LONGEST or max(max(m) for m in terms) > _HIGHEST:
        yield terms, 1
        return
    for factor, times in sp.Poly.from_dict(terms, *gens, domain=sp.ZZ).factor_list()[1]:
        yield {m: int(c) for m, c in factor.rep.to_dict().items()}, times


def _coefficients(terms: Terms, letter: int) -> dict[int, Terms]:
    """The coefficients of the powers of a letter, in which it stands with power 0."""
    found: dict[int, Terms] = {}
    for m, c in terms.items():
        found.setdefault(m[letter], {})[(*m[:letter], 0, *m[letter + 1 :])] = c
    return found


def _square(by_power: Mapping[int, Terms]) -> bool:
    """May the discriminant of a quadratic be a square?"""
    for place in _PLACES:
        a, b, c = (_at(by_power.get(n, {}), place) for n in (2, 1, 0))
        value = b * b - 4 * a * c
        if value < 0 or isqrt(value) ** 2 != value:
            return False
    return True


def _at(terms: Terms, place: tuple[int, ...]) -> int:
    total = 0
    for m, c in terms.items():
        total += c * prod((place[i % len(place)] + i // len(place)) ** n for i, n in enumerate(m) if n)
    return total


def _common(polys: list[Terms]) -> Terms:
    """The greatest common divisor of polynomials, without its number: what is free of a letter that one of them lacks
    divides each of its coefficients in the others.
    """
    while True:
        polys = list({frozenset(p.items()): p for p in map(_with_sign, polys)}.values())
        smallest = min(polys, key=len)
        if len(smallest) == 1 or len(polys) == 1:
            break
        letters = [{i for m in p for i, n in enumerate(m) if n} for p in polys]
        shared = set.intersection(*letters)
        if all(own == shared for own in letters):
            return _divisor(polys)
        polys = [part for p, own in zip(polys, letters, strict=True) for part in _apart(p, own - shared)]
    if len(polys) == 1:
        return smallest
    monomials = [m for p in polys for m in p]
    return {tuple(map(min, *monomials)): 1}


def _with_sign(terms: Terms) -> Terms:
    """Without its number, and with its first term positive: so equal ones are found."""
    content = gcd(*terms.values()) * (1 if terms[max(terms)] > 0 else -1)
    return {m: c // content for m, c in terms.items()}


def _apart(terms: Terms, letters: Iterable[int]) -> list[Terms]:
    """The coefficients of all products of powers of some letters."""
    moving = tuple(letters)
    if not moving:
        return [terms]
    found: dict[Monomial, Terms] = {}
    for m, c in terms.items():
        key = tuple(m[i] for i in moving)
        found.setdefault(key, {})[tuple(0 if i in moving else n for i, n in enumerate(m))] = c
    return list(found.values())


@lru_cache(maxsize=64)
def _ring(size: int) -> PolyRing:
    return PolyRing([f"x{i}" for i in range(size)], sp.ZZ)


def _divisor(polys: list[Terms]) -> Terms:
    """The greatest common divisor of polynomials of the same letters."""
    ring = _ring(len(next(iter(polys[0]))))
    first, *others = sorted((ring.from_dict(p) for p in polys), key=len)
    for other in others:
        first = first.gcd(other)
        if first.is_ground:
            break
    return {m: int(c) for m, c in first.items()}


def _divided(terms: Terms, by: Terms) -> Terms:
    ring = _ring(len(next(iter(terms))))
    return {m: int(c) for m, c in ring.from_dict(terms).exquo(ring.from_dict(by)).items()}
