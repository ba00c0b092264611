"""The speed at any time by a balance of momentum up to then, which a way is integrated from: no law is told for it.

From 1 to 2, wagon: impulse and momentum:         (1) F t_2 = (M + q t_2) v_2
Likewise at any time, with t for t_2:   v = F t/(M + q t)

Beside a speed that the file gives as a function of time it is a multiple of that: v_Q = -m v_P,boat/(M + m).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import derivative, identically_zero, simplified
from planar_cli.report.document.blocks import Block, Equation, Paragraph, line
from planar_cli.report.notation.clean import common_dimension
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Relation

MOMENTUM, VELOCITY = "momentum", "velocity"


def speed_by_balance(e: Relation, found: MotionTrace, phrases: Phrases) -> list[Block] | None:
    """The speed as a function of time, once; None: no balance tells it."""
    own = _at_any_time(e, found)
    if own is None:
        return None
    speed, formula, end, balance = own
    if common_dimension(found.ledger, speed, formula) is None:
        # Its numbers hide units.
        return None
    relations = [r for leg in found.route.steps for r in leg.relations]
    before = relations[: next((i for i, r in enumerate(relations) if r is e), len(relations))]
    others = (_at_any_time(r, found) for r in before if r.since == e.since)
    if any(other is not None and other[:2] == (speed, formula) for other in others):
        return []
    if any(r is balance for r in before):
        head = line("Likewise at any time, with t for ", phrases.math(found.route.plain.get(end, end)), ":")
    else:
        head = line(f"Impulse and momentum from {e.since} to any time t:")
    sides = (speed, *_by_given_speed(formula, found), formula)
    return [Paragraph(head), Equation(tuple(map(phrases.math, sides)))]


def _by_given_speed(formula: sp.Expr, found: MotionTrace) -> list[sp.Expr]:
    """-m v_rel/(M + m): the speed as a constant times one that the file gives as a function of time; empty where it is
    none.
    """
    t = found.ledger.symbols.get("t")
    velocities = [stage for r in found.regimes for stage in r.solution.stages if stage.level == VELOCITY]
    solved = [b for stage in velocities for b in stage.blocks if all(w.given for w in b.equations)]
    for given in (one for block in solved if t is not None for one in block.lines):
        if not given.formula.has(t) or given.formula.free_symbols & (found.varying - {t}):
            continue
        share = simplified(formula / given.formula)
        if not share.has(t) and not share.is_number:
            return [factored(share) * given.symbol]
    return []


def _at_any_time(e: Relation, found: MotionTrace) -> tuple[sp.Symbol, sp.Expr, sp.Symbol, Relation] | None:
    """A speed, its formula, and the time of the state for which a balance, the last of these, has it."""
    if e.kind != "q(t)" or e.law is None or e.span is None or e.span.explicit is None:
        return None
    general, route = dict(found.general), found.route
    own = [s for s in general if s.name.endswith(f"__{e.stop}")]
    speed = next((s for s in own if general[s] in (e.law.v, e.law.speed)), None)
    t = next((s for s in own if general[s].name == "t"), None)
    if speed is None or t is None:
        return None
    rate = derivative(e.span.explicit, t)
    relations = [r for leg in route.steps for r in leg.relations if r.since == e.since]
    balances = [r for r in relations if isinstance(r.source, BalanceTrace) and r.kind == MOMENTUM]
    here = [r for r in balances if r.stop == e.stop and derivative(r.residual, speed).has(t)]
    told = next((r for r in here if identically_zero(r.residual.xreplace({speed: rate}))), None)
    if told is None:
        told, t, rate = next(_elsewhere(balances, e, (speed, t, rate), found), (None, t, rate))
    if told is None:
        return None
    rest = {s: route.plain.get(s, s) for s in rate.free_symbols if s != t}
    return general[speed], factored(simplified(rate.xreplace(rest).xreplace({t: general[t]}))), t, told


def _elsewhere(
    balances: Sequence[Relation], e: Relation, own: tuple[sp.Symbol, sp.Symbol, sp.Expr], found: MotionTrace
) -> Iterator[tuple[Relation, sp.Symbol, sp.Expr]]:
    """Balances from the same state to others that give the speed there by the same function of time, with the times of
    these states and the function there. `own`: the speed, the time and the rate of the place at the end of `e`.
    """
    speed, t, rate = own
    for balance in balances:
        there = {general: s for s, general in found.general.items() if s.name.endswith(f"__{balance.stop}")}
        moved = {s: there[g] for s in (speed, t) if (g := found.general[s]) in there}
        if balance.stop == e.stop or len(moved) < len((speed, t)) or not balance.residual.has(moved[t]):
            continue
        if identically_zero(balance.residual.xreplace({moved[speed]: rate.xreplace(moved)})):
            yield balance, moved[t], rate.xreplace(moved)
