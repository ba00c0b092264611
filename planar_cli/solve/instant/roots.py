"""All real roots of one equation in one unknown: polynomial, trigonometric, or anything that can be evaluated.

Polynomials (after clearing fractions, or after the half-angle substitution u = tan(x/2)) give all their roots, to fifty
digits; other equations are searched over a wide range for changes of sign. Letters without numbers allow closed forms
only.
"""

from __future__ import annotations

import math
from decimal import Decimal
from functools import lru_cache

import mpmath
import sympy as sp
from sympy.functions.elementary.hyperbolic import HyperbolicFunction
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.powers_of import powers_of
from planar_cli.equation.values.exact import DIGITS, PI, Valuation
from planar_cli.errors import NoValue, Undecided
from planar_cli.records import record
from planar_cli.solve.instant.scan import scanned

TINY = Decimal("1e-25")
CLEARLY = 1e-20
"""A determinant of rows of unit length that is larger than this is not zero."""
KEPT = 2_000
"""So many polynomials are remembered: what lies on several branches of a motion is solved on each."""
MOST_TURNS = 24
"""Sines of so many times an angle are written out in those of the angle."""
_SINE, _COSINE, _POWER = sp.Dummy("s"), sp.Dummy("c"), sp.Dummy("p")


@record
class Root:
    """A root: its closed form where there is one, and its value."""

    expression: sp.Expr | None
    value: Decimal


def real_roots(expr: sp.Expr, x: sp.Symbol, value: Valuation, symbolic: bool, angle: bool) -> list[Root]:
    """The real roots of expr = 0, sorted; an angle lies in (-180°, 180°]."""
    if (ends := _ends_of_a_way(expr, x)) is not None:
        return real_roots(ends, x, value, symbolic, angle)
    # An integrand stays as it is: put over one denominator, its value takes ten times as long.
    held = {i: sp.Dummy("i", real=True) for i in sorted(expr.atoms(sp.Integral), key=sp.default_sort_key)}
    numerator = sp.fraction(together(expr.xreplace(held)))[0].xreplace({d: i for i, d in held.items()})
    # A root vanishes with what is under it; on one side of there it is not real, so that no sign changes.
    numerator = sp.Mul(*(f.base if _is_root(f) and x in f.free_symbols else f for f in sp.Mul.make_args(numerator)))
    # Nobody would read a closed form of so many terms.
    closed = [] if wide(numerator) else _closed(numerator, x, value)
    if closed:
        found = [Root(e, v) for e in closed if (v := _real(e, value)) is not None]
        if found or symbolic:
            return _distinct(found, angle)
    if symbolic:
        raise Undecided(f"no closed form was found for {x.name.replace('__', '_')}")
    numbers = _with_numbers(numerator, x, value)
    if numbers.is_polynomial(x):
        return _distinct([Root(None, v) for v in _polynomial_roots(sp.Poly(numbers, x))], angle)
    half = _half_angle(numbers, x)
    if half is not None:
        return _distinct([Root(None, v) for v in half if _vanishes(numbers, x, v)], angle)
    return _distinct([Root(None, v) for v in scanned(expr, x, value, angle)], angle)


def _ends_of_a_way(expr: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """The difference of the limits, if the expression is an integral of what is never negative, as a time on the way:
    it vanishes only where they are the same.
    """
    number, integral = expr.as_independent(x, as_Add=False)
    if not isinstance(integral, sp.Integral) or [len(limit) for limit in integral.limits] != [3] or number == 0:
        return None
    factors = sp.Mul.make_args(integral.function)
    roots = (f.is_positive or (f.is_Pow and f.exp.is_Rational and f.exp.q == 2) for f in factors)
    return integral.limits[0][2] - integral.limits[0][1] if all(roots) else None


def _is_root(factor: sp.Expr) -> bool:
    return bool(factor.is_Pow and factor.exp.is_Rational and 0 < factor.exp < 1)


def linear_or_square_roots(expr: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """Short closed roots in x: where x enters linearly, or only as its square."""
    numerator = expanded(expr)
    if not numerator.is_polynomial(x):
        return []
    by = {m[0]: c for m, c in sp.Poly(numerator, x).terms()}
    if set(by) == {0, 1}:
        return [cancelled(-by[0] / by[1])]
    if set(by) == {0, 2}:
        return [sp.sqrt(cancelled(-by[0] / by[2]))]
    return []


def _real(e: sp.Expr, value: Valuation) -> Decimal | None:
    """The value, None where it is not real or not finite."""
    try:
        found = value(e)
    except NoValue:
        return None
    return found if found.is_finite() else None


def _distinct(roots: list[Root], angle: bool) -> list[Root]:
    found: list[Root] = []
    for root in sorted(roots, key=lambda r: r.value):
        v = root.value
        if angle:
            while v > PI + TINY:
                v -= 2 * PI
            while v <= -PI + TINY:
                v += 2 * PI
        if not any(abs(v - o.value) <= TINY * max(abs(v), Decimal(1)) for o in found):
            found.append(Root(root.expression, v))
    return sorted(found, key=lambda r: r.value)


def _closed(numerator: sp.Expr, x: sp.Symbol, value: Valuation) -> list[sp.Expr]:
    """Closed forms: linear, quadratic, the same in a power of x, or A cos x + B sin x = C."""
    if numerator.is_polynomial(x):
        terms = [(m, c) for m, c in powers_of(numerator, x) if c.is_number or not value.vanishes(c)]
        if not terms:
            return []
        low = min(m for m, _ in terms)
        zero = [sp.S.Zero] if low > 0 else []
        terms = [(m - low, c) for m, c in terms]
        degree = max(m for m, _ in terms)
        by = dict(terms)
        if degree == 0:
            return zero
        if degree == 1:
            return [*zero, -by[0] / by[1]]
        if set(by) == {0, 2}:
            root = sp.sqrt(cancelled(-by[0] / by[2]))
            return [*zero, root, -root]
        if degree == 2:
            a, b, c = by[2], by.get(1, sp.S.Zero), by.get(0, sp.S.Zero)
            root = sp.sqrt(b**2 - 4 * a * c)
            return [*zero, (-b + root) / (2 * a), (-b - root) / (2 * a)]
        step = math.gcd(*by)
        power = sp.Add(*(c * _POWER ** (m // step) for m, c in terms)) if step > 1 else sp.S.Zero
        return [*zero, *(r for base in _closed(power, _POWER, value) for r in _of_power(base, step, value))]
    flat = _in_sine_and_cosine(numerator, x)
    if flat.has(x):
        return _of_one_angle(numerator, x, value)
    if not flat.is_polynomial(_SINE, _COSINE):
        return []
    poly = sp.Poly(flat, _SINE, _COSINE)
    if poly.total_degree() != 1:
        return _by_factors(numerator, x, value) or _of_one_angle(numerator, x, value) or _of_one_function(flat, value)
    a, b, k = poly.coeff_monomial(_COSINE), poly.coeff_monomial(_SINE), poly.coeff_monomial(1)
    if k == 0:
        base = sp.atan(cancelled(-a / b)) if b != 0 else sp.pi / 2
        return [base, base + sp.pi]
    if a == 0:
        first = sp.asin(cancelled(-k / b))
        return [first, sp.pi - first]
    if b == 0:
        first = sp.acos(cancelled(-k / a))
        return [first, -first]
    lead, swing = sp.atan2(b, a), sp.acos(-k / sp.sqrt(a**2 + b**2))
    return [lead + swing, lead - swing]


def _of_power(base: sp.Expr, degree: int, value: Valuation) -> list[sp.Expr]:
    """The real x whose power of that degree is `base`."""
    size = _real(base, value)
    if size is None or (degree % 2 == 0 and size < 0):
        return []
    root = sp.root(-base, degree) if size < 0 else sp.root(base, degree)
    return [root, -root] if degree % 2 == 0 else [-root if size < 0 else root]


@lru_cache(maxsize=KEPT)
def _in_sine_and_cosine(expr: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """An expression in letters for the sine and the cosine of an angle."""
    return _opened(expr).subs({sp.sin(x): _SINE, sp.cos(x): _COSINE})


def _opened(expr: sp.Expr) -> sp.Expr:
    """Functions of sums and multiples of angles by those of single ones. Of a thousand times an angle this would be a
    polynomial of that degree: it stays as it is.
    """
    functions = expr.atoms(TrigonometricFunction, HyperbolicFunction)
    often = [f for f in functions if any(_is_many(a.as_coeff_Mul()[0]) for a in sp.Add.make_args(f.args[0]))]
    held = {f: sp.Dummy("f", real=True) for f in sorted(often, key=sp.default_sort_key)}
    return sp.expand_trig(expr.xreplace(held)).xreplace({d: f for f, d in held.items()})


def _is_many(times: sp.Expr) -> bool:
    return bool(times.is_Integer and abs(times) > MOST_TURNS)


def _of_one_angle(numerator: sp.Expr, x: sp.Symbol, value: Valuation) -> list[sp.Expr]:
    """Roots where x stands in one angle k x + b only, as that of a wheel that has rolled on a round track does."""
    angles = turning(numerator, x)
    if len(angles) != 1 or x in angles:
        return []
    ((angle, pace),) = angles.items()
    whole = sp.Dummy("w", real=True)
    inside = {f: f.func(whole) for f in numerator.atoms(sp.sin, sp.cos, sp.tan) if f.args[0] == angle}
    flat = numerator.xreplace(inside)
    if x in flat.free_symbols:
        return []
    start = angle.xreplace({x: sp.S.Zero})
    # A quick angle comes round several times while x goes round once.
    turns = range(math.ceil(abs(pace)) if pace.is_number else 1)
    return [cancelled((root + 2 * sp.pi * k - start) / pace) for root in _closed(flat, whole, value) for k in turns]


def turning(expr: sp.Expr, x: sp.Symbol) -> dict[sp.Expr, sp.Expr]:
    """The angles of sines, cosines and tangents that grow evenly with x, each with its rate; empty if others hold x."""
    angles = {f.args[0] for f in expr.atoms(sp.sin, sp.cos, sp.tan) if x in f.args[0].free_symbols}
    paces = {a: sp.diff(a, x) for a in angles}
    return {} if any(x in pace.free_symbols for pace in paces.values()) else paces


def _by_factors(numerator: sp.Expr, x: sp.Symbol, value: Valuation) -> list[sp.Expr]:
    """The roots of every factor, sin x and cos x of sin x cos x; nothing unless all are closed."""
    factors = [f.base if f.is_Pow and f.exp.is_positive else f for f in sp.Mul.make_args(factored(numerator))]
    factors = [f for f in factors if x in f.free_symbols]
    if len(factors) < 2 and numerator in factors:
        return []
    found = [_closed(f, x, value) for f in factors]
    return [root for roots in found for root in roots] if all(found) else []


def _of_one_function(flat: sp.Expr, value: Valuation) -> list[sp.Expr]:
    """Roots where the sine alone is left, or the cosine, once the squares of the other one are put in by it."""
    for one, other in ((_SINE, _COSINE), (_COSINE, _SINE)):
        powers = dict(powers_of(flat, other))
        if any(n % 2 for n in powers):
            continue
        inside = expanded(sp.Add(*(c * (1 - one**2) ** (n // 2) for n, c in powers.items())))
        first = [(sp.asin if one == _SINE else sp.acos)(root) for root in _closed(inside, one, value)]
        return [e for f in first for e in ((f, sp.pi - f) if one == _SINE else (f, -f))]
    return []


def _with_numbers(expr: sp.Expr, x: sp.Symbol, value: Valuation) -> sp.Expr:
    inside = {}
    for symbol in expr.free_symbols - {x}:
        inside[symbol] = sp.Rational(str(value(symbol)))
    return expr.xreplace(inside)


def _polynomial_roots(poly: sp.Poly) -> list[Decimal]:
    if poly.domain.is_Exact and poly.degree() > 0 and not (poly.domain.is_EX and _has_simple_roots(poly)):
        # Near a root that is there twice the iteration does not settle.
        poly = poly.sqf_part()
    with mpmath.workdps(DIGITS + 10):
        numbers = [sp.N(c, DIGITS + 5) for c in poly.all_coeffs()]
        if any(not n.is_real for n in numbers):
            return []
        coefficients = [mpmath.mpf(str(n)) for n in numbers]
        while coefficients and not coefficients[0]:
            coefficients = coefficients[1:]
        if len(coefficients) < 2:
            return []
        roots = mpmath.polyroots(coefficients, maxsteps=400, extraprec=400)
        size = max([abs(r) for r in roots] + [mpmath.mpf(1e-30)])
        real = [r.real for r in roots if abs(mpmath.im(r)) < mpmath.mpf("1e-22") * size]
        return [Decimal(mpmath.nstr(mpmath.re(r), DIGITS)) for r in real]


def _has_simple_roots(poly: sp.Poly) -> bool:
    """Have a polynomial and its derivative clearly no root in common, by the determinant of their coefficients?

    Where these are sines and the like, the exact answer takes longer than all else.
    """
    n = poly.degree()
    with mpmath.workdps(DIGITS):
        rows = []
        for one, times in ((poly, n - 1), (poly.diff(), n)):
            numbers = [mpmath.mpmathify(sp.N(c, DIGITS)) for c in one.all_coeffs()]
            length = mpmath.sqrt(sum(abs(c) ** 2 for c in numbers))
            rows += [[0] * i + [c / length for c in numbers] + [0] * (times - 1 - i) for i in range(times)]
        return bool(abs(mpmath.det(mpmath.matrix(rows))) > CLEARLY)


def _half_angle(numbers: sp.Expr, x: sp.Symbol) -> list[Decimal] | None:
    """Roots of an equation in sin x and cos x by u = tan(x/2)."""
    s, c, u = sp.Dummy("s"), sp.Dummy("c"), sp.Dummy("u")
    if numbers.has(sp.tan):
        numbers = numbers.rewrite(sp.cos).subs(sp.tan(x), sp.sin(x) / sp.cos(x))
    flat = _opened(numbers)
    flat = sp.fraction(together(flat.subs({sp.sin(x): s, sp.cos(x): c})))[0]
    if flat.has(x) or not flat.is_polynomial(s, c):
        return None
    rational = sp.fraction(together(flat.subs({s: 2 * u / (1 + u**2), c: (1 - u**2) / (1 + u**2)})))[0]
    poly = sp.Poly(rational, u)
    with mpmath.workdps(DIGITS + 5):
        found = [Decimal(mpmath.nstr(2 * mpmath.atan(mpmath.mpf(str(r))), DIGITS)) for r in _polynomial_roots(poly)]
    return [*found, +PI]


def _vanishes(numbers: sp.Expr, x: sp.Symbol, v: Decimal) -> bool:
    value = Valuation({x: v})
    number = value.known(numbers)
    return number is not None and abs(number) <= Decimal("1e-18") * max(value.size(numbers), Decimal("1e-30"))
