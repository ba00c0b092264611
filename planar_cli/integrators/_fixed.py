"""What methods with equal steps share: the loop, and a cubic between the ends of a step."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Iterator, Sequence
from typing import ClassVar

from planar_cli.integrators.base import (
    OUTSIDE,
    Integrator,
    Rates,
    Setting,
    Step,
    StepTooSmall,
    TooManySteps,
    Vector,
    first_step,
    norm,
)


class EqualSteps(Integrator):
    """A method that advances by equal steps."""

    adaptive: ClassVar[bool] = False
    cost: ClassVar[int]
    """Evaluations in one step, beside that at its start."""

    @abstractmethod
    def advance(self, f: Rates, t: float, y: Vector, r: Vector, h: float) -> Vector:
        """The state a step later; r: the rates at its start."""

    def steps(self, f: Rates, t0: float, y0: Sequence[float], t1: float, setting: Setting) -> Iterator[Step]:
        """Equal steps; without `setting.step`, such that the first one keeps to the tolerance over the whole run."""
        if t1 == t0:
            return
        y, r, counts = list(y0), f(t0, list(y0)), self.counts
        counts.evaluations += 1
        length = setting.step or self._length(f, t0, y, r, t1, setting)
        number = max(1, math.ceil(abs(t1 - t0) / min(length, setting.longest) - 1e-9))
        for i in range(number):
            start = t0 + (t1 - t0) * (i / number)
            if i >= setting.most_steps:
                raise TooManySteps(f"more than {i} steps until t = {start:.9g} s", start, y)
            end = t0 + (t1 - t0) * ((i + 1) / number)
            new, rates = self._advanced(f, start, y, r, end, setting)
            counts.evaluations += self.cost + 1
            counts.steps += 1
            yield Step(start, y, r, end, new, rates, Cubic(start, y, r, end, new, rates))
            y, r = new, rates

    def _advanced(
        self, f: Rates, start: float, y: Vector, r: Vector, end: float, setting: Setting
    ) -> tuple[Vector, Vector]:
        """State and rates at the end of a step."""
        try:
            new = self.advance(f, start, y, r, end - start)
            if setting.project is not None:
                new = setting.project(end, new)
            if math.isfinite(sum(new)):
                return new, f(end, new)
        except OUTSIDE as outside:
            message = f"there are no rates within {abs(end - start):.3g} s from t = {start:.9g} s ({outside})"
            raise StepTooSmall(message, start, y) from outside
        raise StepTooSmall(f"steps of {abs(end - start):.3g} s are too long: nothing is finite any more", start, y)

    def _length(self, f: Rates, t0: float, y: Vector, r: Vector, t1: float, setting: Setting) -> float:
        """A step that errs by no more than its share of the tolerance: one is compared with two of half its length."""
        run, weights = t1 - t0, setting.weights(y)
        h = math.copysign(first_step(f, t0, y, r, t1, self.order, setting), run)
        self.counts.evaluations += 1
        for _ in range(60):
            whole = self.advance(f, t0, y, r, h)
            middle = self.advance(f, t0, y, r, h / 2)
            halves = self.advance(f, t0 + h / 2, middle, f(t0 + h / 2, middle), h / 2)
            self.counts.evaluations += 3 * self.cost + 1
            error = norm([a - b for a, b in zip(whole, halves, strict=True)], weights)
            if error * abs(run) <= abs(h):
                break
            h *= max(0.1, 0.9 * (abs(h) / (error * abs(run))) ** (1 / self.order))
        return abs(h)


class Cubic:
    """The cubic that takes up states and rates at both ends of a step (Hermite): an error of the fourth order."""

    __slots__ = ("end", "new", "r0", "r1", "start", "y")

    def __init__(self, start: float, y: Vector, r0: Vector, end: float, new: Vector, r1: Vector) -> None:
        self.start, self.y, self.r0, self.end, self.new, self.r1 = start, y, r0, end, new, r1

    def __call__(self, t: float) -> Vector:
        h = self.end - self.start
        x = (t - self.start) / h
        z = 1.0 - x
        value, slope0, slope1 = x * x * (3.0 - 2.0 * x), h * x * z * z, -h * x * x * z
        return [
            a + value * (b - a) + slope0 * p + slope1 * q
            for a, b, p, q in zip(self.y, self.new, self.r0, self.r1, strict=True)
        ]
