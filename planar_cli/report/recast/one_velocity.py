"""Where two bodies do not rebound they have one velocity after the blow, which has one letter:

No rebound (e = 0): after the blow ram and pile have the same velocity v_P,3.
m_1 v_Q,2 = (m_1 + m_2) v_P,3
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.records import record
from planar_cli.report.momentum.heads_of_blows import RESTITUTION, no_rebound
from planar_cli.solve.between.trace.trace import (
    ImpactEquation,
    MotionTrace,
    Relation,
    Request,
    Result,
    RouteStep,
    RouteTrace,
)
from planar_cli.solve.solved_problem import PartSolution


@record
class _Together:
    """A step that finds the common velocity: its balance, the letter that stays, and the one that goes."""

    step: RouteStep
    bodies: str
    balance: Relation
    kept: sp.Symbol
    other: sp.Symbol


def with_one_velocity(part: PartSolution) -> PartSolution:
    """A part whose motion tells such blows with one letter."""
    motion = part.motion
    for step in motion.route.steps if motion is not None else ():
        if motion is not None and (found := _together(step, motion)) is not None:
            motion = _merged(motion, found)
    return part if motion is part.motion else replace(part, motion=motion)


def _together(step: RouteStep, motion: MotionTrace) -> _Together | None:
    """None: it is no such step, or both letters are needed."""
    if len(step.relations) != len(step.results) or len(step.results) != 2:
        return None
    pair = set(step.unknowns)
    for same, balance in (step.relations, tuple(reversed(step.relations))):
        one, other = same.source, balance.source
        if not isinstance(one, ImpactEquation) or not isinstance(other, ImpactEquation) or other.law != "force":
            continue
        words = RESTITUTION.fullmatch(one.lead or one.words)
        if words is None or not no_rebound(one) or same.residual.free_symbols != pair or not same.residual.is_Add:
            continue
        # Where they count in opposite senses, v_P = -v_Q, one letter would be false of one of them.
        slopes = [sp.diff(same.residual, s) for s in pair]
        if any(abs(slope) != 1 for slope in slopes) or sum(slopes) != 0:
            continue
        needed = _needed(step, motion) & pair
        if len(needed) < 2:
            kept = next(iter(needed), step.unknowns[0])
            return _Together(step, words[1], balance, kept, next(s for s in step.unknowns if s != kept))
    return None


def _needed(step: RouteStep, motion: MotionTrace) -> set[sp.Symbol]:
    """The letters that are asked for by themselves, or from which a motion goes on."""
    asked = {p for r in motion.requests for p in r.parts if p.is_Symbol}
    laws = [e for s in motion.route.steps if s is not step for e in s.relations]
    onward = [s for e in laws if not isinstance(e.source, ImpactEquation) for s in e.residual.free_symbols]
    return {*asked, *onward}


def _merged(motion: MotionTrace, found: _Together) -> MotionTrace:
    put = {found.other: found.kept}
    route = motion.route
    steps = tuple(_step(s, found, put) for s in route.steps)
    formulas = {s: _put(f, put) for s, f in route.formulas.items() if s != found.other}
    formulas[found.kept] = next(r.formula for s in steps for r in s.results if r.unknown == found.kept)
    told = RouteTrace(steps, route.settled, formulas, {**route.plain, **put})
    zeros = {s: sp.S.Zero for s, f in (*route.plain.items(), *route.formulas.items()) if f == 0}
    requests = tuple(_request(r, found, {**zeros, **put}) for r in motion.requests)
    return replace(motion, route=told, requests=requests)


def _step(step: RouteStep, found: _Together, put: Mapping[sp.Symbol, sp.Expr]) -> RouteStep:
    if step is not found.step:
        results = tuple(replace(r, formula=_put(r.formula, put)) for r in step.results)
        needs = frozenset(found.kept if s == found.other else s for s in step.needs)
        return replace(step, results=results, needs=needs)
    source = found.balance.source
    assert isinstance(source, ImpactEquation)
    said = (found.bodies, found.kept, _is_whole(source))
    told = replace(source, left=source.left.xreplace(put), right=source.right.xreplace(put), together=said)
    relation = replace(found.balance, residual=found.balance.residual.xreplace(put), source=told)
    return replace(step, relations=(relation,), unknowns=(found.kept,), results=(_result(step, found),))


def _is_whole(balance: ImpactEquation) -> bool:
    """Has each of these bodies one component of velocity, so that none moves across the common normal?"""
    solution = balance.impact.solution
    motion = None if solution is None else solution.trial.system.motion
    if solution is None or motion is None:
        return False
    # In a blow the velocities after it stand where an instant has accelerations.
    ways = [motion.accelerations[body].linear for body in balance.bodies]
    moving = [{s for part in (w.x, w.y) for s in part.free_symbols if not solution.value.is_zero(s)} for w in ways]
    return all(len(symbols) <= 1 for symbols in moving)


def _result(step: RouteStep, found: _Together) -> Result:
    """The velocity by what was known before."""
    pair = {found.kept, found.other}
    own = next(r for r in step.results if r.formula is None or not r.formula.free_symbols & pair)
    return replace(own, unknown=found.kept)


def _request(request: Request, found: _Together, put: Mapping[sp.Symbol, sp.Expr]) -> Request:
    beside = tuple((s, f.xreplace(put)) for s, f in request.beside)
    return replace(request, parts=tuple(_collected(p, found, put) for p in request.parts), beside=beside)


def _collected(expr: sp.Expr, found: _Together, put: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """With the letter put in, and the energies of both bodies as one: 1/2 (m_1 + m_2) v²."""
    if not expr.is_Add or not expr.has(found.kept, found.other):
        return expr.xreplace({found.other: found.kept})
    terms = sp.Add.make_args(sp.expand(expr.xreplace(put)))
    own = [a for a in terms if a.has(found.kept)]
    return sp.Add(*(a for a in terms if a not in own), sp.factor(sp.Add(*own)))


def _put(formula: sp.Expr | None, put: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    return None if formula is None else formula.xreplace(put)
