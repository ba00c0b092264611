"""Constants that are sought, but act only later: the motion up to there is followed in numbers and known.

What comes after it is solved with these numbers: the impulse that makes an orbit round at the place where it is
farthest, the brake that is put on when a car has coasted against drag.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Unvalued
from planar_cli.solve.course.chain import Branch
from planar_cli.solve.course.course import Course
from planar_cli.solve.course.equations import Equation
from planar_cli.solve.course.idle import ONLY_TIMES
from planar_cli.solve.course.newton import refined_left
from planar_cli.solve.course.simulate import Follower
from planar_cli.solve.course.starts import told_start

FOLLOWED = Decimal("1e-9")
"""To so many digits equations hold with numbers that a step method gave."""


@dataclass(frozen=True, slots=True)
class KnownPart:
    """What was followed: the letters it tells, exactly as far as its equations do, `guessed` by the numbers alone."""

    branch: Branch
    guessed: frozenset[sp.Symbol]

    def branches(self, course: Course) -> list[Branch]:
        """All branches of what comes after it."""
        known = self.branch.values
        chain = course.chain()
        rest = [e for e in course.equations if (e.residual.free_symbols & chain.unknowns) - set(known)]
        chain = replace(chain, value=course.base().extended(known), agrees=FOLLOWED)
        steps = self.branch.steps
        formulas = self.branch.formulas
        return [
            replace(b, steps=(*steps, *b.steps), formulas={**formulas, **b.formulas})
            for b in course.ranked(chain.branches(rest))
        ]


def after_known_part(course: Course, found: list[Branch]) -> tuple[list[Branch], frozenset[sp.Symbol]]:
    """Branches that are `found`; where all leave something open, those that rest on numbers of the first part."""
    known = _known_part(course) if all(b.left for b in found) else None
    return (found, frozenset()) if known is None else (known.branches(course), known.guessed)


def _known_part(course: Course) -> KnownPart | None:
    """None: the start is not told, or what is sought acts from there."""
    start = told_start(course)
    until = _untouched(course)
    if start is None or not until:
        return None
    try:
        follower = Follower(course, course.base(), until)
        followed = follower.run({s: float(v) for s, v in start.items()})
    except (ArithmeticError, Unvalued):
        return None
    names = [s.name for s in course.states[: until + 1]]
    letters = {own for name in names for own in course.stops[name].letters.values()}
    if followed.missed or followed.ends or followed.blow is not None or followed.misfit is not None:
        return None
    if not letters <= set(followed.values):
        return None
    return _exact(course, letters, followed.values)


def _untouched(course: Course) -> int:
    """How many stretches pass before anything that is sought acts or is stated."""
    sought = set(course.sought())
    for i, regime in enumerate(course.regimes[: len(course.states) - 1]):
        blow = course.blows.get(i)
        inside = [e.residual for e in blow.equations] if blow is not None else []
        if blow is None:
            inside = [*regime.rates.values(), *regime.accelerations.values(), *(w.expr for w in regime.watches)]
        inside += [d.residual for d in course.demands[course.states[i + 1].name]]
        open_names = blow.scene.open_names if blow is not None else {}
        if open_names or any(e.free_symbols & sought for e in inside):
            return i
    return len(course.states) - 1


def _exact(course: Course, letters: set[sp.Symbol], truth: Mapping[sp.Symbol, float]) -> KnownPart:
    """The numbers, to all digits where the equations of this part give them."""
    chain = course.chain()
    own = [e for e in course.equations if _within(e, letters, chain.unknowns) and e.kind not in ONLY_TIMES]
    chain.truth = {s: truth[s] for s in letters}
    branch = next(iter(chain.branches(own)), Branch({}, {}, (), ()))
    left = [s for s in letters if s not in branch.values]
    more = refined_left(course, branch, left, truth)
    guessed = frozenset(s for s in left if s not in more)
    values = {**branch.values, **more, **{s: Decimal(repr(truth[s])) for s in guessed}}
    return KnownPart(replace(branch, values=values, left=()), guessed)


def _within(equation: Equation, letters: set[sp.Symbol], unknowns: frozenset[sp.Symbol]) -> bool:
    return bool(equation.residual.free_symbols & unknowns <= letters)
