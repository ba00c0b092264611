"""Positions of states that no motion leads to in numbers: carried over from the position that was drawn.

Where nothing tells the speeds, a state is its position relations and the loops. What a relation is off at the state
before shrinks to nothing in small steps, and the position follows: so it stays on the branch that was drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.exact import Unvalued, Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.solve.linear import solve

if TYPE_CHECKING:
    from planar_cli.solve.course.course import Course

STEPS, SMALLEST, NEWTON = 64, Decimal("1e-5"), 12
CLOSE = Decimal("1e-25")
FAR = Decimal("0.3")
"""A position may move by so much, in radians or of the size of the scene, in one step."""


def carried(course: Course) -> dict[sp.Symbol, float]:
    """The coordinates of all states whose relations about places fix them. NoSolution: the way there is blocked by a
    position in which the linkage may branch.
    """
    regime = course.regimes[0]
    symbols = [c.symbol for c in regime.coordinates]
    first = course.first
    own = [first.letters[q] for q in symbols]
    starts = [e.residual for e in course.equations if e.stop == first.name and e.kind == "drawn"]
    at = {x: Decimal(0) for x in own}
    for residual in starts:
        for x in residual.free_symbols & set(own):
            at[x] = course.base()(x - residual)
    found = {x: float(v) for x, v in at.items()}
    for state in course.states:
        letters = course.stops[state.name].letters
        now = [letters[q] for q in symbols]
        before = dict(zip(now, at.values(), strict=True))
        inside = set(now) | set(own)
        stated = [e for e in course.equations if e.stop == state.name and e.residual.free_symbols & set(now)]
        known = course.base().extended(dict(zip(own, map(Decimal, map(repr, (found[x] for x in own))), strict=True)))
        fixed = [e for e in stated if e.residual.free_symbols - set(known.values) <= inside]
        loops = [e.residual for e in fixed if e.kind == "loop"]
        goals = [e.residual for e in fixed if e.kind in ("given", "drawn")]
        if not goals:
            return {}
        reached = _Carrier(known, loops, goals, now).run(before)
        if reached is None:
            text = f"state {state.name}: the drawn position cannot be led there; on the way the linkage may branch or lock"
            hint = "draw the points at this state, or give the motion that leads to it"
            raise NoSolution([Diagnostic(state.mark, "PL620", text, hint)])
        at = dict(zip(own, (reached[x] for x in now), strict=True))
        found |= {x: float(v) for x, v in reached.items()}
    return found
