"""What methods with step control share: the loop over trial steps."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

from planar_cli.integrators.base import (
    OUTSIDE,
    Counts,
    Integrator,
    Rates,
    Setting,
    Step,
    StepTooSmall,
    TooManySteps,
    Vector,
    first_step,
    shortest_step,
)

RENEWED = 8
"""Every so many steps what depends on the size of grown components is renewed."""
STABLE, CALM = 5.0, 3.0
"""Where step · fastest is above the first, an explicit method makes errors grow from step to step, and an estimate that
happens to be small means nothing: the step is tried again with the second."""
ERRORLESS = 1e-9
"""Errors below this part of what is allowed are taken as that."""


class Method(ABC):
    """The steps of a method in one run: what differs from method to method."""

    safety: ClassVar[float]
    least: ClassVar[float]
    """No step is shortened more than by this factor at once."""
    most: ClassVar[float]
    """No step grows more than by this factor."""
    keep: ClassVar[float] = 1.0
    """A step that could grow by less than that keeps its length."""
    power: ClassVar[float]
    """The error estimate goes with this power of the step."""

    @abstractmethod
    def begin(self, t: float, y: Vector, rates: Vector) -> None:
        """Take up the start of a step."""

    @abstractmethod
    def trial(self, h: float, again: bool) -> tuple[Vector, float]:
        """The end of a step, and its error in parts of what is allowed: infinite where there is no such step.

        `again`: the last trial was rejected, or this is the first one.
        """

    @abstractmethod
    def inside(self, new: Vector, after: Vector) -> Callable[[float], Vector]:
        """Dense output of the step tried last; `new` and `after`: the state and the rates at its end."""

    def fastest(self, new: Vector, after: Vector) -> float:
        """How fast the fastest motion goes [1/s], where it was worth while to measure that; else 0."""
        return 0.0

    @abstractmethod
    def renew(self, y: Vector, ahead: float) -> None:
        """Take up that components may have grown; called now and then. `ahead`: about so many steps are left."""


class Adaptive(Integrator):
    """A method with step control."""

    adaptive: ClassVar[bool] = True

    @abstractmethod
    def method(self, f: Rates, setting: Setting, counts: Counts, y: Vector) -> Method:
        """What makes the steps of one run."""

    def steps(self, f: Rates, t0: float, y0: Sequence[float], t1: float, setting: Setting) -> Iterator[Step]:
        """Steps whose estimated error is below the tolerance, or equal ones if the setting fixes their length."""
        if t1 == t0:
            return
        counts, y, t, rates = self.counts, list(y0), t0, f(t0, list(y0))
        counts.evaluations += 1
        method = self.method(f, setting, counts, y)
        control = _Control(method, setting, counts, t0, t1)
        control.h = setting.step or setting.first or self._first(f, t0, y, rates, t1, setting)
        method.begin(t, y, rates)
        while t != t1:
            span = control.span(t, y, t1)
            new, error = method.trial(span, control.again)
            if not (error <= 1.0 or control.fixed):
                control.rejected(t, y, abs(span), error)
                continue
            if error == math.inf:
                raise StepTooSmall(f"a step of {abs(span):.3g} s from t = {t:.9g} s has no solution", t, y)
            end = t1 if abs(span) == abs(t1 - t) else t + span
            if end == t:
                raise StepTooSmall(f"the steps became too short at t = {t:.9g} s ({abs(span):.1g} s)", t, y)
            counts.evaluations += 1
            try:
                if setting.project is not None:
                    new, tried = setting.project(end, new), new
                    if not control.fixed and setting.leaps(tried, new):
                        control.rejected(t, y, abs(span), math.inf)
                        continue
                after = f(end, new)
            except OUTSIDE as outside:
                if control.fixed:
                    raise StepTooSmall(f"there are no rates at t = {end:.9g} s ({outside})", t, y) from outside
                control.rejected(t, y, abs(span), math.inf)
                continue
            fastest = method.fastest(new, after)
            if fastest * abs(span) > STABLE and not (control.fixed or control.calmed):
                control.calm(fastest)
                continue
            counts.steps += 1
            yield Step(t, y, rates, end, new, after, method.inside(new, after), error, fastest)
            t, y, rates = end, new, after
            control.accepted(t, y, abs(span), error, fastest)
            method.begin(t, y, rates)

    def _first(self, f: Rates, t0: float, y: Vector, rates: Vector, t1: float, setting: Setting) -> float:
        self.counts.evaluations += 1
        return first_step(f, t0, y, rates, t1, self.order, setting)


class _Control:
    """The length of the next step."""

    def __init__(self, method: Method, setting: Setting, counts: Counts, t0: float, t1: float) -> None:
        self.method, self.counts = method, counts
        self.fixed, self.setting, self.most_steps = setting.step is not None, setting, setting.most_steps
        self.t0 = t0
        self.h, self.run, self.direction = 0.0, abs(t1 - t0), math.copysign(1.0, t1 - t0)
        self.again, self.calmed = True, False
        self.done = 0

    def span(self, t: float, y: Vector, t1: float) -> float:
        """The step to try, with its sign: the last three are made even, so that no crumb remains at the end."""
        longest = self.setting.longest if self.fixed else self.setting.longest_from(y)
        left, h = abs(t1 - t), min(self.h, longest)
        return self.direction * (h if left > 3.0 * h else left / max(1, math.ceil(left / h - 1e-6)))

    def rejected(self, t: float, y: Vector, tried: float, error: float) -> None:
        """The error was too large: a shorter step follows."""
        method = self.method
        self.counts.rejected += 1
        factor = 0.25 if error == math.inf else max(method.least, method.safety * error**-method.power)
        self.h, self.again = tried * factor, True
        if self.h < shortest_step(t, 0.0, self.run) or self.counts.rejected > self.most_steps:
            raise StepTooSmall(f"the steps became too short at t = {t:.9g} s ({self.h:.1g} s)", t, y)

    def calm(self, fastest: float) -> None:
        """The step is too long for the fastest motion, whatever its error is said to be."""
        self.counts.rejected += 1
        self.h, self.again, self.calmed = CALM / fastest, True, True

    def accepted(self, t: float, y: Vector, made: float, error: float, fastest: float) -> None:
        """The error was small: the next step is as long as it allows, but after a rejection no longer than this one."""
        method = self.method
        self.done += 1
        if not self.fixed:
            factor = max(method.least, method.safety * max(error, ERRORLESS) ** -method.power)
            factor = min(factor, 1.0 if self.again and self.done > 1 else method.most)
            self.h = made * (1.0 if 1.0 <= factor < method.keep else factor)
            if fastest * made > 0.5 * CALM and fastest * self.h > STABLE:
                self.h = max(made, CALM / fastest)
        self.again = self.calmed = False
        if self.done % RENEWED == 0:
            method.renew(y, (self.run - abs(t - self.t0)) / self.h)
        if self.counts.steps > self.most_steps:
            raise TooManySteps(f"more than {self.most_steps} steps until t = {t:.9g} s", t, y)
