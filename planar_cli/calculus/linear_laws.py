"""a = F(t) - c v - w2 q with constant coefficients: the motion from its start, by the characteristic equation.

q = qp(t) + (q0 - qp(t0)) C(τ) + (v0 - vp(t0)) S(τ), τ = t - t0, where qp is a particular solution, and C and S solve
the equation without forcing from C = 1, C' = 0 and from S = 0, S' = 1. Signs: w2 > 0 pulls back to q = 0, c > 0 damps.
Units: w2 in 1/s², c in 1/s. Source: An Introduction to Planar Dynamics, 1.3.1, example 1-7, discussion (ii).
"""

from __future__ import annotations

import sympy as sp

from planar_cli.calculus.antiderivative import definite
from planar_cli.calculus.deciding import confirmed, sign
from planar_cli.calculus.forcing import particular
from planar_cli.calculus.spans import Moment, Span, bound, span
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record

EQUATION = "λ² + c λ + ω² = 0"
"""The characteristic equation in general letters."""
UNDAMPED = f"no damping: two imaginary roots of {EQUATION}, c = 0"
_WORDS = {
    "undamped": UNDAMPED,
    "unstable": f"negative stiffness: two real roots of opposite sign of {EQUATION}, ω² < 0",
    "drag": f"no stiffness: the roots 0 and -c of {EQUATION}, ω² = 0",
    "under-damped": f"under-damped: two complex roots of {EQUATION}",
    "critical": f"critically damped: a double root of {EQUATION}",
    "over-damped": f"over-damped: two real roots of {EQUATION}",
    "free": "v = dq/dt and a = dv/dt",
}


@record
class Characteristic:
    """The roots of λ² + c λ + w2 = 0, and the two fundamental solutions as functions of the time τ since the start.

    `regime`: undamped, under-damped, critical, over-damped, unstable (c = 0, w2 < 0), drag (w2 = 0) or free (both 0).
    `rate`: ω, κ, the damped frequency, or half the distance of the real roots (1/s); `decay`: c/2 (1/s).
    """

    regime: str
    words: str
    rate: sp.Expr
    decay: sp.Expr
    kept: sp.Expr
    kept_rate: sp.Expr
    pushed: sp.Expr
    pushed_rate: sp.Expr


def characteristic(w2: sp.Expr, c: sp.Expr, tau: sp.Expr, value: Valuation | None = None) -> Characteristic | None:
    """The regime of a'' + c a' + w2 a = 0, decided exactly where it is; None: it can not be decided."""
    stiffness, damping = sign(w2, value), sign(c, value)
    if stiffness is None or damping is None:
        return None
    if damping == 0:
        return _without_damping(w2, stiffness, tau)
    decay = c / 2
    if stiffness == 0:
        e = sp.exp(-c * tau)
        return _named("drag", sp.S.Zero, decay, (sp.S.One, sp.S.Zero, (1 - e) / c, e))
    e = sp.exp(-decay * tau)
    inner = simplified(w2 - decay**2)
    kind = sign(inner, value)
    if kind is None:
        return None
    if kind == 0:
        return _named(
            "critical", sp.S.Zero, decay, ((1 + decay * tau) * e, -(decay**2) * tau * e, tau * e, (1 - decay * tau) * e)
        )
    if kind > 0:
        w = sp.sqrt(inner)
        sine, cosine = sp.sin(w * tau), sp.cos(w * tau)
        return _named(
            "under-damped",
            w,
            decay,
            (e * (cosine + decay / w * sine), -w2 / w * e * sine, e * sine / w, e * (cosine - decay / w * sine)),
        )
    w = sp.sqrt(simplified(-inner))
    one, two = -decay + w, -decay - w
    e1, e2 = sp.exp(one * tau), sp.exp(two * tau)
    return _named(
        "over-damped",
        w,
        decay,
        (
            (one * e2 - two * e1) / (2 * w),
            w2 * (e2 - e1) / (2 * w),
            (e1 - e2) / (2 * w),
            (one * e1 - two * e2) / (2 * w),
        ),
    )


def _without_damping(w2: sp.Expr, stiffness: int, tau: sp.Expr) -> Characteristic:
    if stiffness == 0:
        return _named("free", sp.S.Zero, sp.S.Zero, (sp.S.One, sp.S.Zero, tau, sp.S.One))
    if stiffness > 0:
        w = sp.sqrt(w2)
        sine, cosine = sp.sin(w * tau), sp.cos(w * tau)
        return _named("undamped", w, sp.S.Zero, (cosine, -w * sine, sine / w, cosine))
    w = sp.sqrt(-w2)
    sine, cosine = sp.sinh(w * tau), sp.cosh(w * tau)
    return _named("unstable", w, sp.S.Zero, (cosine, w * sine, sine / w, cosine))


def _named(
    regime: str, rate: sp.Expr, decay: sp.Expr, four: tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]
) -> Characteristic:
    return Characteristic(regime, _WORDS[regime], rate, decay, *four)


def linear(
    w2: sp.Expr,
    c: sp.Expr,
    forcing: sp.Expr,
    start: Moment,
    end: Moment,
    value: Valuation | None = None,
    where: tuple[sp.Expr, ...] = (),
) -> tuple[Span, ...]:
    """q(t) and v(t) of a = forcing - c v - w2 q; the forcing depends on end.t at most."""
    tau, elapsed = end.t - start.t, bound(end.t)
    own = characteristic(w2, c, elapsed, value)
    if own is None:
        return ()
    qp = particular((w2, c, sp.S.One), forcing, end.t, value, base=tau)
    if qp is None or not confirmed(_rest(qp, w2, c, forcing, end.t), value, (start.t, end.t)):
        return _convolved(own, forcing, start, end, value, where)
    vp = sp.diff(qp, end.t)
    q0, v0 = start.q - qp.subs(end.t, start.t), start.v - vp.subs(end.t, start.t)
    q = qp + q0 * own.kept + v0 * own.pushed
    v = vp + q0 * own.kept_rate + v0 * own.pushed_rate
    q, v = q.xreplace({elapsed: tau}), v.xreplace({elapsed: tau})
    return (
        span("q(t)", own.words, end.q - q, None, q, where),
        span("v(t)", own.words, end.v - v, None, v, where),
    )


def _rest(qp: sp.Expr, w2: sp.Expr, c: sp.Expr, forcing: sp.Expr, t: sp.Symbol) -> sp.Expr:
    vp = sp.diff(qp, t)
    return sp.Add(sp.diff(vp, t), c * vp, w2 * qp, -forcing)


def _convolved(
    own: Characteristic,
    forcing: sp.Expr,
    start: Moment,
    end: Moment,
    value: Valuation | None,
    where: tuple[sp.Expr, ...],
) -> tuple[Span, ...]:
    """Any forcing: each impulse F dt' starts a motion of its own; the sum (Duhamel's integral), closed if it can be."""
    x = bound(end.t)
    tau = end.t - start.t
    words = f"{own.words}; the motions that each impulse F dt starts, summed"
    found = []
    for kind, letter, kept, pushed in (
        ("q(t)", end.q, own.kept, own.pushed),
        ("v(t)", end.v, own.kept_rate, own.pushed_rate),
    ):
        each = forcing.xreplace({end.t: x}) * pushed.xreplace({x: end.t - x})
        closed = definite(each, x, start.t, end.t, value)
        summed = sp.Integral(each, (x, start.t, end.t)) if closed is None else closed
        formula = (start.q * kept + start.v * pushed).xreplace({x: tau}) + summed
        found.append(span(kind, words, letter - formula, None, formula, where))
    return tuple(found)
