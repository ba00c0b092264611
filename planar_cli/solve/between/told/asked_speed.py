"""The speed that is asked is the unknown of balances of momenta, not a turning from which it follows: v, not ω = v/r.

ω -> v/r, where nothing else that is told rests on ω.  m r ω -> m v,  I ω -> I v/r
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind, Role
from planar_cli.records import record
from planar_cli.solve.between.told.asked_unknown import is_used, relation_in
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Request, Result, RouteStep


@record
class _Change:
    """What is asked, in the place of the letter of a state: letter = asked/factor."""

    request: Request
    step: RouteStep
    letter: sp.Symbol
    asked: sp.Symbol
    factor: sp.Expr

    def put(self, expr: sp.Expr) -> sp.Expr:
        """An expression in what is asked."""
        found = sp.sympify(expr)
        return simplified(found.xreplace({self.letter: self.asked / self.factor})) if found.has(self.letter) else found


def by_the_speed_asked(motion: MotionTrace) -> MotionTrace:
    """A motion whose balances of momenta are solved for the speed that is asked, where that is a multiple of theirs."""
    for request in motion.requests:
        change = next(_changes(motion, request), None)
        if change is not None:
            motion = _changed(motion, change)
    return motion


def _changes(motion: MotionTrace, request: Request) -> Iterator[_Change]:
    name = request.find.name
    if len(request.parts) != 1 or request.unit is None or request.beside or name in motion.ledger.symbols:
        return
    expr = request.parts[0].xreplace(dict(motion.route.plain))
    for step in motion.route.steps:
        for letter in step.unknowns if _of_momenta(step) else ():
            factor = sp.cancel(expr / letter) if letter in expr.free_symbols else sp.S.Zero
            data = factor.free_symbols
            if not data or letter in data or data & motion.unknowns or is_used(motion, request, step, letter):
                continue
            if motion.value(factor) > 0:
                yield _Change(request, step, letter, sp.Symbol(name, real=True), factor)


def _of_momenta(step: RouteStep) -> bool:
    """Are they several balances of momenta, from rest, that are solved together?"""
    sources = [e.source for e in step.relations]
    if len(sources) < 2 or not all(isinstance(b, BalanceTrace) and not b.law.letter for b in sources):
        return False
    return all(r.formula is not None for r in step.results)


def _changed(motion: MotionTrace, change: _Change) -> MotionTrace:
    """The motion told so."""
    ledger, unit = motion.ledger, change.request.unit
    assert unit is not None
    ledger.adopt(change.asked, unit, Role(Kind.SOUGHT))
    value = motion.value.extended({change.asked: motion.value(change.request.parts[0])})
    results = tuple(_result(r, change, value) for r in change.step.results)
    step = replace(
        change.step,
        relations=tuple(relation_in(e, change.put) for e in change.step.relations),
        unknowns=tuple(change.asked if x == change.letter else x for x in change.step.unknowns),
        results=results,
    )
    own = next(r for r in results if r.unknown == change.asked)
    request = replace(change.request, parts=(change.asked,))
    settled = motion.route.settled | ({change.asked} if change.letter in motion.route.settled else frozenset())
    formulas = {**motion.route.formulas, change.asked: own.formula}
    steps = tuple(step if s is change.step else s for s in motion.route.steps)
    return replace(
        motion,
        value=value,
        unknowns=motion.unknowns | {change.asked},
        route=replace(motion.route, steps=steps, settled=settled, formulas=formulas),
        requests=tuple(request if r is change.request else r for r in motion.requests),
        named={**motion.named, change.asked: change.request.parts[0]},
    )


def _result(r: Result, change: _Change, value: Valuation) -> Result:
    assert r.formula is not None
    if r.unknown != change.letter:
        return replace(r, formula=change.put(r.formula))
    size = change.factor * r.formula
    return Result(change.asked, simplified(change.put(size)), value(change.asked))
