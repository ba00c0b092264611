"""Which modes hold at an instant: complementarity over the joints' modes, from the present choice outward.

A choice is consistent when its joints allow the places and velocities, and every guard is positive, or zero and about
not to become negative. What is about to happen is read off a short trial step: a guard that is zero is judged by
whether it grows, of whatever order its first derivative is that does not vanish.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from heapq import heappop, heappush
from itertools import combinations, islice, product

from planar_cli.motion.terms.source import Singular
from planar_cli.motion.trajectory.automaton import Automaton, Choice, Guard, Regime
from planar_cli.records import record

NEAR = 1e-9
"""A guard or a speed below this part of its scale may be zero."""
STILL = 1e-13
"""What changes in a trial step by less than this part of its scale does not change."""
TRIAL = 1e-4
"""The length of a trial step in parts of the time in which the state changes."""
PARTS = (1e-3, 0.03, 1.0, 10.0)
"""Trial steps of these parts of it are taken: what is short may be over before it has ended, and what begins with its
third derivative, as a gap that a slackening spring closes, shows in a longer one only.
"""
SAME = 1e-7
"""Rates that agree to this part of their scale are the same motion."""
PLACES = ("gap", "stretch", "tips", "mass")
"""Kinds of guards that look at places alone."""
MOST_TRIED = 2000
"""So many choices are tried at most."""
MOST_COMPARED = 24
"""So many choices are tried to see whether another motion is consistent too, those that differ in one joint first."""


INFINITE = "a force or a rate has no finite value there, as where it is divided by what is zero"


@record
class Violation:
    """Why a choice does not hold."""

    joint: str
    """The joint; "" where the places or velocities as a whole do not fit."""
    words: str
    """The condition that fails."""
    moving: bool
    """Does it fail by places and velocities as they are, whatever the forces?"""


@record
class Verdict:
    """One choice looked at."""

    choice: Choice
    state: tuple[float, ...]
    """The state, moved onto what this choice demands of places and velocities."""
    moved: float
    """By how much that moved it, in parts of the scale."""
    rates: tuple[float, ...]
    violations: tuple[Violation, ...]
    idle: bool = False
    """Does something that is apart stay where it touches: does nothing but another constraint keep it there?"""


@record
class Chosen:
    """The choice that holds."""

    choice: Choice
    state: tuple[float, ...]
    tried: int
    """How many choices were looked at."""


@record
class NoMode:
    """No choice of modes is consistent: each that was tried, with what fails in it."""

    verdicts: tuple[Verdict, ...]


@record
class SeveralModes:
    """More than one motion is consistent."""

    verdicts: tuple[Verdict, ...]


class Chooser:
    """Looks for the choice that holds at one instant; `tolerance` is that of the motion so far."""

    def __init__(self, automaton: Automaton, t: float, y: Sequence[float], tolerance: float = NEAR) -> None:
        self.automaton, self.t, self.y = automaton, t, tuple(y)
        self.near = max(NEAR, 10 * tolerance)
        self.joints = list(automaton.choices)
        self.counts = [len(modes) for modes in automaton.choices.values()]
        self.seen: dict[Choice, Verdict] = {}

    def choose(self, current: Choice) -> Chosen | NoMode | SeveralModes:
        """From the present choice: first what differs in few joints, then everything."""
        self.automaton.prepare(current, self.t, self.y)
        found = self._first(current)
        if found is None:
            return NoMode(tuple(self.seen.values()))
        rivals = self._rivals(found)
        if len(rivals) > 1:
            return SeveralModes(tuple(rivals))
        best = rivals[0]
        return Chosen(best.choice, best.state, len(self.seen))

    def verdict(self, choice: Choice) -> Verdict:
        """One choice looked at."""
        if choice not in self.seen:
            self.seen[choice] = self._judged(choice)
        return self.seen[choice]

    # --- one choice --------------------------------------------------------------------------------------------------

    def _judged(self, choice: Choice) -> Verdict:
        misfits = {j: x for j, x in self.automaton.misfits(choice, self.t, self.y).items() if x > self.near}
        if misfits:
            found = tuple(Violation(j, "places and velocities allow it", True) for j in misfits)
            return Verdict(choice, self.y, max(misfits.values()), (), found)
        regime, t = self.automaton.regime(choice), self.t
        scale = self.automaton.scale
        state = regime.project(t, self.y)
        moved = max((abs(a - b) / s for a, b, s in zip(state, self.y, scale, strict=True)), default=0.0)
        try:
            rates = regime.rates(t, state)
            values = regime.watch(t, state)
            later = self._later(regime, state, rates, values)
        except Singular:
            failed = Violation("", "its forces are not determined", False)
            return Verdict(choice, tuple(state), moved, (), (failed,))
        except (ZeroDivisionError, ValueError):
            failed = Violation("", INFINITE, False)
            return Verdict(choice, tuple(state), moved, (), (failed,))
        broken = [
            Violation(guard.joint, guard.words, guard.kind in (*PLACES, "slips"))
            for guard, now, changes in zip(regime.guards, values, later, strict=True)
            if not self._holds(guard, now, changes)
        ]
        idle = any(
            guard.kind in PLACES and abs(now) <= self.near * guard.scale and not self._changes(guard, changes)
            for guard, now, changes in zip(regime.guards, values, later, strict=True)
        )
        return Verdict(choice, tuple(state), moved, tuple(rates), tuple(broken), idle)

    def _holds(self, guard: Guard, now: float, changes: Sequence[float]) -> bool:
        size = guard.scale
        if now > self.near * size:
            return True
        if now < -self.near * size or math.isnan(now):
            return False
        change = self._changes(guard, changes)
        return change > 0 or (change == 0 and not guard.strict)

    def _changes(self, guard: Guard, changes: Sequence[float]) -> float:
        """The first change: in the shortest step in which there is one; 0 where there is none."""
        return next((c for c in changes if abs(c) > STILL * guard.scale), 0.0)

    def _later(
        self, regime: Regime, y: Sequence[float], rates: Sequence[float], values: Sequence[float]
    ) -> list[list[float]]:
        """How every guard changes in short steps, the shortest first; nothing where all are far from zero."""
        if all(abs(v) > self.near * g.scale for v, g in zip(values, regime.guards, strict=True)):
            return [[] for _ in values]
        h = trial_step(regime, self.automaton, self.t, y, rates)
        after = [self._after(regime, y, rates, h * part) for part in PARTS]
        return [[row[i] - value for row in after] for i, value in enumerate(values)]

    def _after(self, regime: Regime, y: Sequence[float], rates: Sequence[float], h: float) -> list[float]:
        """The guards after one step of Runge and Kutta."""
        t, k1 = self.t, rates
        k2 = regime.rates(t + h / 2, [a + h / 2 * k for a, k in zip(y, k1, strict=True)])
        k3 = regime.rates(t + h / 2, [a + h / 2 * k for a, k in zip(y, k2, strict=True)])
        k4 = regime.rates(t + h, [a + h * k for a, k in zip(y, k3, strict=True)])
        after = [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4, strict=True)]
        return regime.watch(t + h, after)

    # --- the search --------------------------------------------------------------------------------------------------

    def _first(self, current: Choice) -> Verdict | None:
        """The first consistent choice, changing what fails, where least fails first; then any."""
        waiting, known = [(0, 0, current)], {current}
        while waiting and len(self.seen) < MOST_TRIED:
            verdict = self.verdict(heappop(waiting)[2])
            if not verdict.violations:
                return verdict
            failing = len({v.joint for v in verdict.violations})
            for choice in self._changed(verdict):
                if choice not in known:
                    known.add(choice)
                    heappush(waiting, (failing, len(known), choice))
        for choice in self._all():
            if len(self.seen) >= MOST_TRIED:
                return None
            verdict = self.verdict(choice)
            if not verdict.violations:
                return verdict
        return None

    def _changed(self, verdict: Verdict) -> Iterator[Choice]:
        """The choices with another mode of a joint whose condition fails."""
        failing = {v.joint for v in verdict.violations}
        for i, joint in enumerate(self.joints):
            if joint in failing or "" in failing:
                yield from self._others(verdict.choice, i)

    def _others(self, choice: Choice, i: int) -> Iterator[Choice]:
        for mode in range(self.counts[i]):
            if mode != choice[i]:
                yield (*choice[:i], mode, *choice[i + 1 :])

    def _all(self) -> Iterator[Choice]:
        return product(*(range(n) for n in self.counts))

    def _rivals(self, found: Verdict) -> list[Verdict]:
        """What else is consistent and moves otherwise; rest persists where it can, and sticking goes before slipping.

        From rest a slip begins only where no sticking distribution of the forces exists.
        """
        if not any(g.kind in ("slips", "limit") for g in self.automaton.regime(found.choice).guards):
            return [found]
        open_modes = [
            [found.choice[i], *(c[i] for c in self._others(found.choice, i) if self._may(c))]
            for i in range(len(self.counts))
        ]
        consistent = [found]
        for choice in islice(_few_changes(found.choice, open_modes), MOST_COMPARED):
            verdict = self.verdict(choice)
            if verdict is not found and not verdict.violations and verdict.moved <= max(NEAR, found.moved):
                consistent.append(verdict)
        if not all(v.idle for v in consistent):
            consistent = [v for v in consistent if not v.idle]
        kept = [v for v in consistent if not any(self._sticking(v) < self._sticking(w) for w in consistent)]
        distinct: list[Verdict] = []
        for verdict in kept:
            if not any(self._alike(verdict, other) for other in distinct):
                distinct.append(verdict)
        return distinct

    def _may(self, choice: Choice) -> bool:
        """Do places and velocities allow it, whatever the forces?"""
        return not any(v.moving for v in self.verdict(choice).violations)

    def _sticking(self, verdict: Verdict) -> frozenset[str]:
        modes = zip(self.joints, verdict.choice, strict=True)
        return frozenset(j for j, mode in modes if self.automaton.choices[j][mode].name == "stick")

    def _alike(self, a: Verdict, b: Verdict) -> bool:
        """Do they begin with the same accelerations?"""
        span = self.automaton.time_scale
        pairs = zip(a.rates, b.rates, self.automaton.scale, strict=True)
        return all(abs(p - q) <= SAME * (s / span + abs(p)) for p, q, s in pairs)


def _few_changes(choice: Choice, modes: Sequence[Sequence[int]]) -> Iterator[Choice]:
    """The choices with other modes of these: of one joint, then of two, and so on."""
    several = [i for i, options in enumerate(modes) if len(options) > 1]
    for number in range(1, len(several) + 1):
        for joints in combinations(several, number):
            for others in product(*(modes[i][1:] for i in joints)):
                changed = list(choice)
                for i, mode in zip(joints, others, strict=True):
                    changed[i] = mode
                yield tuple(changed)


def trial_step(regime: Regime, automaton: Automaton, t: float, y: Sequence[float], rates: Sequence[float]) -> float:
    """A step in which the state changes by about 1e-4 of what it is made of."""
    scale, span = automaton.scale, automaton.time_scale
    h = TRIAL * span
    first = max((abs(r) / s for r, s in zip(rates, scale, strict=True)), default=0.0)
    if first * h > TRIAL:
        h = TRIAL / first
    ahead = regime.rates(t + h, [a + h * r for a, r in zip(y, rates, strict=True)])
    second = max((abs(p - r) / s for p, r, s in zip(ahead, rates, scale, strict=True)), default=0.0) / h
    return min(h, TRIAL / second**0.5) if second > 0 else h
