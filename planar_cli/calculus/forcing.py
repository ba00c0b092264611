"""Particular solutions of linear equations with constant coefficients, by undetermined coefficients.

The forcing is a sum of polynomial x exponential x (sine or cosine of a linear argument). With the operator
p(D) = k0 + k1 D + k2 D² and a term P(t) e^(st), s = a + i w, the solution is z(t) e^(st) where
sum_j p^(j)(s)/j! z^(j) = P: from the highest power downwards. A root s of p of multiplicity m (resonance) makes the
first m of these vanish; then z is the m-fold integral. Complex numbers are pairs of real expressions.
"""

from __future__ import annotations

from math import comb, factorial

import sympy as sp

from planar_cli.calculus.deciding import vanishes
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import MANY, longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record

Pair = tuple[sp.Expr, sp.Expr]
_NOTHING: Pair = (sp.S.Zero, sp.S.Zero)
_ONE: Pair = (sp.S.One, sp.S.Zero)
HIGHEST, HIGHEST_OF_WAVE = 12, 5
"""The highest power of t (or of a sine) that is taken, and the highest of t that multiplies a sine."""


@record
class Forcing:
    """P(t) e^growth trig(phase): `powers` are the coefficients of P; growth and phase are linear in t."""

    powers: tuple[sp.Expr, ...]
    growth: sp.Expr
    phase: sp.Expr
    sine: bool


def particular(
    operator: tuple[sp.Expr, ...],
    forcing: sp.Expr,
    t: sp.Symbol,
    value: Valuation | None = None,
    base: sp.Expr | None = None,
) -> sp.Expr | None:
    """A solution of p(D) y = forcing, where operator = (k0, k1, …); None: the forcing is of another kind.

    `base`: the letter of resonance, t - t0 for instance (t if none is given). A coefficient of unknown sign that is not
    identically zero counts as not zero.
    """
    terms = split(forcing, t)
    if terms is None:
        return None
    found = [_one(operator, term, t, value, t if base is None else base) for term in terms]
    return None if None in found else sp.Add(*found)


def split(forcing: sp.Expr, t: sp.Symbol) -> tuple[Forcing, ...] | None:
    """The terms of a forcing; None: it is not a sum of polynomial x exponential x sine or cosine."""
    plain = forcing.replace(sp.sinh, lambda x: (sp.exp(x) - sp.exp(-x)) / 2)
    plain = plain.replace(sp.cosh, lambda x: (sp.exp(x) + sp.exp(-x)) / 2)
    moving = sorted((f for f in plain.atoms(sp.Function) if f.has(t)), key=sp.default_sort_key)
    if any(f.func not in (sp.sin, sp.cos, sp.exp) or not _linear(f.args[0], t) for f in moving):
        return None
    letters = {f: sp.Dummy(f"f{i}") for i, f in enumerate(moving)}
    inside = plain.xreplace(letters)
    exponentials = {d for f, d in letters.items() if f.func is sp.exp}
    if longer(inside, 4 * MANY) or not _laurent(inside, t, exponentials, tuple(letters.values())):
        return None
    trigonometric = [f for f in moving if f.func is not sp.exp]
    found: dict[tuple[sp.Expr, sp.Expr, bool], list[sp.Expr]] = {}
    back = {d: f for f, d in letters.items()}
    for term in sp.Add.make_args(expanded(inside)):
        rest, own = term.as_independent(t, *back, as_Add=False)
        powers = own.as_powers_dict()
        growth = sp.Add(*(n * back[d].args[0] for d, n in powers.items() if d in back and back[d].func is sp.exp))
        waves = [f for f in trigonometric for _ in range(int(powers.get(letters[f], 0)))]
        degree = int(powers.get(t, 0))
        if len(waves) > HIGHEST or (waves and degree > HIGHEST_OF_WAVE):
            return None
        for (phase, sine), part in _product(waves).items():
            _collect(found, (growth, phase, sine), [*[sp.S.Zero] * degree, part * rest])
    return tuple(Forcing(tuple(c), g, p, s) for (g, p, s), c in found.items())


def _laurent(inside: sp.Expr, t: sp.Symbol, exponentials: set[sp.Dummy], letters: tuple[sp.Dummy, ...]) -> bool:
    """A polynomial in t, sines and cosines, with powers of the exponentials that may be negative?"""
    up = inside.replace(lambda e: e.is_Pow and e.base in exponentials, lambda e: e.base ** abs(e.exp))
    return bool(up.is_polynomial(t, *letters)) and sp.degree(up, t) <= HIGHEST


def _product(waves: list[sp.Expr]) -> dict[tuple[sp.Expr, bool], sp.Expr]:
    """A product of sines and cosines as a sum: coefficients by argument and "is it a sine"."""
    total: dict[tuple[sp.Expr, bool], sp.Expr] = {(sp.S.Zero, False): sp.S.One}
    for wave in waves:
        b, sine_b = wave.args[0], wave.func is sp.sin
        if len(total) == 1 and (sp.S.Zero, False) in total:
            total = {(b, sine_b): sp.S.One}
            continue
        last, total = total, {}
        for (a, sine_a), c in last.items():
            sine = sine_a != sine_b
            # sin a cos b, cos a sin b, sin a sin b, cos a cos b: of the sum and of the difference of the arguments
            for argument, sense in (
                (a + b, -1 if sine_a and sine_b else 1),
                (a - b, -1 if sine_b and not sine_a else 1),
            ):
                turned = argument.could_extract_minus_sign()
                key = -argument if turned else argument, sine
                total[key] = total.get(key, sp.S.Zero) + c * sense * (-1 if turned and sine else 1) / 2
    return total


def _collect(
    found: dict[tuple[sp.Expr, sp.Expr, bool], list[sp.Expr]], key: tuple[sp.Expr, sp.Expr, bool], more: list[sp.Expr]
) -> None:
    own = found.setdefault(key, [])
    own.extend([sp.S.Zero] * (len(more) - len(own)))
    for i, c in enumerate(more):
        own[i] += c


def _linear(argument: sp.Expr, t: sp.Symbol) -> bool:
    return not sp.diff(argument, t).has(t)


def _one(
    operator: tuple[sp.Expr, ...], term: Forcing, t: sp.Symbol, value: Valuation | None, base: sp.Expr
) -> sp.Expr | None:
    """The solution of one term."""
    s = simplified(sp.diff(term.growth, t)), simplified(sp.diff(term.phase, t))
    taylor = [_taylor(operator, s, j) for j in range(len(operator))]
    multiplicity = 0
    while all(vanishes(part, value) for part in taylor[multiplicity]):
        multiplicity += 1
        if multiplicity == len(taylor):
            return None
    rest = taylor[multiplicity:]
    n = len(term.powers) - 1
    y: list[Pair] = [_NOTHING] * (n + 1)
    for k in range(n, -1, -1):
        right: Pair = (term.powers[k], sp.S.Zero)
        for j in range(1, min(len(rest), n - k + 1)):
            many = sp.Integer(factorial(k + j) // factorial(k))
            right = _minus(right, _times((many, sp.S.Zero), _times(rest[j], y[k + j])))
        y[k] = _over(right, rest[0], value)
    letter = base if n == 0 else t
    real, imaginary = (
        sp.Add(*(c[i] * letter ** (k + multiplicity) * _lifted(k, multiplicity) for k, c in enumerate(y)))
        for i in (0, 1)
    )
    sine, cosine = sp.sin(term.phase), sp.cos(term.phase)
    wave = real * sine + imaginary * cosine if term.sine else real * cosine - imaginary * sine
    return sp.exp(term.growth) * wave


def _lifted(k: int, times: int) -> sp.Expr:
    """What integrating t^k so many times divides by."""
    return sp.Rational(factorial(k), factorial(k + times))


def _taylor(operator: tuple[sp.Expr, ...], s: Pair, j: int) -> Pair:
    """p^(j)(s)/j!"""
    total, power = _NOTHING, _ONE
    for i in range(j, len(operator)):
        total = _plus(total, _times((comb(i, j) * operator[i], sp.S.Zero), power))
        power = _times(power, s)
    return total


def _plus(a: Pair, b: Pair) -> Pair:
    return a[0] + b[0], a[1] + b[1]


def _minus(a: Pair, b: Pair) -> Pair:
    return a[0] - b[0], a[1] - b[1]


def _times(a: Pair, b: Pair) -> Pair:
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def _over(a: Pair, b: Pair, value: Valuation | None) -> Pair:
    """a/b; a part of b that vanishes is left out."""
    if vanishes(b[1], value):
        return a[0] / b[0], a[1] / b[0]
    if vanishes(b[0], value):
        return a[1] / b[1], -a[0] / b[1]
    below = b[0] ** 2 + b[1] ** 2
    above = _times(a, (b[0], -b[1]))
    return above[0] / below, above[1] / below
