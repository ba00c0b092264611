"""A momentum at a state by the relative velocity there, which the file gives as a function of the time: its value comes
first, and the balance and its solution are written with its letter.

v_P,boat,mid = 6 s t_mid (T - t_mid)/T³ = 1.2 m/s
0 = M v_Q,mid + m (v_Q,mid + v_P,boat,mid),  v_Q,mid = -m v_P,boat,mid/(M + m)
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.equation.values.ledger import Kind
from planar_cli.solve.between.trace.trace import GIVEN_RATE, BalanceTrace, MotionTrace, Relation, Result, RouteStep

MOMENTUM = "momentum"
LONGEST = 24
"""A longer function is left as it is."""


def with_rates_beside(motion: MotionTrace) -> MotionTrace:
    """The motion with such steps; the same object where there are none."""
    beside = {x: f for r in motion.requests for x, f in r.beside if _is_of_time(f, motion)}
    if not beside or motion.symbolic:
        return motion
    steps: list[RouteStep] = []
    told: set[sp.Symbol] = set()
    for step in motion.route.steps:
        told_by = (both for x, f in beside.items() if (both := _told(step, x, f)) is not None)
        x, new = next(told_by, (None, step))
        if x is None:
            steps.append(step)
            continue
        relation = Relation(x - beside[x], GIVEN_RATE, "", new.relations[0].stop)
        own = RouteStep((relation,), (x,), frozenset(), (Result(x, beside[x], motion.value(x)),), False)
        steps += [*([] if x in told else [own]), new]
        told.add(x)
    if not told:
        return motion
    requests = tuple(replace(r, beside=tuple(b for b in r.beside if b[0] not in told)) for r in motion.requests)
    return replace(motion, requests=requests, route=replace(motion.route, steps=tuple(steps)))


def _is_of_time(formula: sp.Expr, motion: MotionTrace) -> bool:
    """Does only the time of its state vary in it?"""
    own = formula.free_symbols & motion.general.keys()
    kinds = {motion.ledger.roles[motion.general[s]].kind for s in own}
    return kinds == {Kind.TIME} and not longer(formula, LONGEST)


def _told(step: RouteStep, x: sp.Symbol, f: sp.Expr) -> tuple[sp.Symbol, RouteStep] | None:
    """The step with the letter for the function; None: it is no balance of momentum that gives one velocity by it."""
    (e, *others), results = step.relations, step.results
    if others or len(results) != 1 or e.kind != MOMENTUM or not isinstance(e.source, BalanceTrace):
        return None
    formula = results[0].formula
    if formula is None or formula == 0 or not f.free_symbols <= formula.free_symbols:
        return None
    ratio = simplified(formula / f)
    source = replace(
        e.source,
        before=_written(e.source.before, x, f),
        after=_written(e.source.after, x, f),
        amounts=tuple((body, _written(amount, x, f)) for body, amount in e.source.amounts),
    )
    times = {s for s in f.free_symbols if s.name.startswith("t__")}
    left = {s for side in (ratio, source.before, source.after) for s in side.free_symbols} & times
    if left or not times or x not in source.after.free_symbols | source.before.free_symbols:
        return None
    own = replace(results[0], formula=ratio * x)
    return x, replace(step, relations=(replace(e, source=source),), needs=step.needs | {x}, results=(own,))


def _written(expr: sp.Expr, x: sp.Symbol, f: sp.Expr) -> sp.Expr:
    """An expression with the letter in the place of the function, however it is written."""

    def alike(part: sp.Expr) -> bool:
        return bool(part.is_Mul or part.is_Add) and part.free_symbols == f.free_symbols and identically_zero(part - f)

    return sp.sympify(expr).replace(alike, lambda _: x)
