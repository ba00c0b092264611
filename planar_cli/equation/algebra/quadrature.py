"""Definite integrals by numbers, with digits that are certain: the double-exponential (tanh-sinh) rule.

The rule takes integrable singularities at the ends, such as 1/sqrt(b - x) at a turning point. A result counts as
certain when two levels of the rule agree; corners inside the interval must be made ends by `breaks`.
Source: H. Takahasi and M. Mori, Double Exponential Formulas for Numerical Integration (1974).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal, getcontext
from functools import lru_cache
from itertools import combinations
from typing import Any

import mpmath
import sympy as sp

from planar_cli.errors import NotReached, NoValue

Mpf = Any
"""mpmath.mpf: the package carries no types."""
FIRST_LEVEL, LAST_LEVEL = 3, 7
SPLITS, VALUES_PER_DIGIT = 8, 230
"""An interval is halved so many times, and the integrand asked so often per digit, before the integral is given up."""
GRID = 96
"""Changes of sign of a switching expression are looked for between so many points."""


ROUNDED = 10
"""Places that differ by no more than so many of their last digits are one place."""


class Unsettled(NotReached):
    """The rule does not settle."""


def quad(f: Callable[[Mpf], Mpf], a: Any, b: Any, digits: int = 30) -> Decimal:
    """∫ f(x) dx from a to b (finite; b < a reverses the sign) to `digits` digits relative to ∫ |f| dx.

    ArithmeticError: not certain, f has no real value inside the interval, or the integral does not exist.
    """
    with mpmath.workdps(2 * digits + 10):
        low, high = mpmath.mpf(str(a)), mpmath.mpf(str(b))
        if not (mpmath.isfinite(low) and mpmath.isfinite(high)):
            raise NoValue("an integral with an infinite limit")
        if low == high:
            return Decimal(0)
        left = VALUES_PER_DIGIT * digits

        def counted(x: Mpf) -> Mpf:
            nonlocal left
            left -= 1
            if left < 0:
                raise Unsettled("an integral that does not settle")
            return f(x)

        total, _ = _halved(counted, low, high, digits, SPLITS)
        return Decimal(mpmath.nstr(total, digits + 10))


def _halved(f: Callable[[Mpf], Mpf], a: Mpf, b: Mpf, digits: int, splits: int) -> tuple[Mpf, Mpf]:
    """The integral of f and that of |f|, over the whole or over two halves."""
    found = _whole(f, a, b, digits)
    if found is not None:
        return found
    if not splits:
        raise Unsettled("an integral that does not settle")
    middle = (a + b) / 2
    left, right = _halved(f, a, middle, digits, splits - 1), _halved(f, middle, b, digits, splits - 1)
    return left[0] + right[0], left[1] + right[1]


def _whole(f: Callable[[Mpf], Mpf], a: Mpf, b: Mpf, digits: int) -> tuple[Mpf, Mpf] | None:
    """The rule at growing levels until two agree; None: they never do."""
    half = (b - a) / 2
    certain = mpmath.mpf(10) ** -digits
    total = size = mpmath.mpf(0)
    last = change = None
    for level in range(FIRST_LEVEL, LAST_LEVEL + 1):
        new, new_size, tail = _level(f, a, b, digits, level)
        step = mpmath.mpf(2) ** -level
        total, size = total + new, size + new_size
        value, scale = half * step * total, abs(half) * step * size
        if tail * abs(half) * step > mpmath.sqrt(certain) * scale:
            raise NoValue("an integral that does not exist at one of its ends")
        if last is not None:
            before, change = change, abs(value - last)
            near = before is not None and before <= mpmath.cbrt(certain) * scale
            if change <= certain * scale and (near or not scale):
                return value, scale
        last = value
    return None


def _level(f: Callable[[Mpf], Mpf], a: Mpf, b: Mpf, digits: int, level: int) -> tuple[Mpf, Mpf, Mpf]:
    """What the new nodes of one level add: to the sum, to the sum of sizes; and the size at the outermost nodes."""
    half = (b - a) / 2
    total = size = tail = mpmath.mpf(0)
    outermost = mpmath.mpf(10) ** (10 - 2 * digits)
    for gap, weight in _nodes(digits, level):
        for x in (a + gap * half, b - gap * half) if gap != 1 else ((a + b) / 2,):
            y = _at(f, x, gap, digits)
            if y is None:
                continue
            total += weight * y
            size += weight * abs(y)
            if gap < outermost:
                tail = max(tail, weight * abs(y))
    return total, size, tail


def _at(f: Callable[[Mpf], Mpf], x: Mpf, gap: Mpf, digits: int) -> Mpf | None:
    """f(x); None where it can not be told from its value at an end."""
    try:
        y = f(x)
        if isinstance(y, mpmath.mpc) or not mpmath.isfinite(y):
            raise NoValue("no real value inside the interval of an integral")
    except Unsettled:
        raise
    except (ArithmeticError, ValueError) as wrong:
        if gap < mpmath.mpf(10) ** -(3 * digits // 2):
            return None
        raise NoValue("no real value inside the interval of an integral") from wrong
    return y


@lru_cache(maxsize=64)
def _nodes(digits: int, level: int) -> tuple[tuple[Mpf, Mpf], ...]:
    """New nodes of a level on [-1, 1]: the gap to the nearer end, and the weight; the first level has all of them."""
    with mpmath.workdps(2 * digits + 20):
        step = mpmath.mpf(2) ** -level
        found: list[tuple[Mpf, Mpf]] = []
        first, stride = (0, 1) if level == FIRST_LEVEL else (1, 2)
        k, smallest = first, mpmath.mpf(10) ** -(2 * digits + 6)
        while True:
            u = k * step
            e = mpmath.exp(-mpmath.pi * mpmath.sinh(u))
            gap = 2 * e / (1 + e)
            if gap < smallest:
                return tuple(found)
            found.append((gap, mpmath.pi / 2 * mpmath.cosh(u) * 4 * e / (1 + e) ** 2))
            k += stride


def to_decimal(x: Mpf) -> Decimal:
    """A number of mpmath's to all digits of the decimals in use."""
    man, exp = map(int, x.man_exp)
    whole = Decimal(-man if x < 0 else man)
    return +(whole * (1 << exp)) if exp >= 0 else whole / (1 << -exp)


def switching(expr: sp.Expr) -> list[sp.Expr]:
    """Where one of these changes its sign, an expression may have a corner or a jump."""
    found = [a.args[0] for a in sorted(expr.atoms(sp.Abs, sp.sign), key=sp.default_sort_key)]
    found += [a - b for m in expr.atoms(sp.Max, sp.Min) for a, b in combinations(m.args, 2)]
    found += [c.lhs - c.rhs for p in expr.atoms(sp.Piecewise) for c in p.atoms(sp.core.relational.Relational)]
    return found


def breaks(switches: Sequence[Callable[[Decimal], Decimal]], a: Decimal, b: Decimal) -> list[Decimal]:
    """a, the places between where a switching expression changes its sign, b."""
    inside = []
    for g in switches:
        xs = [a + (b - a) * Decimal(i) / GRID for i in range(GRID + 1)]
        ys = [g(x) for x in xs]
        for i in range(GRID):
            if ys[i] == 0:
                inside.append(xs[i])
            elif ys[i] * ys[i + 1] < 0:
                inside.append(_changes(g, xs[i], xs[i + 1], ys[i], ys[i + 1]))
    same = max(abs(a), abs(b)).scaleb(ROUNDED - getcontext().prec)
    places = [a]
    for x in sorted(set(inside), reverse=b < a):
        if min(abs(x - places[-1]), abs(x - b)) > same:
            places.append(x)
    return [*places, b]


def _changes(g: Callable[[Decimal], Decimal], a: Decimal, b: Decimal, ga: Decimal, gb: Decimal) -> Decimal:
    """Where the sign changes between a and b: secants within the bracket (Illinois), every third time its middle."""
    least = max(abs(a), abs(b)).scaleb(1 - getcontext().prec)
    for turn in range(1, 700):
        middle = (a + b) / 2
        if middle in (a, b) or abs(b - a) <= least:
            break
        x = middle if turn % 3 == 0 else b - gb * (b - a) / (gb - ga)
        # So that the other end comes near as well.
        x = min(max(x, min(a, b) + least / 4), max(a, b) - least / 4)
        y = g(x)
        if y == 0:
            return x
        if (y > 0) == (gb > 0):
            ga /= 2
        else:
            a, ga = b, gb
        b, gb = x, y
    return (a + b) / 2
