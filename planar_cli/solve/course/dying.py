"""When a motion that dies out passes a place: by its formula, where machine numbers no longer tell.

The sum of the terms of a formula is compared with the sum of their sizes, in decimals that never underflow. So a swing
of e^-100 of the first passes zero as cleanly as the first, and a formula whose terms have one sign never does.
"""

from __future__ import annotations

from decimal import Decimal
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.calculus.first import roots
from planar_cli.equation.exact import Unvalued, Valuation
from planar_cli.solve.course.events import WINDOWS, Leg, State, scale_of
from planar_cli.solve.course.legs import explicit
from planar_cli.solve.course.starts import certain_start
from planar_cli.solve.course.timeline import Stop

if TYPE_CHECKING:
    from planar_cli.solve.course.course import Course

LOOKS, MOST = 8, 4000
"""Zeros whose inequalities do not hold are passed over, so many of them; evaluations that are spent."""


def by_formula(course: Course, stop: Stop, leg: Leg) -> State | None:
    """Where a state with one equation is first reached from a first state that is known exactly; None: never, or no
    formula tells.
    """
    if leg.regime is not course.regimes[0] or course.states[1].name != stop.name:
        return None
    demands = [d for d in course.demands[stop.name] if d.kind in ("equation", "inequality")]
    start = certain_start(course)
    equations = [d for d in demands if d.kind == "equation"]
    if not isinstance(start, dict) or len(equations) != 1 or len(demands) < len(course.demands[stop.name]):
        return None
    general = {own: letter for letter, own in stop.letters.items()}
    value = course.base().extended({course.first.letters[s]: v for s, v in start.items()})
    run = WINDOWS[-1] * scale_of(leg)
    t0 = start[leg.regime.time]
    laws = course.laws[0]
    found = explicit(laws, leg.regime, course.first, value, t0, t0 + Decimal(run))
    exprs = [d.residual.xreplace(general).xreplace(found) for d in demands]
    if any(s not in found for s in leg.regime.letters[1:]):
        return None
    time = leg.regime.time
    if not any(time in a.free_symbols for e in exprs for a in e.atoms(sp.exp, sp.cosh, sp.sinh)):
        return None
    first = demands.index(equations[0])
    g = _Relative(exprs[first], time, value)
    try:
        for n, root in enumerate(roots(g, leg.t0, leg.t0 + run, scale_of(leg), 0.0, MOST)):
            others = [_Relative(e, time, value) for i, e in enumerate(exprs) if i != first]
            if root.kind == "crossing" and all(o(root.value) >= 0 for o in others):
                return _there(leg, found, value.extended({time: Decimal(repr(root.value))}))
            if n >= LOOKS:
                break
    except (ArithmeticError, Unvalued):
        pass
    return None


def _there(leg: Leg, found: dict[sp.Symbol, sp.Expr], value: Valuation) -> State:
    letters = leg.regime.letters
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
