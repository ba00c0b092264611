"""One stretch of a motion that was followed in numbers, and the instants at which a function vanishes along it."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from decimal import Decimal
from itertools import pairwise
from typing import Protocol

import sympy as sp

from planar_cli.calculus.first import Root, roots
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.scales import SLACK
from planar_cli.errors import NotReached, NoValue
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.records import changing
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.units import RATE

NOTICEABLE = 0.1
LOOKS, NEARBY, DEAD = 8, 0.01, 1e-12
"""A function is looked at so often before a zero, and so near to it; below this part of its size it has died out."""
NEAR = 1e-7
"""A relation counts as fulfilled below this part of what it was nearby."""
WITHIN = 3
"""A step is looked at so often."""
State = dict[sp.Symbol, float]


class Read(Protocol):
    """Who reads the letters of a regime from a state of the scene."""

    def recall(self, t: float) -> None:
        """Angles count their turns from what they were before a time."""

    def at(self, t: float, y: Sequence[float], near: State) -> State:
        """The letters, sought from those that are near."""


@changing
class FollowedSegment:
    """One stretch in numbers: from t0 to t1 [s]."""

    regime: Regime
    letters: Read
    """Reads its letters."""
    pieces: Sequence[Segment]
    """What was followed from t0 on, also beyond t1."""
    t0: float
    t1: float
    start: State
    value: Valuation
    """Numbers of what does not vary."""
    length: float = 1.0
    """What counts as a large length in it [m]."""
    pace: float = 1.0
    """An ordinary time of the scene [s]."""
    reaches: str = ""
    """The state that ends it; "" where none does."""
    _known: list[tuple[float, State]] = field(default_factory=list)
    """Letters at the ends of steps, as far as they were looked at."""
    _passed: list[tuple[float, Sequence[float]]] | None = None
    """The ends of all steps, once they were looked at."""

    def at(self, t: float) -> State:
        """All letters at a time. NoValue: it was not followed so far."""
        if not self.regime.letters[1:]:
            return {**self.start, self.regime.time: t}
        if t <= self.t0:
            return self.start
        ends = self._ends()
        while len(self._known) < len(ends) and ends[len(self._known)][0] < t:
            step, y = ends[len(self._known)]
            self._known.append((step, self._read(step, y)))
        near = bisect_right(self._known, t, key=lambda known: known[0])
        return self._read(t, self._state(t), self._known[near - 1][1] if near else self.start)

    def _read(self, t: float, y: Sequence[float], near: State | None = None) -> State:
        near = near if near is not None else self._known[-1][1] if self._known else self.start
        return {**self.start, **self.letters.at(t, y, near)}

    def _ends(self) -> list[tuple[float, Sequence[float]]]:
        """The ends of the steps after t0, with the state there."""
        if self._passed is None:
            every: list[tuple[float, Sequence[float]]]
            every = [(step.t1, step.y1) for piece in self.pieces for step in piece.steps if step.t1 < piece.t1]
            every += [(piece.t1, piece.end) for piece in self.pieces]
            self._passed = sorted((e for e in every if e[0] > self.t0), key=lambda e: e[0])
        return self._passed

    def _state(self, t: float) -> Sequence[float]:
        """The state of the scene at a time."""
        self.letters.recall(t)
        for piece in self.pieces:
            if piece.t0 <= t <= piece.t1:
                return piece.at(t)
        last = self.pieces[-1].t1 if self.pieces else math.inf
        if last <= t <= last + NEARBY * NEAR * abs(last - self.t0):
            # A later time that is the same but for rounding.
            return self.pieces[-1].end
        raise NoValue(f"the motion is not followed to t = {t:.9g} s")

    def ends(self) -> list[float]:
        """The times up to t1 at which steps end."""
        return [t for t, _ in self._ends() if t <= self.t1]

    def rates(self) -> list[float]:
        """How fast the letters but the time change at the beginning."""
        regime = self.regime
        exprs = [*regime.rates.values(), *regime.accelerations.values()]
        return number_function(exprs, regime.letters, self.value)(*(self.start[s] for s in regime.letters))

    def looks(self, until: float) -> list[float]:
        """Times from t0 to another that lie close to each other beside what happens."""
        points = [self.t0, *(t for t, _ in self._ends() if t < until), until]
        return [self.t0, *(a + (b - a) * k / WITHIN for a, b in pairwise(points) for k in range(1, WITHIN + 1))]


def scale_of(segment: FollowedSegment) -> float:
    """A time in which something moves noticeably: by a radian, or by the largest length in sight."""
    regime = segment.regime
    if not regime.letters[1:]:
        return segment.pace
    rates = [abs(r) for r in segment.rates()]
    sizes = [segment.length if c.unit != "rad" else 1.0 for c in regime.coordinates]
    times = [size / r for size, r in zip(sizes, rates, strict=False) if r]
    turning = angular_speeds(regime)
    for u, a in zip(regime.free, rates[len(regime.coordinates) :], strict=True):
        size = 1.0 if u in turning else segment.length
        if a:
            times.append(math.sqrt(size / a))
    shortest = min(times, default=math.inf)
    return shortest if math.isfinite(shortest) else segment.pace


def angular_speeds(regime: Regime) -> set[sp.Symbol]:
    """The free speeds that are angular: also a point on a circle may have a speed in m/s."""
    units = regime.general.instant.scene.ledger.units
    return {u for u in regime.free if units[u].dimension == RATE}


def length_of(regime: Regime, state: State, rates: Sequence[float], value: Valuation, ordinary: float) -> float:
    """The largest length in sight: of a coordinate, else of the drawing, else a noticeable part of the way on which
    a speed changes by its own size, else an `ordinary` one. `rates`: of the coordinates and the free speeds.
    """
    straight = [c for c in regime.coordinates if c.unit != "rad"]
    drawn = _drawn(regime, state, value)
    largest = max((abs(state[c.symbol]) for c in straight), default=0.0)
    if largest > SLACK * drawn:
        return largest
    if drawn:
        return drawn
    turning = angular_speeds(regime)
    speeds = [abs(r) for c, r in zip(regime.coordinates, rates, strict=False) if c.unit != "rad"]
    changes = [abs(a) for u, a in zip(regime.free, rates[len(regime.coordinates) :], strict=True) if u not in turning]
    speed, change = max(speeds, default=0.0), max(changes, default=0.0)
    way = speed * speed / change if change else 0.0
    return NOTICEABLE * way or ordinary


def _drawn(regime: Regime, state: State, value: Valuation) -> float:
    """The largest distance of a named point from the origin."""
    here = value.extended({s: Decimal(repr(v)) for s, v in state.items()})
    found = [0.0]
    for place in regime.general.instant.scene.points.values():
        for part in (place.x, place.y):
            number = here.known(part)
            if number is not None:
                found.append(abs(float(number)))
    return max(found)


def events(
    g: Callable[[float], float], segment: FollowedSegment, until: float | None = None, evaluations: int | None = None
) -> Iterator[Root]:
    """Roots along a segment in order, as far as it was followed. NotReached: after so many `evaluations` it is not
    searched to its end.
    """
    followed = max((piece.t1 for piece in segment.pieces), default=segment.t0)
    end = followed if until is None else min(followed, until)
    if end <= segment.t0:
        return
    try:
        for root in roots(g, segment.t0, end, scale_of(segment), evaluations=evaluations):
            if root.value > segment.t0 and not _died_out(g, root.value, segment):
                yield root
    except NoValue as error:
        if evaluations is not None and isinstance(error, NotReached):
            raise


def _died_out(g: Callable[[float], float], t: float, segment: FollowedSegment) -> bool:
    """Has a function sunk below what machine numbers tell of it, so that its zeros mean nothing?"""
    run = t - segment.t0
    largest = max(abs(g(segment.t0 + run * k / LOOKS)) for k in range(LOOKS))
    near = max(abs(g(t - NEARBY * run)), abs(g(t)))
    return near <= DEAD * largest


def is_zero(g: Callable[[float], float], t: float, segment: FollowedSegment, size: float) -> bool:
    """Does a function vanish at a time, as far as machine numbers tell? `size`: what it is measured by."""
    nearby = max(abs(g(segment.t0)), abs(g(t - (t - segment.t0) / 3)))
    return abs(g(t)) <= max(NEAR * nearby, SLACK * size)
