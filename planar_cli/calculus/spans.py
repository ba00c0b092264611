"""Two instants of one coordinate, and the relations between them that a law of motion gives."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp

from planar_cli.records import record


@record
class Moment:
    """The symbols of one instant, all real: time t, coordinate q, speed v = dq/dt (its sign is that of growing q)."""

    t: sp.Symbol
    q: sp.Symbol
    v: sp.Symbol


@record
class Span:
    """One relation between two instants.

    `kind`: "q(t)", "v(t)", "v(q)", "t(v)", "t(q)" or "q(v)": what it gives, by what. `words`: where it comes from.
    `left` = `right`: the integrals over matching domains, as printed (their variable is a dummy with the name of the
    upper limit); None where it comes from no integral. `residual` vanishes; it holds no derivative. `explicit`: the
    formula of the first letter of `kind`. `unevaluated`: `residual` holds an integral that is to be done by numbers.
    `where`: expressions that must not become negative on the way, each bound to the end as it stands, else the
    relation does not hold (v: "as long as v ≥ 0"). `product`: μ and μ F of a law a = F - p v that is told as
    d(μ v)/dt = μ F, in the letters of the end.
    """

    kind: str
    words: str
    left: sp.Expr | None
    right: sp.Expr | None
    residual: sp.Expr
    explicit: sp.Expr | None
    unevaluated: bool
    where: tuple[sp.Expr, ...] = ()
    product: tuple[sp.Expr, sp.Expr] | None = None


@lru_cache(maxsize=1000)
def bound(symbol: sp.Symbol) -> sp.Dummy:
    """The integration variable that prints as `symbol`; always the same one."""
    return sp.Dummy(symbol.name, real=True)


def integral(integrand: Any, start: sp.Symbol, end: sp.Symbol) -> sp.Integral:
    """∫ over `end`'s letter from start to end, as written; the integrand is given with the symbol `end`."""
    x = bound(end)
    return sp.Integral(sp.sympify(integrand).xreplace({end: x}), (x, start, end))


def span(
    kind: str,
    words: str,
    residual: sp.Expr,
    sides: tuple[sp.Expr, sp.Expr] | None = None,
    explicit: sp.Expr | None = None,
    where: tuple[sp.Expr, ...] = (),
) -> Span:
    """A relation; whether it is evaluated is seen by looking."""
    left, right = sides or (None, None)
    return Span(kind, words, left, right, residual, explicit, residual.has(sp.Integral), where)
