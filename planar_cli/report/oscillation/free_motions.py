"""A free vibration told as a function of the time, once, before what it is at this or that state.

From 1 on, under-damped, ζ < 1:
  x = x_0 exp(-ζ ω_n t) (cos(ω_d t) + ζ ω_n sin(ω_d t)/ω_d)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.calculus.vibrations import Vibration
from planar_cli.equation.algebra.plain import identically_zero, simplified
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.words.characteristic import with_coefficients
from planar_cli.report.words.origins import calculus
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import RegimeTrace, Relation, RouteTrace

RATES = {"q(t)": "", "v(t)": "_dot"}


def motion_blocks(e: Relation, route: RouteTrace, phrases: Phrases, regimes: Sequence[RegimeTrace]) -> Iterator[Block]:
    """The place and, where a state rests on it, the velocity of the vibration of which a relation is, up to the state
    at which its regime ends.
    """
    law = e.law
    if law is None or law.vibration is None:
        return
    time, names = sp.Symbol("t", real=True), phrases.ledger.symbols
    words = with_coefficients(calculus(e), law, names["t"])
    end = _end(e.since, regimes)
    reach = f"From {e.since} to {end}" if end else f"From {e.since} on"
    yield Paragraph(line(f"{reach}, " if e.since else "", *words, ":"))
    every = [r for leg in route.steps for r in leg.relations if _is_same(r, e)]
    given = {r.kind for r in every}
    for kind, dots in RATES.items():
        told = next((r for r in every if r.kind == kind), None)
        if told is None or told.span is None or told.span.explicit is None:
            continue
        formula = told.span.explicit.xreplace(dict(route.plain))
        roles = {s: role for s in formula.free_symbols if (role := phrases.ledger.roles.get(s)) is not None}
        ends = [s for s, role in roles.items() if role.of == names["t"] and role.at == told.stop]
        formula = simplified(formula.xreplace(dict.fromkeys(ends, time)))
        place = _place(formula, law.vibration, time) if "q(t)" not in given else None
        if place is not None:
            yield Equation((line(Name(law.coordinate.symbol.name)), phrases.math(place)))
        yield Equation((line(Name(f"{law.coordinate.symbol.name}{dots}")), phrases.math(formula)))


def _place(speed: sp.Expr, own: Vibration, time: sp.Symbol) -> sp.Expr | None:
    """Where it is, of which the speed is the derivative: q = q_eq - v̇/ω_n². None: it is driven, or damped."""
    rates = sp.Add.make_args(sp.diff(speed, time))
    place = sp.Add(own.steady, *(-simplified(rate / own.natural**2) for rate in rates))
    return place if identically_zero(sp.diff(place, time) - speed) else None


def _end(since: str, regimes: Sequence[RegimeTrace]) -> str:
    """The state at which the regime that begins in a state gives way to another one; "": none does."""
    every = [(r, a, b) for r in regimes for a, b in r.stretches if a != b]
    own, stop = next(((r, b) for r, a, b in every if a == since), (None, ""))
    while (after := next(((r, b) for r, a, b in every if a == stop), None)) is not None and after[0] is own:
        stop = after[1]
    return stop if after is not None else ""


def _is_same(r: Relation, e: Relation) -> bool:
    """Is a relation one of the same vibration since the same state, by the time?"""
    if r.law is None or r.law.vibration is None or r.span is None or e.law is None or e.law.vibration is None:
        return False
    same = r.law.vibration.natural == e.law.vibration.natural and r.since == e.since
    return same and EQUATION in r.span.words
