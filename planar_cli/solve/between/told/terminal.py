"""The speed at which a drag of c v² balances what drives, as a letter of its own: v_t = √(m g/c).

a = -(g + c v²/m) and a = c v²/m - g are then -g (1 + v²/v_t²) and -g (1 - v²/v_t²), and their integrals are short:
t = v_t arctan(v_0/v_t)/g, h = v_t² ln(1 + v_0²/v_t²)/(2 g), v² = v_t² (1 - exp(-2 g h/v_t²)).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.calculus.spans import Span
from planar_cli.equation.algebra.plain import by_name, derivative, longer, simplified
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteStep, RouteTrace
from planar_cli.solve.law import IN_THE_END, Law

LONGEST = 60
"""Longer formulas are not rewritten."""
LEAST = 2
"""Of fewer relations a letter of its own is no gain."""


def by_terminal_speed(motion: MotionTrace) -> MotionTrace:
    """A motion of numbers with drag by that letter, where several relations rest on it; any other as it is."""
    if motion.symbolic or motion.passing or motion.spans:
        return motion
    laws = [e.law for leg in motion.route.steps for e in leg.relations if e.law is not None and e.span is not None]
    squares = {square: law for law in laws if (square := _square(law, motion)) is not None}
    if len(squares) != 1 or sum(_square(law, motion) is not None for law in laws) < LEAST:
        return motion
    ((square, _),) = squares.items()
    drag = _drag(square, motion)
    if drag is None:
        return motion
    letter, formula = motion.ledger.fresh("v_t", "m/s", positive=True), sp.sqrt(square)
    put = {drag: sp.solve(square - letter**2, drag)[0]}

    def told(expr: sp.Expr) -> sp.Expr:
        if drag not in expr.free_symbols or longer(expr, LONGEST):
            return expr
        return simplified(expr.xreplace(put))

    value = motion.value.extended({letter: motion.value(formula)})
    limit = _limit(motion, formula)
    shares = _shares(motion, formula, limit)
    terminal = letter, formula if limit is None else limit
    route = _route(motion.route, told, terminal, lambda law: _square(law, motion) is not None, shares)
    return replace(motion, value=value, route=route)


def _limit(motion: MotionTrace, formula: sp.Expr) -> sp.Symbol | None:
    """The letter of the speed to which the motion tends in the end, where that is the terminal speed."""
    ends = (leg for leg in motion.route.steps if leg.is_datum and any(e.words == IN_THE_END for e in leg.relations))
    results = [r for leg in ends for r in leg.results if r.formula is not None and len(leg.results) == 1]
    return next((r.unknown for r in results if simplified(r.formula - formula) == 0), None)


def _shares(motion: MotionTrace, formula: sp.Expr, limit: sp.Symbol | None) -> dict[sp.Symbol, sp.Expr]:
    """Speeds of states that the file gives as multiples of it, v = 0.95 √(m g/c), each by its number of times."""
    data = {r.unknown: r.formula for leg in motion.route.steps if leg.is_datum for r in leg.results}
    roots = {s: f for s, f in data.items() if f is not None and f.has(sp.Pow) and s != limit}
    found = {s: simplified(f / formula) for s, f in roots.items()}
    return {s: share for s, share in found.items() if share.is_Rational}


def _square(law: Law, motion: MotionTrace) -> sp.Expr | None:
    """v_t² of a law g_0 + g_2 v² with constants g_0 and g_2; None: it is another law."""
    if (
        law.coordinate.unit != "m"
        or law.order != 2
        or law.factor != 1
        or law.vibration is not None
        or law.constant is not None
    ):
        return None
    v = law.v
    constant, slope = law.f.xreplace({v: sp.S.Zero}), simplified(derivative(law.f, v) / (2 * v))
    if constant == 0 or slope == 0 or (constant.free_symbols | slope.free_symbols) & {*motion.varying, v}:
        return None
    ratio = simplified(constant / slope)
    number = motion.value.known(ratio)
    if number is None or simplified(law.f - constant - slope * v**2) != 0:
        return None
    if number > 0 and any(r.solution.trial.system.laws for r in motion.regimes):
        # What a sliding friction brakes is not driven to a speed that stays.
        return None
    return ratio if number > 0 else simplified(-ratio)


def _drag(square: sp.Expr, motion: MotionTrace) -> sp.Symbol | None:
    """The letter of the file by which v_t² is divided, and which stands in it alone."""
    below = sp.fraction(sp.together(square))[1]
    given = [s for s in by_name(below.free_symbols) if s in motion.ledger.values and s not in motion.unknowns]
    return given[0] if len(given) == 1 and below.as_coeff_Mul()[1] == given[0] and square.is_Mul else None


def _route(
    route: RouteTrace,
    told: Callable[[sp.Expr], sp.Expr],
    terminal: tuple[sp.Symbol, sp.Expr],
    dragged: Callable[[Law], bool],
    shares: Mapping[sp.Symbol, sp.Expr],
) -> RouteTrace:
    by_share = {s: share * terminal[0] for s, share in shares.items()}
    rests_on = {terminal[1]} if terminal[1].is_Symbol else set()

    def relation(e: Relation) -> Relation:
        if e.law is None or e.span is None or not dragged(e.law):
            return e
        return replace(
            e,
            residual=told(e.residual),
            span=_span(e.span, told),
            law=replace(e.law, terminal=(*terminal, told(e.law.f))),
        )

    def result(r: Result) -> Result:
        return r if r.formula is None else replace(r, formula=told(r.formula).xreplace(by_share))

    def rests(leg: RouteStep) -> bool:
        return any(e.law is not None and e.span is not None and dragged(e.law) for e in leg.relations)

    def step(leg: RouteStep) -> RouteStep:
        if leg.is_datum and not by_share.keys().isdisjoint(leg.unknowns):
            multiples = (replace(r, formula=by_share.get(r.unknown, r.formula)) for r in leg.results)
            return replace(leg, results=tuple(multiples), needs=leg.needs | rests_on)
        if not rests(leg):
            return leg
        relations, results = tuple(map(relation, leg.relations)), tuple(map(result, leg.results))
        return replace(leg, relations=relations, results=results, needs=leg.needs | rests_on)

    own = {x for leg in route.steps if rests(leg) for x in leg.unknowns}
    formulas = {s: told(f) if s in own else by_share.get(s, f) for s, f in route.formulas.items()}
    settled = route.settled | {terminal[0]}
    # What a letter rests on stands before it.
    steps = sorted(map(step, route.steps), key=lambda leg: rests_on.isdisjoint(leg.unknowns))
    return replace(route, steps=tuple(steps), formulas=formulas, settled=settled)


def _span(span: Span, told: Callable[[sp.Expr], sp.Expr]) -> Span:
    """A span with its integrals and its formula so."""

    def of(expr: sp.Expr | None) -> sp.Expr | None:
        if not isinstance(expr, sp.Integral):
            return None if expr is None else told(expr)
        return sp.Integral(told(expr.function), *expr.limits)

    residual = told(span.residual)
    return replace(span, left=of(span.left), right=of(span.right), residual=residual, explicit=of(span.explicit))
