"""How long something takes, t_4 - t_3, is the unknown of its equation, where nothing else rests on the two times: the
times before, from which a clock would have run, are then not needed.

v_3 + a (t_4 - t_3) = 0 -> v_3 + a Δ = 0, Δ being what is asked
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.calculus.spans import Span
from planar_cli.equation.algebra.plain import derivative, identically_zero, longer
from planar_cli.solve.between.told.asked_unknown import solved_for_asked
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Request, RouteStep

LONGEST = 80
"""An equation of more operations is left as it is."""
DATED = ("q(t)", "v(t)")
Put = Mapping[sp.Symbol, sp.Expr]


def by_what_passes(motion: MotionTrace) -> MotionTrace:
    """A motion whose times are told since the state from which one is asked, and without times that nothing needs."""
    times = {own for own, general in motion.general.items() if general == motion.ledger.symbols["t"]}
    for request in motion.requests:
        pair = _elapsed(request, times)
        changed = None if pair is None else _changed(motion, request, *pair)
        if changed is not None:
            motion = changed
    return _without_idle_times(motion, times)


def _elapsed(request: Request, times: Iterable[sp.Symbol]) -> tuple[sp.Symbol, sp.Symbol] | None:
    """The later and the earlier time of which the difference is asked; None: something else is."""
    if len(request.parts) != 1 or request.unit is None or request.beside:
        return None
    inside = request.parts[0].free_symbols
    pairs = ((b, a) for b in inside for a in inside if {a, b} <= set(times) and request.parts[0] == b - a)
    return next(pairs, None)


def _changed(motion: MotionTrace, request: Request, late: sp.Symbol, early: sp.Symbol) -> MotionTrace | None:
    """The motion told so; None: something else rests on the later time, or its equation has no such solution."""
    name, steps = request.find.name, motion.route.steps
    own = next((s for s in steps if s.unknowns == (late,) and len(s.relations) == 1), None)
    holding = [s for s in steps if any(late in e.residual.free_symbols for e in s.relations)]
    if own is None or name in motion.ledger.symbols or motion.passing or motion.route.plain.get(early) is not None:
        return None
    if own.relations[0].kind not in DATED or _is_asked(motion, request, late):
        return None
    if not all(_only_passes(e, late, early) for s in holding for e in s.relations):
        return None
    asked = sp.Symbol(name, real=True)
    put: Put = {late: asked, early: sp.S.Zero}
    value = motion.value.extended({asked: motion.value(request.parts[0])})
    result = solved_for_asked(
        own.relations[0].residual.xreplace({**motion.route.plain, **put}), asked, value, motion.symbolic
    )
    if result is None:
        return None
    assert request.unit is not None
    motion.ledger.adopt(asked, request.unit, motion.ledger.roles[late])
    first = RouteStep(_put(own, put), (asked,), own.needs - {early}, (result,), False)
    told = tuple(first if s is own else _later(s, put) if s in holding else s for s in steps)
    formulas = {**{s: f for s, f in motion.route.formulas.items() if s != late}, asked: result.formula}
    settled = motion.route.settled | ({asked} if late in motion.route.settled else frozenset())
    return replace(
        motion,
        value=value,
        unknowns=motion.unknowns | {asked},
        general={**motion.general, asked: motion.general[late]},
        route=replace(motion.route, steps=told, settled=settled, formulas=formulas),
        requests=tuple(replace(r, parts=(asked,)) if r is request else r for r in motion.requests),
        named={**motion.named, asked: request.parts[0]},
    )


def _only_passes(e: Relation, late: sp.Symbol, early: sp.Symbol) -> bool:
    """Does an equation hold two times only by their difference?"""
    if longer(e.residual, LONGEST) or e.source is not None or (e.law is not None and e.law.vibration is not None):
        return False
    apart = sp.Dummy(real=True)
    return identically_zero(derivative(e.residual.xreplace({early: late - apart}), late))


def _is_asked(motion: MotionTrace, request: Request, time: sp.Symbol) -> bool:
    """Does anything that is asked rest on a time, but that one request?"""
    others = [e for r in motion.requests if r is not request for e in (*r.parts, *(f for _, f in r.beside))]
    others += [s.formula for s in motion.spans if s.formula is not None]
    others += [limit for s in motion.spans for piece in s.pieces for limit in piece.limits]
    return any(time in e.free_symbols for e in others)


def _put(step: RouteStep, put: Put) -> tuple[Relation, ...]:
    return tuple(replace(e, residual=e.residual.xreplace(dict(put)), span=_span(e.span, put)) for e in step.relations)


def _span(span: Span | None, put: Put) -> Span | None:
    if span is None:
        return None

    def of(expr: sp.Expr | None) -> sp.Expr | None:
        return None if expr is None else expr.xreplace(dict(put))

    where = tuple(e.xreplace(dict(put)) for e in span.where)
    residual = span.residual.xreplace(dict(put))
    return replace(
        span, left=of(span.left), right=of(span.right), explicit=of(span.explicit), residual=residual, where=where
    )


def _later(step: RouteStep, put: Put) -> RouteStep:
    """A step after that, in which the time is known."""
    results = tuple(r if r.formula is None else replace(r, formula=r.formula.xreplace(dict(put))) for r in step.results)
    needs = frozenset(s for x in step.needs for s in sp.sympify(put.get(x, x)).free_symbols)
    return replace(step, relations=_put(step, put), needs=needs, results=results)


def _without_idle_times(motion: MotionTrace, times: Iterable[sp.Symbol]) -> MotionTrace:
    """Without steps that give times on which no number rests: where t_4 - t_3 goes when two equations are solved
    together, t_3 is not needed.
    """
    steps, every = list(motion.route.steps), set(times)
    asked = {s for r in motion.requests for e in (*r.parts, *(f for _, f in r.beside)) for s in e.free_symbols}
    asked |= {s for span in motion.spans for piece in span.pieces if piece.how != "blow" for s in piece.limits}
    asked |= {s for route in motion.passing.values() for step in route.steps for s in step.needs}
    while idle := [s for s in steps if set(s.unknowns) <= every - asked - _seen(steps, s, every - asked)]:
        steps = [s for s in steps if s not in idle]
    return replace(motion, route=replace(motion.route, steps=tuple(steps)))


def _seen(steps: Iterable[RouteStep], own: RouteStep, spare: Collection[sp.Symbol]) -> set[sp.Symbol]:
    """Letters whose numbers other steps show. `spare`: times that are not asked, which a step may find beside."""
    found: set[sp.Symbol] = set()
    for step in (s for s in steps if s is not own):
        beside = len(step.unknowns) > 1
        for r in step.results:
            if beside and r.unknown in spare and not _rests(steps, step, r.unknown):
                continue
            if r.formula is None or not beside:
                found |= step.needs | {s for e in step.relations for s in e.residual.free_symbols}
            else:
                found |= r.formula.free_symbols
    return found


def _rests(steps: Iterable[RouteStep], own: RouteStep, letter: sp.Symbol) -> bool:
    return any(letter in e.residual.free_symbols for s in steps if s is not own for e in s.relations)
