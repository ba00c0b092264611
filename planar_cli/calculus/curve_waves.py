"""Paths in sines and cosines of one angle u: circle, ellipse, cycloid, Lissajous figures.

Everything is brought to c = cos u, s = sin u with s² = 1 - c²; cos n u and sin n u are polynomials of them (Chebyshev).
"""

from __future__ import annotations

from dataclasses import replace
from math import gcd
from typing import Any

import sympy as sp

from planar_cli.calculus.curve_conics import (
    Plane,
    axes_parallel,
    conic,
    of_polynomial,
    polynomial_equation,
)
from planar_cli.calculus.curve_plain import hidden, plainer
from planar_cli.calculus.curve_words import CURVE, ELLIPSE, PARABOLA, Curve, Step
from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import factor_terms, together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import MANY, longer
from planar_cli.records import record

C, S = sp.Dummy("c"), sp.Dummy("s")
HIGHEST = 8
"""Beyond this multiple of the angle nothing is eliminated."""
LETTERS, TERMS = 6, 32
"""With more letters, or more terms in both equations together, a resultant is not formed."""
SQUARED = "squared and added, since cos² + sin² = 1"


@record
class Waves:
    """A path in c = cos u and s = sin u; `x`, `y` may still hold the parameter beside them."""

    x: sp.Expr
    y: sp.Expr
    angle: sp.Expr

    def back(self, expr: Any) -> Any:
        """An expression with cos u and sin u written out."""
        return expr.xreplace({C: sp.cos(self.angle), S: sp.sin(self.angle)})


def without_tan(expr: sp.Expr, p: sp.Symbol) -> sp.Expr:
    """Tangents and their like of the parameter as quotients of sine and cosine."""
    like = [f for f in expr.atoms(sp.tan, sp.cot, sp.sec, sp.csc) if f.has(p)]
    return expr.xreplace({f: f.rewrite(sp.cos) if isinstance(f, sp.sec) else _quotient(f) for f in like})


def _quotient(f: sp.Expr) -> sp.Expr:
    sine, cosine = sp.sin(f.args[0]), sp.cos(f.args[0])
    return sine / cosine if isinstance(f, sp.tan) else cosine / sine if isinstance(f, sp.cot) else 1 / sine


def waves_of(x: sp.Expr, y: sp.Expr, p: sp.Symbol) -> Waves | None:
    """The path in cos u and sin u; None where there is no such angle u."""
    x, y = without_tan(x, p), without_tan(y, p)
    found = [f for f in (x.atoms(sp.sin, sp.cos) | y.atoms(sp.sin, sp.cos)) if f.has(p)]
    # What stands inside another sine or cosine is part of its angle: cos(π/2 + sin t).
    found = [f for f in found if not any(f != g and g.args[0].has(f) for g in found)]
    arguments = sorted({f.args[0] for f in found}, key=lambda a: (sp.count_ops(a), str(a)))
    base = _base(arguments, p)
    if base is None:
        return None
    angle, multiples = base
    into = {}
    for f in found:
        n, shift = multiples[f.args[0]]
        cosine, sine = sp.chebyshevt(abs(n), C), sp.sign(n) * S * (sp.chebyshevu(abs(n) - 1, C) if n else 0)
        if isinstance(f, sp.cos):
            into[f] = cosine * sp.cos(shift) - sine * sp.sin(shift)
        else:
            into[f] = sine * sp.cos(shift) + cosine * sp.sin(shift)
    return Waves(reduced(x.xreplace(into)), reduced(y.xreplace(into)), angle)


def _base(arguments: list[sp.Expr], p: sp.Symbol) -> tuple[sp.Expr, dict[sp.Expr, tuple[int, sp.Expr]]] | None:
    """The angle u of which all arguments are whole multiples, up to constants; and those multiples and constants."""
    if not arguments:
        return None
    parts = {a: expanded(a).as_independent(p, as_Add=True) for a in arguments}
    first = parts[arguments[0]][1]
    ratios = {a: cancelled(moving / first) for a, (_, moving) in parts.items()}
    if not all(r.is_Rational for r in ratios.values()):
        return None
    shared = sp.gcd_list(list(ratios.values()))
    whole = {a: int(r / shared) for a, r in ratios.items()}
    if max(abs(n) for n in whole.values()) > HIGHEST:
        return None
    single = next((a for a in arguments if whole[a] == 1), None)
    phase = parts[single][0] if single is not None else sp.S.Zero
    angle = single if single is not None else expanded(first * shared)
    return angle, {a: (n, expanded(parts[a][0] - n * phase)) for a, n in whole.items()}


def reduced(expr: sp.Expr) -> sp.Expr:
    """Higher powers of s taken away by s² = 1 - c², also in roots and denominators."""
    if not expr.has(S, C):
        return expr
    if expr.is_polynomial(S, C):
        return _lowered(expr, S, C)
    roots = {q: _root(q) for q in expr.atoms(sp.Pow) if q.exp.is_Rational and not q.exp.is_Integer and q.has(S, C)}
    return expr.xreplace(roots)


def _root(power: sp.Pow) -> sp.Expr:
    inside = power.base
    if not inside.is_polynomial(S, C):
        return power
    forms = [_lowered(inside, S, C), _lowered(inside, C, S)]
    return min(forms, key=sp.count_ops) ** power.exp


def _lowered(expr: sp.Expr, high: sp.Symbol, other: sp.Symbol) -> sp.Expr:
    """A polynomial with `high` of at most first degree; untouched if it is so already."""
    poly = sp.Poly(expr, high)
    if poly.degree() < 2:
        return expr
    return expanded(sum(c * (1 - other**2) ** (k // 2) * high ** (k % 2) for (k,), c in poly.terms()))


def halved(waves: Waves, trial: Any) -> Waves:
    """The same path with the largest possible u: cos² u as (1 + cos 2u)/2, if only even multiples occur."""
    tones = [_tones(e, trial) for e in (waves.x, waves.y)]
    if tones[0] is None or tones[1] is None:
        return waves
    present = {n for tone in tones for n in (tone or {}) if n}
    step = gcd(*present) if present else 1
    if step < 2:
        return waves
    x, y = (
        sum(
            (
                a * sp.chebyshevt(n // step, C) + (b * S * sp.chebyshevu(n // step - 1, C) if n else 0)
                for n, (a, b) in t.items()
            ),
            sp.S.Zero,
        )
        for t in tones
        if t is not None
    )
    return Waves(reduced(sp.sympify(x)), reduced(sp.sympify(y)), expanded(step * waves.angle))


def _tones(expr: sp.Expr, trial: Any) -> dict[int, tuple[sp.Expr, sp.Expr]] | None:
    """Coefficients of cos n u and sin n u, by n, of a polynomial in c and s."""
    if not expr.is_polynomial(C, S) or expr.has(trial.parameter):
        return None
    z = sp.Dummy("z")
    poly = sp.Poly(expr, C, S)
    top = poly.total_degree()
    if top > HIGHEST:
        return None
    whole = expanded(z**top * poly.as_expr().xreplace({C: (z + 1 / z) / 2, S: (z - 1 / z) / (2 * sp.I)}))
    by = {m[0] - top: c for m, c in sp.Poly(whole, z).terms()}
    tones = {}
    for n in range(top + 1):
        plus, minus = by.get(n, sp.S.Zero), by.get(-n, sp.S.Zero)
        pair = (plus, sp.S.Zero) if n == 0 else (expanded(plus + minus), expanded(sp.I * (plus - minus)))
        if not all(trial.zero(e) for e in pair):
            tones[n] = pair
    return tones


def linear(expr: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """(k, a, b) of k + a c + b s, where it is linear in c and s."""
    whole = expanded(expr)
    if not whole.is_polynomial(C, S):
        return None
    poly = sp.Poly(whole, C, S)
    if poly.total_degree() > 1:
        return None
    return poly.coeff_monomial(1), poly.coeff_monomial(C), poly.coeff_monomial(S)


def ellipse(plane: Plane, waves: Waves) -> Curve | None:
    """Both coordinates linear in cos u and sin u: solved for them, squared and added."""
    one, two = linear(waves.x), linear(waves.y)
    p = plane.trial.parameter
    if one is None or two is None or any(e.has(p) for e in (*one, *two)):
        return None
    (k, a, b), (m, c, d) = one, two
    middle = plainer(k), plainer(m)
    right = waves.back(expanded(a * C + b * S)), waves.back(expanded(c * C + d * S))
    steps: list[Step] = [("", _equal(plane.x - middle[0], right[0])), ("", _equal(plane.y - middle[1], right[1]))]
    p2, q2, mixed = plainer(a**2 + b**2), plainer(c**2 + d**2), plainer(a * c + b * d)
    if plane.trial.zero(mixed):
        found = axes_parallel(plane, middle, p2, q2)
        if not (plane.trial.zero(b) and plane.trial.zero(c)) and not (plane.trial.zero(a) and plane.trial.zero(d)):
            steps += _solved(plane, waves, (k, a, b), (m, c, d)) if found.kind == ELLIPSE else []
    else:
        steps += _solved(plane, waves, (k, a, b), (m, c, d))
        area = plainer((a * d - b * c) ** 2)
        terms = {(2, 0): q2, (1, 1): -2 * mixed, (0, 2): p2, (0, 0): -area}
        found = Curve(ELLIPSE, polynomial_equation(plane, terms, middle), centre=middle)
    return replace(found, steps=(*steps, (SQUARED, found.equation)))


def _equal(left: Any, right: Any) -> sp.Eq:
    return sp.Eq(left, right, evaluate=False)


def _solved(plane: Plane, waves: Waves, one: tuple[sp.Expr, ...], two: tuple[sp.Expr, ...]) -> list[Step]:
    """cos u and sin u from the two coordinates (Cramer)."""
    (k, a, b), (m, c, d) = one, two
    area, x, y = plainer(a * d - b * c), plane.x - k, plane.y - m
    cosine, sine = plainer((d * x - b * y) / area), plainer((a * y - c * x) / area)
    return [("", _equal(sp.cos(waves.angle), cosine)), ("", _equal(sp.sin(waves.angle), sine))]


def rational(plane: Plane, waves: Waves) -> Curve | None:
    """Quotients linear in cos u and sin u, as in r = l/(1 + e cos u): solved for both, squared and added."""
    rows = []
    for axis, expr in ((plane.x, waves.x), (plane.y, waves.y)):
        above, below = sp.fraction(together(expr))
        row = linear(axis * below - above) if below.has(C, S) or above.has(C, S) else None
        if row is None or any(e.has(plane.trial.parameter) for e in row):
            return None
        rows.append(row)
    (k, a, b), (m, c, d) = rows
    area = expanded(a * d - b * c)
    if plane.trial.zero(area.xreplace({plane.x: sp.Rational(3, 7), plane.y: sp.Rational(5, 11)})):
        return None
    cosine, sine = plainer((b * m - d * k) / area), plainer((c * k - a * m) / area)
    found = of_polynomial(plane, cosine**2 + sine**2 - 1)
    if found is None:
        return None
    steps = (("", _equal(sp.cos(waves.angle), cosine)), ("", _equal(sp.sin(waves.angle), sine)))
    return replace(found, steps=(*steps, (SQUARED, found.equation)))


def one_wave(plane: Plane, waves: Waves) -> Curve | None:
    """One coordinate gives cos u (or sin u) at once, the other needs only that: y = f(cos u)."""
    axes = (plane.x, waves.x, plane.y, waves.y), (plane.y, waves.y, plane.x, waves.x)
    for known, first, other, second in axes:
        row = linear(first)
        if row is None or any(e.has(plane.trial.parameter) for e in row):
            continue
        k, a, b = row
        for wave, third, size, none in ((C, S, a, b), (S, C, b, a)):
            if size == 0 or none != 0:
                continue
            word = sp.cos(waves.angle) if wave is C else sp.sin(waves.angle)
            value = plainer((known - k) / size)
            steps: tuple[Step, ...] = ((f"from {known}", _equal(word, value)),)
            clean = _lowered(second, third, wave) if second.is_polynomial(C, S) else second
            if not clean.has(third):
                return _put_in(plane, waves, (known, other, clean, wave, value), steps)
            return _squared(plane, waves, (other, clean, wave, third, value), steps)
    return None


def _put_in(plane: Plane, waves: Waves, what: tuple[Any, ...], steps: tuple[Step, ...]) -> Curve | None:
    known, other, clean, wave, value = what
    if clean.has(plane.trial.parameter):
        return None
    written = waves.back(clean)
    if written != (plane.path[1] if other == plane.y else plane.path[0]):
        steps += (("", _equal(other, written)),)
    right = expanded(clean.xreplace({wave: value}))
    if right.is_polynomial(known):
        right = sp.Add(*(plainer(c) * known**n for (n,), c in sp.Poly(right, known).terms()))
    kind = PARABOLA if right.is_polynomial(known) and sp.degree(right, known) == 2 else CURVE
    equation = _equal(other, right)
    named = conic(plane, other - right) if kind == CURVE and right.is_polynomial(known) else None
    found = named or Curve(kind, equation)
    return replace(found, steps=(*steps, ("", found.equation)))


def _squared(plane: Plane, waves: Waves, what: tuple[Any, ...], steps: tuple[Step, ...]) -> Curve | None:
    """The other coordinate f + g·(the other wave), f and g known by now: squared with cos² + sin² = 1."""
    other, clean, wave, third, value = what
    whole = expanded(clean) if clean.is_polynomial(C, S) else clean
    if not whole.is_polynomial(third) or sp.degree(whole, third) != 1 or whole.has(plane.trial.parameter):
        return None
    poly = sp.Poly(whole, third)
    f, g = (poly.coeff_monomial(m).xreplace({wave: value}) for m in (1, third))
    right = g**2 * (1 - value**2)
    square = _equal((other - f) ** 2, min((_product(g**2, 1 - value**2), expanded(right)), key=sp.count_ops))
    word = sp.sin(waves.angle) if third is S else sp.cos(waves.angle)
    steps += (("", _equal(word, (other - f) / g)),)
    found = None
    if not longer(square.lhs, MANY) and (square.lhs - square.rhs).is_rational_function(plane.x, plane.y):
        found = of_polynomial(plane, expanded(square.lhs - square.rhs))
    found = found if found is not None and found.kind != CURVE else Curve(CURVE, square)
    return replace(found, steps=(*steps, (SQUARED, found.equation)))


def _product(one: sp.Expr, two: sp.Expr) -> sp.Expr:
    """A product with each factor over its own denominator; no third factor from a difference of squares."""
    (above, below), (more, under) = (sp.fraction(together(e)) for e in (one, two))
    return factor_terms(above / (below * under)) * more


def resultant(plane: Plane, waves: Waves) -> Curve | None:
    """Both coordinates polynomials in cos u and sin u: c and s eliminated by resultants."""
    polys = []
    for e in (waves.x, waves.y):
        if not e.is_polynomial(C, S) or e.has(plane.trial.parameter) or longer(e, MANY):
            return None
        polys.append(sp.Poly(expanded(e), S))
    (p1, q1), (p2, q2) = ((p.coeff_monomial(1), p.coeff_monomial(S)) for p in polys)
    if q1 == 0 and q2 == 0:
        one, two = plane.x - p1, plane.y - p2
    elif q1 == 0:
        one, two = plane.x - p1, (plane.y - p2) ** 2 - (1 - C**2) * q2**2
    elif q2 == 0:
        one, two = plane.y - p2, (plane.x - p1) ** 2 - (1 - C**2) * q1**2
    else:
        one = (plane.x - p1) ** 2 - (1 - C**2) * q1**2
        two = (plane.y - p2) * q1 - (plane.x - p1) * q2
    found = eliminated(plane, one, two, C)
    if found is None:
        return None
    first: tuple[Step, ...] = tuple(
        ("", _equal(axis, waves.back(e))) for axis, e in ((plane.x, waves.x), (plane.y, waves.y))
    )
    return replace(found, steps=(*first, ("cos and sin eliminated by cos² + sin² = 1", found.equation)))


def eliminated(plane: Plane, one: sp.Expr, two: sp.Expr, unknown: sp.Symbol) -> Curve | None:
    """The resultant of two polynomials in one unknown, where it is not too large."""
    one, two = expanded(one), expanded(two)
    if not (one.is_polynomial(unknown) and two.is_polynomial(unknown)):
        return None
    degrees = sp.degree(one, unknown), sp.degree(two, unknown)
    flat, shown = hidden([one, two])
    letters = (flat[0].free_symbols | flat[1].free_symbols) - {unknown, plane.x, plane.y}
    if len(letters) > LETTERS or sum(len(e.args) for e in flat) > TERMS:
        return None
    if min(degrees) < 1 or sum(degrees) > (9 if len(letters) < 2 else 7 if len(letters) < 4 else 5):
        return None
    return of_polynomial(plane, sp.resultant(*flat, unknown).xreplace(shown))
