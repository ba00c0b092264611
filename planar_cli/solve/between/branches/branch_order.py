"""Which of several branches of a motion goes first."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from decimal import Context, Decimal
from typing import Any

from planar_cli.problem.implied.not_negative import not_negative
from planar_cli.solve.between.branches.determined_part import determined_part
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.chain import Branch

SLACK = Decimal("1e-18")
"""A bend that is smaller than this part of its terms tells nothing."""
ROUGHLY, TIES = Context(prec=30), Context(prec=12)
"""To so many digits times, and what is largest, are compared."""


def candidates(course: MotionEquations) -> list[Branch]:
    """All branches of the equations that are possible, those whose states come first in front."""
    told = determined_part(course)
    open_ones = tuple(e for e in course.equations if e not in told)
    found = [replace(b, left=(*b.left, *open_ones)) for b in course.chain().branches(told)]
    return ranked(course, [b for b in found if _is_extreme(course, b)])


def _is_extreme(course: MotionEquations, branch: Branch) -> bool:
    """Is what is to be largest not smallest there, and the other way round, as far as its bend tells?"""
    value = course.base().extended(branch.values)
    bends = [(e.trend, value.known(e.trend)) for e in course.equations if e.kind == "extreme" and e.trend is not None]
    return all(number is None or number >= -SLACK * value.size(bend) for bend, number in bends)


def ranked(course: StatedMotion, branches: Iterable[Branch]) -> list[Branch]:
    """Those that leave no equation open, if there are any; of these first the largest where that is asked, the
    earliest, and those with positive sought constants. Friction, sizes and masses can not be negative.
    """
    positive, every = not_negative(course.problem), list(branches)
    limits = [s for s in course.sought() if s.name in positive]
    found = [b for b in every if all(b.values.get(s, Decimal(0)) >= 0 for s in limits)]
    # That none is positive for a draw of letters says nothing of other letters.
    found = found or (every if course.problem.symbols else [])
    return sorted([b for b in found if not b.left] or found, key=lambda b: _rank(course, b))


def _rank(course: StatedMotion, branch: Branch) -> tuple[Any, ...]:
    keys: list[Any] = []
    for state in course.states:
        stop = course.stops[state.name]
        for d in course.demands[state.name]:
            if d.kind == "extreme":
                v = course.base().extended(branch.values).known(stop.at(d.residual))
                keys.append(-TIES.plus((v or Decimal(0)) * d.extreme))
        when = ROUGHLY.plus(branch.values.get(stop.t, Decimal(0)))
        # A motion begins at a time that is not negative, where it may.
        keys += [when < 0, when] if state is course.states[0] else [when]
    below = [s for s in course.sought() if branch.values.get(s, Decimal(0)) < 0]
    negative = sum(not course.ledger.units[s].angle for s in below)
    return (negative if course.blows else 0, *keys, negative, len(below))
