"""The explicit method of Dormand and Prince of order 8, on plain lists."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import ClassVar, final

from planar_cli.integrators._dop853_kernel import (
    KEPT,
    Trial,
    dense_coefficients,
    dense_rates,
    with_loops,
    written_out,
)
from planar_cli.integrators.base import (
    OUTSIDE,
    Integrator,
    Rates,
    Setting,
    Step,
    StepTooSmall,
    Vector,
    first_step,
    shortest_step,
)

SAFETY, SMALLEST, LARGEST = 0.9, 1 / 3, 6.0
"""How the next step follows from the error: Hairer's values."""
FEW = 16
"""So few components are written out at once."""
WORTH = 400
"""After so many steps any number of components is."""
MEASURED = 8
"""Every so many steps the fastest motion is measured, and the rounding of grown components taken up."""


@final
class DormandPrince853(Integrator):
    """Dormand and Prince's explicit Runge-Kutta method of order 8 with step control (DOP853).

    Meaning
        The method for smooth motions, loose or tight: twelve evaluations in a step, an estimate of the error from two
        embedded methods of order 5 and 3, and for three evaluations more the solution within a step to order 7. Where
        the fastest motion of a stiff scene would hold its steps down, the driver changes to `radau`.

    Equations
        y(t + h) = y + h Σ b_i k_i     k_i = f(t + c_i h, y + h Σ_j a_ij k_j),   i = 1 … 12

    Valid when
        The rates are smooth between the ends of a run; jumps of loads, impacts and changes of mode begin a new one.

    Reference
        E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, II.5, II.6, II.10.
    """

    kind: ClassVar[str] = "dop853"
    order: ClassVar[int] = 8
    adaptive: ClassVar[bool] = True

    def steps(self, f: Rates, t0: float, y0: Sequence[float], t1: float, setting: Setting) -> Iterator[Step]:
        """Steps whose estimated error is below the tolerance, or equal ones if the setting fixes their length."""
        if t1 == t0:
            return
        counts, y, t = self.counts, list(y0), t0
        rates = f(t, list(y))
        counts.evaluations += 1
        direction = math.copysign(1.0, t1 - t0)
        h = setting.step or setting.first
        if not h:
            h = first_step(f, t0, y, rates, t1, self.order, setting)
            counts.evaluations += 1
        trial = written_out(len(y)) if len(y) <= FEW else with_loops()
        weights, shortest = setting.weights(y), shortest_step(t0, t0, t1)
        done, growth, fixed = 0, LARGEST, setting.step is not None
        while t != t1:
            span = direction * _fitting(h, setting.longest, abs(t1 - t), fixed)
            new, error, last, kept = self._tried(trial, f, t, y, rates, span, weights)
            if not (error <= 1.0 or fixed):
                counts.rejected += 1
                h = abs(span) * max(SMALLEST, SAFETY * error**-0.125) if error < math.inf else 0.1 * abs(span)
                if h < shortest or counts.rejected > setting.most_steps:
                    raise StepTooSmall(f"the steps became too short at t = {t:.9g} s ({h:.1g} s)", t, y)
                growth = 1.0
                continue
            end = t1 if abs(span) == abs(t1 - t) else t + span
            if setting.project is not None:
                new = setting.project(end, new)
            after = f(end, new)
            done += 1
            counts.steps += 1
            counts.evaluations += 1
            fastest = _fastest(kept[-1], last, after, new, weights) if done % MEASURED == 0 else 0.0
            yield Step(t, y, rates, end, new, after, Inside(f, t, y, span, new, kept, after), error, fastest)
            if not fixed:
                h = abs(span) * min(growth, max(SMALLEST, SAFETY * max(error, 1e-9) ** -0.125))
            t, y, rates, growth = end, new, after, LARGEST
            if done % MEASURED == 0:
                weights, shortest = setting.weights(y), shortest_step(t, t0, t1)
                if done == WORTH:
                    trial = written_out(len(y))
                if counts.steps > setting.most_steps:
                    raise StepTooSmall(f"more than {setting.most_steps} steps until t = {t:.9g} s", t, y)

    def _tried(
        self, trial: Trial, f: Rates, t: float, y: Vector, rates: Vector, h: float, weights: Vector
    ) -> tuple[Vector, float, Vector, tuple[Vector, ...]]:
        """A trial step and its error in parts of what is allowed; infinite outside of where the rates are defined."""
        self.counts.evaluations += 11
        try:
            new, five, three, last, kept = trial(f, t, y, rates, h, weights)
        except OUTSIDE as outside:
            if abs(h) < 2.0 * shortest_step(t, t, t):
                raise StepTooSmall(f"there are no rates beyond t = {t:.9g} s ({outside})", t, y) from outside
            return y, math.inf, y, ()
        together = five + 0.01 * three
        error = abs(h) * five / math.sqrt(len(y) * together) if together else 0.0
        return new, math.inf if math.isnan(error) else error, last, kept


class Inside:
    """Dense output of one step, of order 7. Its three evaluations are made when it is first asked for."""

    __slots__ = ("_coefficients", "_made_of")

    def __init__(
        self, f: Rates, t: float, y: Vector, h: float, new: Vector, kept: tuple[Vector, ...], end: Vector
    ) -> None:
        self._made_of = (f, t, y, h, new, kept, end)
        self._coefficients: list[Vector] = []

    def __call__(self, t: float) -> Vector:
        f, start, y, h, new, kept, end = self._made_of
        if not self._coefficients:
            assert len(kept) == len(KEPT)
            self._coefficients = dense_coefficients(dense_rates(f, start, y, h, kept, end), h, y, new)
        x = (t - start) / h
        z = 1.0 - x
        return [
            v + x * (a + z * (b + x * (c + z * (d + x * (e + z * (g + x * i))))))
            for v, a, b, c, d, e, g, i in zip(y, *self._coefficients, strict=True)
        ]


def _fitting(h: float, longest: float, left: float, fixed: bool) -> float:
    """The step to try: what is left at the end is divided evenly, and never a crumb remains."""
    h = min(h, longest)
    if h >= left * (1.0 - 1e-9):
        return left
    return left / 2 if h > left / 2 and not fixed else h


def _fastest(last_rates: Vector, last: Vector, rates: Vector, new: Vector, weights: Vector) -> float:
    """How fast the fastest motion goes [1/s]: two states at the end of the step, and how their rates differ."""
    change = sum([((a - b) * w) ** 2 for a, b, w in zip(last_rates, rates, weights, strict=True)])
    apart = sum([((a - b) * w) ** 2 for a, b, w in zip(last, new, weights, strict=True)])
    return math.sqrt(change / apart) if apart > 0.0 else 0.0
