"""Choices of modes: which assumption about joints is tried next where one has failed, and what was wrong before."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, letters
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution, Undecided, undecided_at
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import changing
from planar_cli.solve.between.branches.departed import apart
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.diagnosis.motions import as_drawn
from planar_cli.solve.following.gaps import changes_sides
from planar_cli.solve.regimes.mode_sequence import ModeSequence, Workshop, nearest
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

SLACK = Decimal("1e-9")
Far = Mapping[int, frozenset[str]]


@changing
class ModeChoice:
    """The choices of modes that have been tried, and the next one."""

    problem: Problem
    workshop: Workshop
    """Where regimes come from."""
    tried: dict[tuple[str, ...], list[tuple[int, ...]]] = field(default_factory=dict)
    """Choices of modes that failed, by the states up to where they begin."""
    tried_blows: dict[tuple[str, ...], list[tuple[int, ...]]] = field(default_factory=dict)
    """The same of what strikes."""
    why: str = ""
    """What speaks against the first of them."""
    by: float = math.inf
    """A motion that passes its last state later than this is not looked for [s]."""
    lack: NoSolution | None = None
    """What is wrong with the first of them in which no motion passes through the states."""

    def _unblocked(self, course: RegimeSequence) -> ModeSequence | None:
        """Another choice of modes, where in this one the velocities of a stretch contradict each other in every
        position; None: they do not. NoSolution: they do in all choices, or in a state of equilibrium.
        """
        modes = course.modes
        for state, stretch in modes.equilibria:
            if not self.workshop.regime(stretch).moves():
                text = f"the joints contradict what is given of the velocities at {state.name}"
                lack = NoSolution([Diagnostic(state.mark, "PL622", text)])
                raise as_drawn(stretch.span, self.workshop, self.problem) or lack
        blocked = next((i for i, r in enumerate(course.regimes) if not r.moves()), None)
        if blocked is None:
            return None
        other = self._other(modes, blocked, "the joints contradict what is given of the velocities")
        if other is None:
            raise as_drawn(modes.stretch(blocked).span, self.workshop, self.problem) or self._exhausted(modes, blocked)
        return other

    def _agreeing(self, course: RegimeSequence) -> ModeSequence | None:
        """Another choice of modes, where in this one the forces of a stretch contradict each other in every position;
        None: all do, or this one does not.
        """
        wrong = next((i for i, r in enumerate(course.regimes) if r.moved()), None)
        return None if wrong is None else self._other(course.modes, wrong, "the forces contradict each other")

    def _next(self, modes: ModeSequence, i: int, why: str) -> ModeSequence:
        """The same with another choice of modes on stretch i. NoSolution: all have been tried."""
        other = self._other(modes, i, why)
        if other is None:
            raise self._exhausted(modes, i)
        return other

    def _exhausted(self, modes: ModeSequence, i: int) -> NoSolution:
        """All choices of modes for a stretch have been tried."""
        text = f"no assumption about the contacts holds from here on: {self.why}"
        return NoSolution([Diagnostic(modes.states[i].mark, "PL622", text)])

    def _undecided(self, count: int) -> Undecided:
        """So many assumptions have been tried, and none has been found to hold or to be the last."""
        mark = self.problem.find[0].mark if self.problem.find else self.problem.states[0].mark
        text = f"not decided, {count} assumptions about the modes of joints have been tried"
        return undecided_at(
            mark, f"{text}; it may help to ask for less of the motion, or to follow it with `planar simulate`"
        )

    def _other(self, modes: ModeSequence, i: int, why: str) -> ModeSequence | None:
        """The same with another choice of modes on stretch i, those first that differ least from what was before; None:
        all have been tried.
        """
        name = tuple(s.name for s in modes.states[: i + 1])
        failed = self.tried.setdefault(name, [])
        failed.append(modes.stretch(i).choice)
        self.why = self.why or why
        for choice in nearest(modes, i, self.workshop.drawn(modes.stretch(i).span).choices()):
            if choice not in failed and not changes_sides(modes, self.workshop, i, choice):
                return modes.changed(i, choice)
        return None

    def _other_blow(self, course: StatedMotion, i: int, why: str, far: Far) -> ModeSequence | None:
        """The same with other modes of the joints in a blow; None: all have been tried. `far`: impacts whose bodies are
        known to be apart, by stretch.
        """
        name = tuple(s.name for s in course.modes.states[: i + 1])
        failed = self.tried_blows.setdefault(name, [])
        failed.append(course.blows[i].choice)
        self.why = self.why or why
        for choice in course.blows[i].struck.choices():
            if choice not in failed and (i not in far or course.blows[i].fits(choice, far[i])):
                return course.modes.struck(i, choice)
        return None

    def _refuted(self, course: StatedMotion, value: Valuation) -> ModeSequence | None:
        """Other modes of the first blow whose own ones the numbers of a solution refute, or other modes after it; None:
        there is none, or all have been tried.
        """
        for i, blow in course.blows.items():
            stroke = blow.in_solution(value)
            if stroke.objection:
                return self._other_blow(course, i, stroke.objection, {})
            if stroke.misfit:
                return self._other(course.modes, i + 1, stroke.misfit)
        return None

    def _determined(self, course: RegimeSequence, i: int) -> ModeSequence:
        """Another choice of modes, where in this one forces that are needed are not unique."""
        regime = course.regimes[i]
        try:
            regime.general.demand_unique(regime.undetermined)
        except NoSolution as error:
            self.lack = self.lack or error
        other = self._other(course.modes, i, "the forces are not unique")
        if other is None:
            raise self.lack or self._exhausted(course.modes, i)
        return other

    def _elsewhere(self, course: StatedMotion, why: str, far: Far) -> ModeSequence | None:
        """Other modes in a blow, or after one; None: there are no blows, or all have been tried."""
        for i in course.blows:
            other = self._other_blow(course, i, why, far)
            if other is not None:
                return other
        for i in course.blows:
            other = self._other(course.modes, i + 1, why)
            if other is not None:
                self.tried_blows.clear()
                return replace(other, stretches=tuple(replace(s, blow_choice=None) for s in other.stretches))
        return None


def at_a_top(course: RegimeSequence, name: str, value: Valuation) -> bool:
    """Is the last state one of rest in equilibrium, for all of which it tells where it is then? A motion that just
    reaches it takes longer and longer. Where time tells all places, each is reached at its time; and what slows down
    by a root of what is left, as a = -k √v, comes to rest at once.
    """
    if not course.regimes[len(course.states) - 2].free:
        return False
    stop, regime = course.stops[name], course.regimes[len(course.states) - 2]
    own = {s: stop.letters[s] for s in regime.letters if s in stop.letters}
    told = [g for g in apart(regime) if any(value.known(own[s]) is not None for s in g if s in own)]
    rates = {**regime.rates, **regime.accelerations}
    here = [rates[s].xreplace(stop.letters) for g in told for s in g if s in rates]
    numbers = [(value.known(e), e) for e in here]
    sudden = any(
        _is_sudden(p.base, value) for e in here for p in e.atoms(sp.Pow) if p.exp.is_Rational and 0 < p.exp < 1
    )
    return bool(told) and not sudden and all(v is not None and abs(v) <= SLACK * value.size(e) for v, e in numbers)


def _is_sudden(base: sp.Expr, value: Valuation) -> bool:
    """Does what stands under a root come to nought, and not as slowly as a square does?"""
    number = value.known(base)
    slopes = (value.known(derivative(base, s)) for s in letters(base))
    return number is not None and abs(number) <= SLACK and any(v is not None and abs(v) > SLACK for v in slopes)


def assumed(course: RegimeSequence, value: Valuation) -> bool:
    """Do the modes hold in every state? What can not be told there does not speak against them."""
    for name, stop in course.stops.items():
        for watch in course.readers[name].regime.watches:
            here = watch.expr.xreplace(stop.letters)
            number = value.known(here)
            if number is not None and number < -SLACK * value.size(here):
                return False
    return True
