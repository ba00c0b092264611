"""One step of y' = f(t, y) by extrapolated midpoint rules, in floats, decimals or mpmath's numbers alike.

Gragg's modified midpoint rule with 2, 4, 6, ... substeps, extrapolated in the square of the substep (Gragg 1965;
Bulirsch and Stoer 1966; order and step from the work per unit of time as in Hairer, Nørsett and Wanner, Solving
Ordinary Differential Equations I, section II.9). It needs no coefficients and has any order, so that one text serves
12 digits and 50. Increments rather than states are extrapolated: rounding then follows the change within the step.
"""

from __future__ import annotations

import decimal
import math
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import Any

import mpmath

from planar_cli.errors import NotReached, NoValue
from planar_cli.records import record

Rates = Callable[[Any, Sequence[Any]], list[Any]]

FLOAT_DIGITS = 13
UNREAL = (complex, mpmath.mpc)
FEWEST = 3
GROW, SHRINK = 6.0, 0.1
NOISY = 1e4
"""An error that smaller steps do not mend is taken for rounding up to so many rounding units."""


class Leaves(NotReached):
    """The motion cannot be followed further: `told` says why, `reached` is the last instant known."""

    def __init__(self, message: str, reached: Any) -> None:
        self.told, self.reached = message, reached
        super().__init__(f"{message} (the motion is known up to t = {float(reached):.12g})")


@record
class Level:
    """An arithmetic: how to make its numbers, its rounding unit, the error allowed in a step, the highest column."""

    make: Callable[[Any], Any]
    context: Callable[[], AbstractContextManager[Any]]
    unit: float
    tolerance: float
    columns: int
    evaluations: int
    nodes: int


def level_for(digits: int, decimals: bool, evaluations: int | None) -> Level:
    """Floats up to 13 digits; beyond, decimals or mpmath's numbers with guard digits."""
    if digits <= FLOAT_DIGITS:
        return Level(float, nullcontext, 2.0**-52, max(10.0 ** -(digits + 2), 1e-14), 10, evaluations or 1_000_000, 6)
    columns = digits // 2 + 4
    precision = digits + 12 + columns // 2
    unit, tolerance, nodes = 10.0 ** (1 - precision), 10.0 ** -(digits + 2), digits // 2 + 2
    if decimals:

        def exact() -> AbstractContextManager[Any]:
            context = decimal.getcontext().copy()
            context.prec = precision
            return decimal.localcontext(context)

        return Level(decimal.Decimal, exact, unit, tolerance, columns, evaluations or 1_000_000, nodes)
    return Level(_mpf, lambda: mpmath.workdps(precision), unit, tolerance, columns, evaluations or 300_000, nodes)


def _mpf(x: Any) -> Any:
    return mpmath.mpf(str(x)) if isinstance(x, decimal.Decimal) else mpmath.mpf(x)


@record
class Trial:
    """A step tried: the increments (None: rejected), the error left in each, and what to try next."""

    delta: list[Any] | None
    error: list[float]
    ratio: float
    factor: float
    target: int


class Stepper:
    """Steps of one differential equation; counts what they cost. `floors`: sizes below which no component counts as
    small, so that nothing is followed into its rounding where it starts from zero.
    """

    def __init__(self, rhs: Rates, level: Level, floors: Sequence[float] = ()) -> None:
        self.rhs, self.level, self.spent = rhs, level, 0
        self.floors = tuple(floors)

    def rates(self, t: Any, y: Sequence[Any]) -> list[Any]:
        """The right-hand side, with everything that is not a real number as an ArithmeticError."""
        self.spent += 1
        try:
            found = self.rhs(t, y)
        except ValueError as e:
            raise NoValue(str(e)) from e
        for v in found:
            if isinstance(v, UNREAL) or v - v != 0:
                raise NoValue("the rates have no real value")
        return found

    def scales(self, t: Any, y: Sequence[Any], f: Sequence[Any], step: Any) -> list[float]:
        """What the error in each component is measured by: its size, its change in the step, and how much it would
        change if all the others changed by their size. So no unit enters, and zero by symmetry is no demand.
        """
        small = 2.0 ** round(math.log2(self.level.unit) / 2)
        span = abs(float(step))
        floors = self.floors or (0.0,) * len(y)
        sizes = [max(abs(float(a)), span * abs(float(b)), c) for a, b, c in zip(y, f, floors, strict=True)]
        make = self.level.make
        moved = [
            a + make(small * s * (1.0 if i % 2 else -0.7)) if s else a
            for i, (a, s) in enumerate(zip(y, sizes, strict=True))
        ]
        try:
            other = self.rates(t, moved)
        except ArithmeticError:
            return sizes
        turns = (span * abs(float(b - a)) / small for a, b in zip(f, other, strict=True))
        return [max(s, turn) for s, turn in zip(sizes, turns, strict=True)]

    def midpoint(self, t: Any, y: Sequence[Any], f: Sequence[Any], step: Any, n: int) -> list[Any]:
        """The increment of y over a step by the midpoint rule with n substeps."""
        h = step / n
        twice = h + h
        last = [h - h for _ in y]
        now = [h * a for a in f]
        for m in range(1, n):
            rates = self.rates(t + m * h, [a + b for a, b in zip(y, now, strict=True)])
            last, now = now, [a + twice * b for a, b in zip(last, rates, strict=True)]
        return now

    def trial(
        self, t: Any, y: Sequence[Any], f: Sequence[Any], step: Any, scales: Sequence[float], target: int, loose: float
    ) -> Trial:
        """Try one step: columns are added until two agree, at most one beyond the target."""
        tolerance = self.level.tolerance * loose
        columns = self.level.columns
        row: list[list[Any]] = []
        errors = [0.0 for _ in y]
        best, work = (math.inf, 1.0, FEWEST), 1
        last = math.inf
        for j in range(1, min(max(target + 1, FEWEST), columns) + 1):
            n = 2 * j
            work += n - 1
            row = _extrapolated(self.midpoint(t, y, f, step, n), row, j)
            if j == 1:
                continue
            errors = [abs(float(a - b)) for a, b in zip(row[-1], row[-2], strict=True)]
            sizes = (max(s, abs(float(a + d))) for s, a, d in zip(scales, y, row[-1], strict=True))
            ratio = max((e / s if s else math.inf for e, s in zip(errors, sizes, strict=True) if e), default=0.0)
            ratio /= tolerance
            if j >= FEWEST:
                best = min(best, _prospect(work, ratio, j))
            if j >= max(FEWEST, target - 1):
                if ratio <= 1:
                    if j < columns:
                        best = min(
                            best, _prospect(work + 2 * j + 1, ratio * (ratio / last if ratio < last else 1.0), j + 1)
                        )
                    return Trial(row[-1], errors, ratio, min(GROW, max(SHRINK, best[1])), best[2])
                if ratio > 1e3 * max(last, 1.0) and ratio * tolerance > 1e-3:
                    break
            last = ratio
        return Trial(None, errors, last, max(SHRINK, min(best[1], 0.7)), best[2])

    def accepted(
        self, t: Any, y: Sequence[Any], f: Sequence[Any], step: Any, target: int, loose: float, limit: Any
    ) -> tuple[Any, Trial, list[float]]:
        """The first step that holds, from `step` downwards: its length, the trial, the scales.

        ArithmeticError: none does down to `limit`.
        """
        last, rejected, asked = math.inf, 0, step
        while True:
            if self.spent > self.level.evaluations:
                raise Leaves(f"given up after {self.spent} evaluations", t)
            scales = self.scales(t, y, f, step)
            try:
                trial = self.trial(t, y, f, step, scales, target, loose)
            except ArithmeticError as e:
                if abs(step) <= limit:
                    raise Leaves(str(e) or type(e).__name__, t) from e
                step, last = step / 4, math.inf
                continue
            if trial.delta is not None:
                return step, trial, scales
            noise = trial.ratio * self.level.tolerance * loose <= NOISY * self.level.unit
            if noise and rejected >= 2 and trial.ratio > last / 2:
                full = self._settled(t, y, f, step)
                grown = min(GROW, 2 * float(asked / step))
                return step, Trial(full, trial.error, trial.ratio, grown, trial.target), scales
            if abs(step) <= limit:
                raise Leaves("no step is short enough", t)
            last, rejected = trial.ratio, rejected + 1
            step *= self.level.make(trial.factor)
            target = trial.target

    def _settled(self, t: Any, y: Sequence[Any], f: Sequence[Any], step: Any) -> list[Any]:
        """Three columns for a step in which only rounding is left to disagree."""
        row: list[list[Any]] = []
        for j in range(1, FEWEST + 1):
            row = _extrapolated(self.midpoint(t, y, f, step, 2 * j), row, j)
        return row[-1]

    def advance(self, t: Any, y: Sequence[Any], end: Any, target: int, loose: float = 1.0) -> list[Any]:
        """The state at `end`, by as many steps as it takes."""
        now, step = list(y), end - t
        whole = abs(step)
        while t != end:
            limit = whole * self.level.make(1e-9)
            if abs(step) > abs(end - t) * self.level.make(0.999):
                step = end - t
            step, trial, _ = self.accepted(t, now, self.rates(t, now), step, target, loose, limit)
            assert trial.delta is not None
            now = [a + d for a, d in zip(now, trial.delta, strict=True)]
            t = end if step == end - t else t + step
            step, target = step * self.level.make(trial.factor), trial.target
        return now


def _prospect(work: int, ratio: float, column: int) -> tuple[float, float, int]:
    """The work per time, if this column is to decide the next step; the factor for that step; the column."""
    factor = 0.85 * (0.5 / max(ratio, 1e-30)) ** (1 / (2 * column - 1))
    return work / factor, factor, column


def _extrapolated(first: list[Any], before: list[list[Any]], j: int) -> list[list[Any]]:
    """Row j of the table from row j - 1 (Aitken and Neville), for substep numbers 2, 4, 6, ..."""
    row = [first]
    for k in range(1, j):
        numerator, denominator = (j - k) ** 2, j**2 - (j - k) ** 2
        row.append([a + (a - b) * numerator / denominator for a, b in zip(row[-1], before[k - 1], strict=True)])
    return row
