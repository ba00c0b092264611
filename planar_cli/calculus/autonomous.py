"""dx/dt = f(x): separated, dx/f(x) = dt, and solved for x(t) where that is possible.

Serves a = f(v) with x = v, where ∫ v dt and ∫ v dv/f(v) = ∫ dq are wanted too, and v = f(q) with x = q.
Source: An Introduction to Planar Dynamics, 1.3.1, equations 1.19, 1.20 and 1.27b.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.calculus.antiderivative import definite
from planar_cli.calculus.deciding import confirmed, sign
from planar_cli.calculus.spans import bound
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record


@record
class Separated:
    """What is known in closed form of dx/dt = f(x), x = x0 at the start; None: nothing is.

    `elapsed`: t - t0 by x; `state`: x by τ = t - t0; `summed`: ∫ x dt by τ; `travelled`: ∫ x dx/f by x. `where`:
    expressions in x and τ that must not become negative.
    """

    elapsed: sp.Expr | None = None
    state: sp.Expr | None = None
    summed: sp.Expr | None = None
    travelled: sp.Expr | None = None
    where: tuple[sp.Expr, ...] = ()


def separated(f: sp.Expr, x: sp.Symbol, x0: sp.Symbol, tau: sp.Symbol, value: Valuation | None = None) -> Separated:
    """Closed forms of dx/dt = f(x), each confirmed; where none is known, the fields are None."""
    found = _by_class(f, x, x0, tau, value)
    if found.state is not None and not _moves(found, f, x, tau, value):
        found = replace(found, state=None, summed=None)
    y = bound(x)
    inside = f.xreplace({x: y})
    if found.elapsed is None:
        found = replace(found, elapsed=definite(1 / inside, y, x0, x, value))
    if found.travelled is None:
        found = replace(found, travelled=definite(y / inside, y, x0, x, value))
    return found


def _moves(found: Separated, f: sp.Expr, x: sp.Symbol, tau: sp.Symbol, value: Valuation | None) -> bool:
    """Do the formulas in time obey the law, and the others too?"""
    state = found.state
    checks = [sp.diff(state, tau) - f.xreplace({x: state})]
    if found.summed is not None:
        checks.append(sp.diff(found.summed, tau) - state)
    if found.elapsed is not None:
        checks.append(sp.diff(found.elapsed, x) - 1 / f)
    if found.travelled is not None:
        checks.append(sp.diff(found.travelled, x) - x / f)
    return all(confirmed(c, value, (x, tau)) for c in checks)


def _by_class(f: sp.Expr, x: sp.Symbol, x0: sp.Symbol, tau: sp.Symbol, value: Valuation | None) -> Separated:
    own = expanded(f)
    if own.is_polynomial(x) and sp.degree(own, x) <= 2:
        by = sp.Poly(own, x)
        a, b, c = (by.coeff_monomial(x**k) for k in range(3))
        if c == 0:
            return _linear(a, b, x, x0, tau)
        if a == 0 and b == 0:
            return _square(c, x, x0, tau)
        return _quadratic(a, b, c, x, x0, tau, value)
    factor, power = f.as_independent(x, as_Add=False)
    if power.is_Pow and power.exp.is_Rational and power.exp not in (1, 2):
        slope = sp.diff(power.base, x)
        if not slope.has(x):
            return _power(factor, power, slope, x, x0, tau, value)
    return Separated()


def _linear(a: sp.Expr, b: sp.Expr, x: sp.Symbol, x0: sp.Symbol, tau: sp.Symbol) -> Separated:
    """dx/dt = a + b x; the final value is -a/b."""
    if b == 0:
        return Separated()
    final, e = simplified(-a / b), sp.exp(b * tau)
    log = sp.log(simplified((a + b * x) / (a + b * x0)))
    return Separated(
        log / b,
        final + (x0 - final) * e,
        final * tau + (x0 - final) / b * (e - 1),
        (x - x0) / b + final * log / b,
    )


def _square(c: sp.Expr, x: sp.Symbol, x0: sp.Symbol, tau: sp.Symbol) -> Separated:
    """dx/dt = c x²."""
    below = 1 - c * x0 * tau
    return Separated((1 / x0 - 1 / x) / c, x0 / below, -sp.log(below) / c, sp.log(x / x0) / c, (below,))


def _quadratic(
    a: sp.Expr, b: sp.Expr, c: sp.Expr, x: sp.Symbol, x0: sp.Symbol, tau: sp.Symbol, value: Valuation | None
) -> Separated:
    """dx/dt = a + b x + c x²; with u = x + b/(2c) it is du/dt = a' + c u²."""
    shift, rest = b / (2 * c), simplified(a - b**2 / (4 * c))
    u, u0 = x + shift, x0 + shift
    kind = sign(rest, value)
    same = sign(sp.S.Zero if kind == 0 else simplified(rest * c), value)
    if kind is None or same is None:
        return Separated()
    if kind == 0:
        below = 1 - c * u0 * tau
        elapsed, state, summed = (1 / u0 - 1 / u) / c, u0 / below, -sp.log(below) / c
        where: tuple[sp.Expr, ...] = (below,)
    elif same > 0:
        scale, rate = sp.sqrt(simplified(rest / c)), kind * sp.sqrt(simplified(rest * c))
        first = sp.atan(u0 / scale)
        angle = first + rate * tau
        elapsed = (sp.atan(u / scale) - first) / rate
        state, summed = scale * sp.tan(angle), -sp.log(sp.cos(angle) / sp.cos(first)) / c
        where = (sp.pi / 2 - angle, sp.pi / 2 + angle)
    else:
        scale = sp.sqrt(simplified(-rest / c))
        angle = kind * sp.sqrt(simplified(-rest * c)) * tau
        if sign(sp.expand(scale**2 - u0**2), value) == 1:
            elapsed = (sp.atanh(u / scale) - sp.atanh(u0 / scale)) * scale / rest
        else:
            elapsed = sp.log((scale + u) * (scale - u0) / ((scale - u) * (scale + u0))) * scale / (2 * rest)
        state = scale * (u0 + scale * sp.tanh(angle)) / (scale + u0 * sp.tanh(angle))
        grown = sp.cosh(angle) + u0 / scale * sp.sinh(angle)
        summed, where = -sp.log(grown) / c, (grown,)
    log = sp.log((a + b * x + c * x**2) / (a + b * x0 + c * x0**2)) / (2 * c)
    return Separated(elapsed, state - shift, summed - shift * tau, log - shift * elapsed, where)


def _power(
    c: sp.Expr, power: sp.Pow, slope: sp.Expr, x: sp.Symbol, x0: sp.Symbol, tau: sp.Symbol, value: Valuation | None
) -> Separated:
    """dx/dt = c u^n with u = offset + slope x, n neither 0, 1 nor 2; for u > 0, or mirrored for a whole n and u < 0."""
    u, n = power.args
    u0 = u.xreplace({x: x0})
    side = -1 if n.is_Integer and sign(u0, value) == -1 else 1
    y, y0, rate = side * u, side * u0, side * slope * c * side**n
    offset = simplified(y - side * slope * x)
    m, k = 1 - n, 2 - n
    inside = y0**m + m * rate * tau
    elapsed = (y**m - y0**m) / (m * rate)
    summed, passed = (inside ** (k / m) - y0**k) / (k * rate), (y**k - y0**k) / (k * rate)
    return Separated(
        elapsed,
        (inside ** (1 / m) - offset) / (side * slope),
        (summed - offset * tau) / (side * slope),
        (passed - offset * elapsed) / (side * slope),
        (y, inside),
    )
