"""Functions of place and time of which a given expression is the rate, and speeds with a sign."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from planar_cli.calculus.antiderivative import antiderivative
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import derivative, longer, simplified
from planar_cli.solve.regimes.regime import Regime

LONG = 400
_KEPT = 10_000


def potential(rate: sp.Expr, regime: Regime) -> sp.Expr | None:
    """G(t, q) with dG/dt = rate along every motion of the regime; None: none was found.

    The rate must be linear in the free speeds u: Σ A(q) u + B(t). One coordinate after the other is integrated, and
    what is left must vanish at last.
    """
    rest = simplified(expanded(rate))
    if rest == 0:
        return sp.S.Zero
    if longer(rest, LONG):
        return None
    total = sp.S.Zero
    for c in regime.coordinates:
        pace = regime.rates[c.symbol]
        slope = _along(rest, c.symbol, pace, regime)
        if slope is None or slope == 0:
            continue
        part = _integral(slope, c.symbol)
        if part is None:
            continue
        total += part
        change = sum((derivative(part, q) * r for q, r in regime.rates.items()), derivative(part, regime.time))
        rest = simplified(expanded(rest - change))
        if rest == 0:
            return total
    if rest.free_symbols & set(regime.letters) <= {regime.time}:
        part = _integral(rest, regime.time)
        return None if part is None else total + part
    return None


@lru_cache(maxsize=_KEPT)
def _integral(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """An antiderivative; None: none is known. The laws of regimes, states and cases have most integrals in common."""
    return antiderivative(f, x)


def _along(rest: sp.Expr, q: sp.Symbol, pace: sp.Expr, regime: Regime) -> sp.Expr | None:
    """The factor A of rest = A dq/dt + …"""
    speeds = [u for u in regime.free if pace.has(u)]
    if not speeds:
        if pace == 0 or pace.has(q) or not rest.has(q):
            return None
        own = rest.xreplace(dict.fromkeys(regime.free, sp.S.Zero))
        return None if own.free_symbols & set(regime.letters) - {q} else simplified(own / pace)
    u = speeds[0]
    slope = simplified(derivative(rest, u))
    if slope.has(*regime.free):
        return None
    ratio = simplified(slope / derivative(pace, u))
    return None if ratio.has(*regime.free) else ratio


def signed_speed(vx: sp.Expr, vy: sp.Expr, regime: Regime) -> tuple[sp.Expr, bool]:
    """The speed of a point, with a sign where one formula carries it (true): along x, along y, or with one freedom."""
    vx, vy = simplified(vx), simplified(vy)
    if vx == 0 or vy == 0:
        return vx + vy, True
    square = simplified(expanded(vx**2 + vy**2))
    for u in regime.free:
        rest = simplified(square / u**2)
        if not rest.has(*regime.free):
            return u * sp.sqrt(factored(rest)), True
    root = None if square.has(*regime.free) else _plain_root(factored(square))
    return (sp.sqrt(square), False) if root is None else (root, True)


def _plain_root(square: sp.Expr) -> sp.Expr | None:
    """A root that needs no bars, as of k² t⁴, of a driven speed; it may be negative. None: it has none."""
    root = sp.S.One
    for factor in sp.Mul.make_args(square):
        base, power = factor.as_base_exp()
        if power.is_Integer and power % 2 == 0:
            root *= base ** (power / 2)
        elif factor.is_positive:
            root *= sp.sqrt(factor)
        else:
            return None
    return root
