"""A root known to machine precision, refined to fifty digits."""

from __future__ import annotations

import decimal
from collections.abc import Callable
from decimal import Decimal

from planar_cli.errors import NotReached

Exact = Callable[[Decimal], Decimal]

GUARD = 15
STENCIL = tuple(Decimal(p) / q for p, q in ((5, 6), (-5, 21), (5, 84), (-5, 504), (1, 1260)))
"""Central differences that give a first derivative up to the tenth power of the step."""


def polish(g: Exact, lo: float | Decimal, hi: float | Decimal, digits: int = 50) -> Decimal:
    """The root of g in [lo, hi], to `digits` digits as far as g itself has them.

    With a change of sign: that root. Without one: the extreme in between, if it is zero to seven tenths of the digits,
    or the first of the two roots about it if it lies on the other side of zero. ArithmeticError: there is no root.
    """
    with decimal.localcontext() as context:
        context.prec = max(context.prec, digits + GUARD)
        a, b = Decimal(lo), Decimal(hi)
        fa, fb = g(a), g(b)
        if not fa or not fb:
            return +(b if fa else a)
        if (fa > 0) == (fb > 0):
            t, value = _extreme(g, a, b, digits)
            size, across = max(abs(fa), abs(fb)), (value > 0) != (fa > 0)
            if abs(value) <= Decimal(10) ** (-digits if across else -(7 * digits) // 10) * size:
                return t
            if across:
                b, fb = t, value
            else:
                raise NotReached(f"no root between {lo} and {hi}: the nearest value to zero is {value:.6e}")
        return _narrow(g, a, b, fa, fb, digits)


def _extreme(g: Exact, a: Decimal, b: Decimal, digits: int) -> tuple[Decimal, Decimal]:
    """Where g is stationary in between, from differences, to about five digits less than g has; and its value there."""
    step = (b - a) * Decimal(10) ** -max(3, digits // 8)

    def rate(t: Decimal) -> Decimal:
        pairs = ((c, g(t + k * step) - g(t - k * step)) for k, c in enumerate(STENCIL, 1))
        return sum((c * d for c, d in pairs), Decimal(0))

    lo, hi = a + 5 * step, b - 5 * step
    da, db = rate(lo), rate(hi)
    if da and db and (da > 0) == (db > 0):
        raise NotReached(f"no root and no extreme between {a} and {b}")
    t = lo if not da else hi if not db else _narrow(rate, lo, hi, da, db, digits)
    return t, g(t)


def _narrow(g: Exact, a: Decimal, b: Decimal, fa: Decimal, fb: Decimal, digits: int) -> Decimal:
    """Secants within a bracket (Anderson and Björck), halved where they do not close it."""
    small = Decimal(10) ** -digits
    least = small * (b - a)
    width = abs(b - a)
    for turns in range(1, 40 * digits):
        close = max(small * max(abs(a), abs(b)), least) / 4
        if abs(b - a) <= 2 * close:
            break
        x = b - fb * (b - a) / (fb - fa)
        if turns % 3 == 0:
            if abs(b - a) > width / 8:
                x = (a + b) / 2
            width = abs(b - a)
        x = min(max(x, min(a, b) + close), max(a, b) - close)
        f = g(x)
        if not f:
            return +x
        if (f > 0) != (fb > 0):
            a, fa = b, fb
        else:
            share = 1 - f / fb
            fa *= share if share > 0 else Decimal("0.5")
        b, fb = x, f
    return (a + b) / 2
