"""When a motion passes a place, by its formula: where it dies out, and where its accelerations are constant, so that
touching a place, or just missing it, is told exactly.

The sum of the terms of a formula is compared with the sum of their sizes, in decimals that never underflow. So a swing
of e^-100 of the first passes zero as cleanly as the first, and a formula whose terms have one sign never does.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.calculus.first import roots
from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import NoValue, Undecided
from planar_cli.solve.between.branches.exact_segments import explicit
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.events import FollowedSegment, State, scale_of
from planar_cli.solve.following.starts import certain_start
from planar_cli.solve.instant.roots import real_roots
from planar_cli.solve.regimes.timeline import Stop

SAME = Decimal("1e-13")
LONGEST = 2000.0
"""For so many characteristic times a state is looked for."""
LOOKS, MOST = 8, 4000
"""Zeros whose inequalities do not hold are passed over, so many of them; evaluations that are spent."""


def by_formula(course: MotionEquations, stop: Stop, segment: FollowedSegment) -> State | None:
    """Where a state with one equation is first reached from a first state that is known exactly; None: never, or no
    formula tells.
    """
    if segment.regime is not course.regimes[0] or course.states[1].name != stop.name:
        return None
    demands = [d for d in course.demands[stop.name] if d.kind in ("equation", "inequality")]
    start = certain_start(course)
    equations = [d for d in demands if d.kind == "equation"]
    if not isinstance(start, dict) or len(equations) != 1 or len(demands) < len(course.demands[stop.name]):
        return None
    general = {own: letter for letter, own in stop.letters.items()}
    value = course.base().extended({course.first.letters[s]: v for s, v in start.items()})
    run = LONGEST * scale_of(segment)
    t0 = start[segment.regime.time]
    laws = course.laws[0]
    found = explicit(laws, segment.regime, course.first, value, t0, t0 + Decimal(run))
    exprs = [d.residual.xreplace(general).xreplace(found) for d in demands]
    if any(s not in found for s in segment.regime.letters[1:]):
        return None
    time = segment.regime.time
    if not any(time in a.free_symbols for e in exprs for a in e.atoms(sp.exp, sp.cosh, sp.sinh)):
        return None
    first = demands.index(equations[0])
    g = _Relative(exprs[first], time, value)
    try:
        for n, root in enumerate(roots(g, segment.t0, segment.t0 + run, scale_of(segment), 0.0, MOST)):
            others = [_Relative(e, time, value) for i, e in enumerate(exprs) if i != first]
            if root.kind == "crossing" and all(o(root.value) >= 0 for o in others):
                return _there(segment, found, value.extended({time: Decimal(repr(root.value))}))
            if n >= LOOKS:
                break
    except (NoValue, Unvalued):
        pass
    return None


def _there(segment: FollowedSegment, found: dict[sp.Symbol, sp.Expr], value: Valuation) -> State:
    letters = segment.regime.letters
    return {s: float(value(found[s])) if s in found else float(value(s)) for s in letters}


class _Relative:
    """A formula in time by the size of its terms."""

    def __init__(self, expr: sp.Expr, time: sp.Symbol, value: Valuation) -> None:
        self.terms = sp.Add.make_args(sp.expand(expr))
        self.time, self.value = time, value

    def __call__(self, t: float) -> float:
        here = self.value.extended({self.time: Decimal(repr(t))})
        parts = [here(term) for term in self.terms]
        size = sum((abs(p) for p in parts), Decimal(0))
        return float(sum(parts, Decimal(0)) / size) if size else 0.0


# --- constant accelerations ------------------------------------------------------------------------------------------


def steady_time(course: MotionEquations, stop: Stop, segment: FollowedSegment) -> tuple[State | None] | None:
    """Where a state with one equation is next reached, or (None,): never; exactly, from constant accelerations and a
    first state that is known. None: it is not such a motion.
    """
    index = next(i for i, s in enumerate(course.states) if s.name == stop.name)
    demands = course.demands[stop.name]
    equations = [d for d in demands if d.kind == "equation" and d.trend is None]
    limits = [d for d in demands if d.kind == "inequality"]
    if len(equations) != 1 or len(demands) != 1 + len(limits) or course.modes.turnings:
        return None
    if any(i < index for i in course.blows):
        return None
    if any(r is not segment.regime for r in course.regimes[:index]) or not is_steady(segment):
        return None
    start = certain_start(course)
    if not isinstance(start, dict):
        return None
    value = course.base().extended({course.first.letters[s]: v for s, v in start.items()})
    found = _steady_formulas(segment, course.first)
    time = segment.regime.time
    general = {own: letter for letter, own in stop.letters.items()}
    exprs = [sp.expand(d.residual.xreplace(general).xreplace(found)) for d in (*equations, *limits)]
    if time not in exprs[0].free_symbols or not exprs[0].is_polynomial(time):
        return None
    after = Decimal(repr(segment.t0))
    try:
        for root in real_roots(exprs[0], time, value, False, False):
            later = root.value - after > SAME * max(abs(after), Decimal(repr(scale_of(segment))) * SAME)
            here = value.extended({time: root.value})
            if later and all(here(e) >= 0 for e in exprs[1:]):
                return (_there(segment, found, here),)
    except (NoValue, Unvalued, Undecided):
        return None
    return (None,)


def is_steady(segment: FollowedSegment) -> bool:
    """Are all accelerations constant, so that velocities and places are powers of the time?"""
    regime = segment.regime
    letters, free = set(regime.letters), set(regime.free)
    if regime.general.constraints or not free:
        return False
    if any(f.free_symbols & letters for f in regime.accelerations.values()):
        return False
    return all(
        r.free_symbols & letters <= free and all(not derivative(r, u).free_symbols & letters for u in free)
        for r in regime.rates.values()
    )


def _steady_formulas(segment: FollowedSegment, first: Stop) -> dict[sp.Symbol, sp.Expr]:
    """Speeds and places in time and the letters of the first state."""
    regime = segment.regime
    run = regime.time - first.letters[regime.time]
    found = {u: first.letters[u] + a * run for u, a in regime.accelerations.items()}
    half = {u: first.letters[u] + a * run / 2 for u, a in regime.accelerations.items()}
    for q, rate in regime.rates.items():
        found[q] = first.letters[q] + rate.xreplace(half) * run
    return found
