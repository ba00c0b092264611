"""The explicit method of Dormand and Prince of order 8, on plain lists."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from typing import ClassVar, final

from planar_cli.integrators._adaptive import RENEWED, Adaptive, Method
from planar_cli.integrators._dop853_kernel import (
    EXTRA,
    Coefficients,
    Kept,
    Trial,
    dense,
    with_loops,
    written_out,
)
from planar_cli.integrators.base import OUTSIDE, Counts, Rates, Setting, StepTooSmall, Vector, shortest_step

FEW = 4
"""So few components are written out at once."""
SEEN = 64 * sys.float_info.epsilon
"""A smaller difference of accelerations, in parts of what the scales of speed and place make, is a rounding."""
WORTH, MIDDLE, SOONER = 350, 30, 150
"""So many steps, behind or ahead, pay for writing out any number of components; for no more than the second so many as
the third, as a motion is hardly ever followed just once."""


@final
class DormandPrince853(Adaptive):
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

    def method(self, f: Rates, setting: Setting, counts: Counts, y: Vector) -> Method:
        return _Steps(f, setting, counts, y)


@final
class _Steps(Method):
    """The steps of one run."""

    safety: ClassVar[float] = 0.8
    least: ClassVar[float] = 1 / 3
    most: ClassVar[float] = 6.0
    power: ClassVar[float] = 1 / 8

    def __init__(self, f: Rates, setting: Setting, counts: Counts, y: Vector) -> None:
        self.f, self.setting, self.counts = f, setting, counts
        self.formula: Trial = written_out(len(y)) if len(y) <= FEW else with_loops()
        self.weights = setting.weights(y)
        self.done = 0
        self.measured = (0.0, 0.0)
        """The step at which the fastest motion was measured last, and what it was."""
        self.h, self.last, self.kept = 0.0, y, Kept()

    def begin(self, t: float, y: Vector, rates: Vector) -> None:
        self.t, self.y, self.rates = t, y, rates
        self.done += 1

    def trial(self, h: float, again: bool) -> tuple[Vector, float]:
        self.counts.evaluations += 11
        self.h = h
        try:
            new, five, three, self.last, self.kept = self.formula(self.f, self.t, self.y, self.rates, h, self.weights)
        except OUTSIDE as outside:
            if abs(h) < 2.0 * shortest_step(self.t, self.t, self.t):
                message = f"there are no rates beyond t = {self.t:.9g} s ({outside})"
                raise StepTooSmall(message, self.t, self.y) from outside
            return self.y, math.inf
        together = five + 0.01 * three
        error = abs(h) * five / math.sqrt(len(new) * together) if together else 0.0
        return new, math.inf if math.isnan(error) else error

    def inside(self, new: Vector, after: Vector) -> Inside:
        return Inside(self.f, self.counts, self.t, self.y, self.h, new, self.kept, after)

    def fastest(self, new: Vector, after: Vector) -> float:
        h, (then, known) = abs(self.h), self.measured
        if self.done % RENEWED and h <= 1.5 * then and h * known <= 1.0:
            return 0.0
        self.measured = h, _fastest(self.kept[-1], self.last, after, new, self.setting.scale)
        return self.measured[1]

    def renew(self, y: Vector, ahead: float) -> None:
        self.weights = self.setting.weights(y)
        if max(self.done, ahead) > (WORTH if len(y) > MIDDLE else SOONER):
            self.formula = written_out(len(y))


class Inside:
    """Dense output of one step, of order 7. Its three evaluations are made when it is first asked for."""

    __slots__ = ("_coefficients", "_counts", "_made_of")

    def __init__(
        self, f: Rates, counts: Counts, t: float, y: Vector, h: float, new: Vector, kept: Kept, end: Vector
    ) -> None:
        self._counts = counts
        self._made_of = (f, t, y, h, new, kept, end)
        self._coefficients: Coefficients = []

    def __call__(self, t: float) -> Vector:
        f, start, y, h, new, kept, end = self._made_of
        if not self._coefficients:
            self._counts.evaluations += len(EXTRA)
            self._coefficients = dense()(f, start, y, h, new, kept, end)
        x = (t - start) / h
        z = 1.0 - x
        return [
            v + x * (a + z * (b + x * (c + z * (d + x * (e + z * (g + x * i))))))
            for v, (a, b, c, d, e, g, i) in zip(y, self._coefficients, strict=True)
        ]


def _fastest(last_rates: Vector, last: Vector, rates: Vector, new: Vector, scale: Sequence[float]) -> float:
    """How fast the fastest motion goes [1/s]: from two states at the end of the step, and how their rates differ.

    The first half of the state holds positions, the second their rates. In a vibration accelerations differ by -ω²
    times what positions differ by; in a damped motion by a negative rate times what velocities differ by. What drives
    apart, near an unstable equilibrium, is not fast in this sense: 0. Nor is a rounding.
    """
    half = len(new) // 2
    change = moved = sped = back = braked = 0.0
    for i, s in enumerate(scale[: len(new) - half]):
        x, v, a = last[i] - new[i], last[half + i] - new[half + i], last_rates[half + i] - rates[half + i]
        square = s * s
        # Near an equilibrium forces cancel but for a rounding, which is no difference of rates.
        if abs(a) <= SEEN * scale[half + i] ** 2 / s:
            continue
        change += a * a / square
        moved += x * x / square
        sped += v * v / square
        back -= a * x / square
        braked -= a * v / square
    if half and back > 0.0:
        return math.sqrt(math.sqrt(change / moved))
    return math.sqrt(change / sped) if braked > 0.0 else 0.0
