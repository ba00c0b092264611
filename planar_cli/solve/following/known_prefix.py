"""Constants that are sought, but act only later: the motion up to there is followed in numbers and known.

What comes after it is solved with these numbers: the impulse that makes an orbit round at the place where it is
farthest, the brake that is put on when a car has coasted against drag.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import by_name
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue
from planar_cli.records import record
from planar_cli.solve.between.branches.branch_order import ranked
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.needed_times import ONLY_TIMES
from planar_cli.solve.between.equations.newton import refined_left
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.following.follower import Follower
from planar_cli.solve.following.starts import told_start
from planar_cli.solve.regimes.equations import Equation

FOLLOWED = Decimal("1e-9")
"""To so many digits equations hold with numbers that a step method gave."""


@record
class KnownPrefix:
    """What was followed: the letters it tells, exactly as far as its equations do, `guessed` by the numbers alone."""

    branch: Branch
    guessed: frozenset[sp.Symbol]

    def branches(self, course: MotionEquations) -> list[Branch]:
        """All branches of what comes after it."""
        known = self.branch.values
        chain = course.chain()
        chain = replace(chain, value=course.base().extended(known), agrees=FOLLOWED)
        steps = self.branch.steps
        formulas = self.branch.formulas
        return [
            replace(b, steps=(*steps, *b.steps), formulas={**formulas, **b.formulas})
            for b in ranked(course, chain.branches(course.equations))
        ]


@record
class Beginning:
    """The motion up to where something that is sought acts, followed over so many stretches."""

    followed: Followed
    stretches: int

    def after(self, course: MotionEquations, found: list[Branch]) -> tuple[list[Branch], frozenset[sp.Symbol]]:
        """Branches that are `found`; where all leave something open, those that rest on the numbers of this part, with
        the letters that are told by them alone.
        """
        names = [s.name for s in course.states[: self.stretches + 1]] if self.stretches else []
        letters = {own for name in names for own in course.stops[name].letters.values()}
        if not letters or not letters <= set(self.followed.values) or not all(b.left for b in found):
            return found, frozenset()
        known = _exact(course, letters, self.followed.values)
        return known.branches(course), known.guessed


def beginning(course: MotionEquations) -> Beginning:
    """Nothing is followed where the start is not told, or what is sought acts from there."""
    start, nothing = told_start(course), Beginning(Followed(), 0)
    if start is None:
        return nothing
    wrong = _wrong_at_once(course, start)
    stretches = _untouched(course)
    if wrong:
        return Beginning(Followed(misfit=0, why=wrong), 0)
    if not stretches:
        return nothing
    try:
        followed = Follower(course, course.base(), stretches).run({s: float(v) for s, v in start.items()})
    except (NoValue, Unvalued):
        return nothing
    return Beginning(followed, stretches)


def _wrong_at_once(course: StatedMotion, start: Mapping[sp.Symbol, Decimal]) -> str:
    """The test of an assumption that fails at the start, whatever the constants that are sought."""
    value = course.base().extended(dict(start))
    for watch in course.regimes[0].watches:
        expr = watch.expr
        number = None if expr.free_symbols & set(course.sought()) else value.known(expr)
        if number is not None and number < -FOLLOWED * value.size(expr):
            return watch.test.words
    return ""


def _untouched(course: StatedMotion) -> int:
    """How many stretches pass before anything that is sought acts or is stated, or a state speaks of a later one."""
    sought = set(course.sought())
    letters = [{stop.t, *stop.letters.values()} for stop in (course.stops[s.name] for s in course.states)]
    for i, regime in enumerate(course.regimes[: len(course.states) - 1]):
        blow = course.blows.get(i)
        inside = [e.residual for e in blow.equations] if blow is not None else []
        if blow is None:
            inside = [*regime.rates.values(), *regime.accelerations.values(), *(w.expr for w in regime.watches)]
        inside += [d.residual for d in course.demands[course.states[i + 1].name]]
        later = {x for own in letters[i + 2 :] for x in own}
        if any(e.free_symbols & later for e in inside):
            return i
        open_names = blow.scene.open_names if blow is not None else {}
        if open_names or any(e.free_symbols & sought for e in inside):
            return i
    return len(course.states) - 1


def _exact(course: MotionEquations, letters: set[sp.Symbol], truth: Mapping[sp.Symbol, float]) -> KnownPrefix:
    """The numbers, to all digits where the equations of this part give them."""
    chain = course.chain()
    own = [e for e in course.equations if _within(e, letters, chain.unknowns) and e.kind not in ONLY_TIMES]
    chain = replace(chain, truth={s: truth[s] for s in by_name(letters)})
    branch = next(iter(chain.branches(own)), Branch({}, {}, (), ()))
    left = [s for s in by_name(letters) if s not in branch.values]
    more = refined_left(course, branch, left, truth)
    guessed = frozenset(s for s in left if s not in more)
    values = {**branch.values, **more, **{s: Decimal(repr(truth[s])) for s in by_name(guessed)}}
    return KnownPrefix(replace(branch, values=values, left=()), guessed)


def _within(equation: Equation, letters: set[sp.Symbol], unknowns: frozenset[sp.Symbol]) -> bool:
    return bool(equation.residual.free_symbols & unknowns <= letters)
