"""Vibrations in the letters of the course: ω_n, ζ, ω_d, and what a force keeps up, for a + 2 ζ ω_n v + ω_n² q = F(t).

The formulas are those of `linear_laws`, written in these letters: q = qp(t) + (q0 - qp(t0)) C(τ) + (v0 - vp(t0)) S(τ).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.calculus.spans import Moment, Span
from planar_cli.records import record


@record
class Vibration:
    """The letters of one linear law with a stiffness."""

    natural: sp.Symbol
    """ω_n, 1/s."""
    ratio: sp.Symbol | None
    """ζ; None: nothing damps."""
    damped: sp.Symbol | None
    """ω_d, 1/s; None: it does not swing, or is not damped."""
    roots: tuple[sp.Symbol, sp.Symbol] | None
    """λ_1 and λ_2, 1/s, where it is over-damped."""
    steady: sp.Expr
    """What it is about in the end, and what a force keeps up, a formula in these letters and the time."""
    free: tuple[tuple[sp.Symbol, sp.Expr], ...]
    """ω_n, ζ, ω_d or the roots, each with its formula."""
    forced: tuple[tuple[sp.Symbol, sp.Expr], ...]
    """The letters of its place of rest and of what a force keeps up, each with its formula."""
    rest: tuple[sp.Symbol, ...] = ()
    """The letter of its place of rest, where that is not zero."""
    begun: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    """A and B of the free vibration since a state, each with its formula, where these are told."""

    def free_motion(self, tau: sp.Expr, a: sp.Expr, b: sp.Expr) -> sp.Expr:
        """e^(-ζ ω_n τ) (A cos(ω_d τ) + B sin(ω_d τ)), and what takes its place for other dampings."""
        n = self.natural
        if self.roots is not None:
            return a * sp.exp(self.roots[0] * tau) + b * sp.exp(self.roots[1] * tau)
        if self.ratio is None:
            return a * sp.cos(n * tau) + b * sp.sin(n * tau)
        if self.damped is None:
            return (a + b * tau) * sp.exp(-n * tau)
        swing = a * sp.cos(self.damped * tau) + b * sp.sin(self.damped * tau)
        return sp.exp(-self.ratio * n * tau) * swing

    def amplitudes(self, q0: sp.Expr, v0: sp.Expr, a: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
        """A and B of a free vibration that begins with q0 and v0; B in terms of A."""
        n = self.natural
        if self.roots is not None:
            one, two = self.roots
            return (v0 - two * q0) / (one - two), q0 - a
        if self.ratio is None:
            return q0, v0 / n
        return q0, v0 + n * a if self.damped is None else (v0 + self.ratio * n * a) / self.damped

    def fundamental(self, tau: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
        """The motions from C = 1, C' = 0 and from S = 0, S' = 1: C, C', S, S'."""
        n = self.natural
        if self.roots is not None:
            one, two = self.roots
            first, second, apart = sp.exp(one * tau), sp.exp(two * tau), one - two
            return (
                (one * second - two * first) / apart,
                one * two * (second - first) / apart,
                (first - second) / apart,
                (one * first - two * second) / apart,
            )
        if self.ratio is None:
            sine, cosine = sp.sin(n * tau), sp.cos(n * tau)
            return cosine, -n * sine, sine / n, cosine
        if self.damped is None:
            e = sp.exp(-n * tau)
            return (1 + n * tau) * e, -(n**2) * tau * e, tau * e, (1 - n * tau) * e
        w, decay = self.damped, self.ratio * n
        e, sine, cosine = sp.exp(-decay * tau), sp.sin(w * tau), sp.cos(w * tau)
        return e * (cosine + decay * sine / w), -(n**2) * e * sine / w, e * sine / w, e * (cosine - decay * sine / w)


def in_letters(spans: Iterable[Span], own: Vibration, time: sp.Symbol, start: Moment, end: Moment) -> tuple[Span, ...]:
    """The relations of a linear law, those by the time in its letters. `time`: what runs in `own.steady`."""
    kept, kept_rate, pushed, pushed_rate = own.fundamental(end.t - start.t)
    rate = sp.diff(own.steady, time)
    q0, v0 = start.q - own.steady.xreplace({time: start.t}), start.v - rate.xreplace({time: start.t})
    place = own.steady.xreplace({time: end.t}) + q0 * kept + v0 * pushed
    speed = rate.xreplace({time: end.t}) + q0 * kept_rate + v0 * pushed_rate
    formulas = {"q(t)": (end.q, place), "v(t)": (end.v, speed)}
    found = []
    for s in spans:
        if EQUATION in s.words and s.kind in formulas:
            letter, formula = formulas[s.kind]
            found.append(replace(s, residual=letter - formula, explicit=formula, unevaluated=False))
        else:
            found.append(s)
    return tuple(found)
