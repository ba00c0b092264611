"""Drives an integrator along one regime: from a start to a time, or to the first thing that a watched value reaches.

Times at which loads jump or kink are hit exactly, and the rates on either side of such a time are never asked for
beyond it. No run is without an end: steps below the rounding of the time, or too many of them, are refused by name.

Where the fastest motion of a scene goes much faster than what the tolerance can see, the rest of the run is given to
the implicit method, and the run says so (`Changed`). That is the case

- where an explicit method is held down by its stability, not by its errors, step after step; or
- where it would resolve a vibration for very long (more than LONG steps to go, each shorter than a few radians of it)
  whose displacement is below the tolerance. Then its velocity, though perhaps above the tolerance, dies out in the
  implicit method; whoever wants to see it names an explicit one.

A state whose rates are exactly zero stays as it is: an unstable equilibrium is not left by rounding here.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from planar_cli.integrators.base import (
    EPSILON,
    OUTSIDE,
    Counts,
    Integrator,
    Rates,
    Setting,
    Step,
    StepTooSmall,
    Vector,
)
from planar_cli.motion.terms.crossings import BAND, Crossing, Sentinel, Watch
from planar_cli.motion.trajectory.reduced import Reduced
from planar_cli.records import record
from planar_cli.registry import member

AUTOMATIC, EXPLICIT, STIFF = "auto", "dop853", "radau"
"""The choice by the scene, and what it chooses from."""
IMPLICIT = "the implicit method goes on"
"""In words."""
UNSTABLE, IDLE, TIMES = 2.0, 0.02, 20
"""Stability holds the steps down where step · fastest is above the first and the error below the second part of what is
allowed, so many times in a row."""
LONG = 500
"""A vibration that nobody sees is followed if so many steps do it."""
RESOLVED = 0.3
"""Above this, step · fastest says that the steps are short for the fastest motion's sake."""
FEW = 4
"""So many times in a row."""
INVISIBLE = 0.1
"""A displacement below this part of the tolerance is not seen."""
OUTGROWN = 1e8
"""A velocity of so many times its scale leaves half the digits of floats to all beside it: a motion that grows as an
exponential function is not followed to where they overflow.
"""
FEWEST = 16
"""No step is longer than this part of the way to the end of the run."""


@record
class Changed:
    """The run was given to the implicit method."""

    t: float
    fastest: float
    """How fast the fastest motion goes [1/s]."""
    unresolved: bool
    """Has that motion velocities above the tolerance, though its displacement is below? They are no longer followed."""

    @property
    def words(self) -> str:
        """As a sentence."""
        text = f"stiff from t = {self.t:.3g} s on: {IMPLICIT}, for a motion with a rate of {self.fastest:.2g} 1/s"
        lost = " whose displacement is below the tolerance; its velocity, which is not, is left to die out"
        return text + lost if self.unresolved else text


@record
class Run:
    """One run: its steps, and where and why it ended."""

    t0: float
    y0: Vector
    steps: tuple[Step, ...]
    t1: float
    y1: Vector
    crossings: tuple[Crossing, ...]
    """What ended it: the first thing reached, with all that is reached at the same time. Empty: the end of the time."""
    changed: Changed | None
    counts: Counts

    def at(self, t: float) -> Vector:
        """The state at a time of the run."""
        if not self.steps or t == self.t1:
            return list(self.y1)
        forward = 1.0 if self.t1 >= self.t0 else -1.0
        low, high = 0, len(self.steps) - 1
        while low < high:
            middle = (low + high) // 2
            if (self.steps[middle].t1 - t) * forward < 0.0:
                low = middle + 1
            else:
                high = middle
        return self.steps[low].at(t)


def order_of(kind: str) -> int:
    """Of a member of the shelf of integrators; of `auto` that of the method with which it begins."""
    integrator: type[Integrator] = member("integrators", EXPLICIT if kind == AUTOMATIC else kind)
    return integrator.order


def drive(
    f: Rates,
    t0: float,
    y0: Sequence[float],
    t1: float,
    setting: Setting,
    *,
    kind: str = AUTOMATIC,
    watch: Watch | None = None,
    breakpoints: Sequence[float] = (),
    band: float = BAND,
    on_step: Callable[[Step], bool | None] | None = None,
    counts: Counts | None = None,
    reduced: Reduced | None = None,
) -> Run:
    """Follow y' = f(t, y) from t0 to t1, or to the first crossing of a watched value.

    `kind`: a member of the shelf of integrators, or `auto`. `band`: the part of its scale below which a watched value
    is zero. `on_step` sees every step; the run ends with one for which it says True. The work is added to `counts`.
    `reduced`: the same rates with independent coordinates alone, which are integrated then. Raises StepTooSmall.
    """
    y, steps, counts = list(y0), list[Step](), Counts() if counts is None else counts
    sentinel = Sentinel(watch, band) if watch is not None and watch.scales else None
    crossings = _seen(t0, y, partial(sentinel.at_start, t0, y)) if sentinel is not None else []
    if setting.longest == math.inf:
        setting = replace(setting, longest=abs(t1 - t0) / FEWEST or math.inf)
    followed, enough = _Followed(kind, setting, counts, reduced), False
    for rates, start, end in _legs(f if reduced is None else reduced.rates, t0, t1, breakpoints):
        if crossings or enough:
            break
        for step in followed.steps(rates, start, y, end):
            steps.append(step)
            _demand_bounded(step, setting.scale)
            enough = on_step is not None and bool(on_step(step))
            y = step.y1
            crossings = _seen(step.t0, step.y0, partial(sentinel.within, step)) if sentinel is not None else []
            if crossings or enough:
                break
    y = crossings[0].y if crossings else y
    if setting.project is not None and crossings and steps:
        y = setting.project(crossings[0].t, y)
    end = crossings[0].t if crossings else steps[-1].t1 if enough else t1
    return Run(t0, list(y0), tuple(steps), end, y, tuple(crossings), followed.changed, counts)


def _demand_bounded(step: Step, scale: Sequence[float]) -> None:
    """StepTooSmall: something has outgrown the scene."""
    half = len(scale) // 2
    if any(abs(v) > OUTGROWN * size for v, size in zip(step.y1[half:], scale[half:], strict=True)):
        text = f"velocities have grown to more than {OUTGROWN:.0e} times what is usual here"
        raise StepTooSmall(text, step.t1, step.y1)


def _seen(t: float, y: Vector, look: Callable[[], list[Crossing]]) -> list[Crossing]:
    """What is found of watched values from time t on. StepTooSmall: one of them has no value there."""
    try:
        return look()
    except OUTSIDE as outside:
        text = f"what tells the next state has no value beyond t = {t:.9g} s ({outside})"
        raise StepTooSmall(text, t, y) from outside


class _Followed:
    """The steps of a run, from the explicit method as long as that is reasonable."""

    def __init__(self, kind: str, setting: Setting, counts: Counts, reduced: Reduced | None) -> None:
        self.choosing, self.reduced = kind == AUTOMATIC, reduced
        self.kind = EXPLICIT if self.choosing else kind
        self.setting, self.counts = setting, counts
        self.changed: Changed | None = None
        self._unstable = self._short = 0

    def steps(self, f: Rates, t0: float, y0: Vector, t1: float) -> Iterator[Step]:
        """The steps of one leg, on which the rates are smooth."""
        for step in self._own(self.kind, f, t0, y0, t1, self.setting):
            yield step
            if self.choosing and step.fastest and self._stiff(step, t1):
                break
        else:
            return
        self.choosing, self.kind = False, STIFF
        coarse = replace(self.setting, first=min(abs(t1 - step.t1) / FEWEST, self.setting.longest))
        yield from self._own(STIFF, f, step.t1, step.y1, t1, coarse)

    def _own(self, kind: str, f: Rates, t0: float, y0: Vector, t1: float, setting: Setting) -> Iterator[Step]:
        """The steps of one method."""
        integrator: Integrator = member("integrators", kind)()
        integrator.counts = self.counts
        if self.reduced is None:
            return integrator.steps(f, t0, y0, t1, setting)
        return self.reduced.steps(integrator, f, t0, y0, t1, setting)

    def _stiff(self, step: Step, t1: float) -> bool:
        """Is the rest of the leg better left to the implicit method?"""
        h = abs(step.t1 - step.t0)
        angle, left = h * step.fastest, abs(t1 - step.t1)
        self._unstable = self._unstable + 1 if angle > UNSTABLE and step.error < IDLE else 0
        held_down = self._unstable >= TIMES
        self._short = self._short + 1 if angle > RESOLVED and left > LONG * h else 0
        if not held_down and self._short < FEW:
            return False
        displacement, velocity = self._fast_motion(step)
        if held_down or displacement < INVISIBLE:
            self.changed = Changed(step.t1, step.fastest, velocity > 1.0)
        return self.changed is not None

    def _fast_motion(self, step: Step) -> tuple[float, float]:
        """How far the fastest motion moves anything, and how fast, in parts of what the tolerance allows.

        The positions are the first half of the state; what accelerations change by within a step of that motion is its
        velocity times its rate, and its displacement times the square of that.
        """
        half, fast = len(step.y1) // 2, step.fastest
        middle = step.at(0.5 * (step.t0 + step.t1))
        # How far the velocities bend within the step; and how far they change.
        bend = [abs(m - 0.5 * (a + b)) for m, a, b in zip(middle, step.y0, step.y1, strict=True)][half:]
        change = [abs(a - b) / fast for a, b in zip(step.r0[half:], step.r1[half:], strict=True)]
        speeds = [max(b, c) / self.setting.tolerance for b, c in zip(bend, change, strict=True)]
        scale = self.setting.scale
        return (
            max([v / fast / s for v, s in zip(speeds, scale[:half], strict=False)], default=0.0),
            max([v / s for v, s in zip(speeds, scale[half:], strict=True)], default=0.0),
        )


def _legs(f: Rates, t0: float, t1: float, breakpoints: Sequence[float]) -> Iterator[tuple[Rates, float, float]]:
    """The run in pieces between breakpoints, each with rates that are not asked for beyond its ends."""
    low, high = min(t0, t1), max(t0, t1)
    inner = sorted({b for b in breakpoints if low < b < high}, reverse=t1 < t0)
    kinks = {b for b in breakpoints if low <= b <= high}
    if not kinks:
        yield f, t0, t1
        return
    ends = [t0, *inner, t1]
    for a, b in pairwise(ends):
        yield _held_between(f, min(a, b), max(a, b), kinks), a, b


def _held_between(f: Rates, low: float, high: float, kinks: set[float]) -> Rates:
    """The rates as they are just after `low` and just before `high`, where these are kinks."""
    crumb = 4.0 * EPSILON * max(abs(low), abs(high))
    after = low + crumb if low in kinks else low
    before = high - crumb if high in kinks else high

    def rates(t: float, y: Vector) -> Vector:
        return f(min(max(t, after), before), y)

    return rates
