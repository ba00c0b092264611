"""A way in letters that is told without a turn must be without one wherever the letters of the file may lie."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, derivative
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import undecided_at
from planar_cli.problem.language.expression import Quantity
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.regimes.equations import DATA
from planar_cli.solve.regimes.timeline import Stop

LOOKS = 16
"""In so many parts a way is looked at for a turn."""


def demand_one_sense(course: MotionEquations, speed: sp.Expr | None, p: Stop, r: Stop, q: Quantity) -> None:
    """Undecided: with some numbers for its letters what moves turns round between two states, with others it does not.
    `speed`: by the time; None: no formula is known, and nothing is told in letters.
    """
    told = _told(course)
    ends = [e.xreplace(told) for e in (p.t, r.t)]
    if speed is None or not isinstance(ends[1], sp.Expr) or ends[1] == r.t:
        return
    time = course.regimes[0].time
    over = speed.xreplace(told)
    senses = {s for draw in course.scene.everywhere() for s in _senses(over, time, ends, draw)}
    if len(senses) < 2:
        return
    named = ", ".join(s.name for s in by_name((over.free_symbols | ends[1].free_symbols) - {time}))
    text = f"whether it turns round between {p.name} and {r.name}, and so {q.word}(…), depends on {named}"
    raise undecided_at(q.mark, f"{text}, which have no numbers; `assume` tells which is larger")


def _told(course: MotionEquations) -> dict[sp.Symbol, sp.Expr]:
    """The letters of states that data tell one by one."""
    own = {v for s in course.stops.values() for v in s.letters.values()}
    found: dict[sp.Symbol, sp.Expr] = {}
    for e in course.equations:
        inside = e.residual.free_symbols & own
        if e.kind not in DATA or len(inside) != 1:
            continue
        (x,) = inside
        slope = derivative(e.residual, x)
        if slope != 0 and not slope.has(x):
            found.setdefault(x, sp.expand(x - e.residual / slope))
    return found


def _senses(over: sp.Expr, time: sp.Symbol, ends: list[sp.Expr], draw: Valuation) -> set[bool]:
    """In which senses it moves between two times, with these numbers."""
    since, until = (draw.known(e) for e in ends)
    if since is None or until is None:
        return set()
    inside = (draw.extended({time: since + (until - since) * k / LOOKS}).known(over) for k in range(1, LOOKS))
    return {number > 0 for number in inside if number is not None and number != 0}
