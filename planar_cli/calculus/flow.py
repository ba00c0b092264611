"""The solution of y' = f(t, y): any time asked for, forward or backward, with the digits that are certain.

Steps are made as far as they are asked for and kept; between them a polynomial that takes up values and rates at
several instants of the step (Hermite) is made when first needed, checked against the equation, and kept too.

The digits claimed come from a second run with half the step and a hundredfold tolerance: four times the largest
difference of the two so far, the error estimates of all steps, and rounding. Data that are themselves rounded are not
accounted for. A push that is exactly nothing outside a short time cannot be noticed: restart where it begins and ends.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from functools import lru_cache
from itertools import pairwise
from typing import Any

from planar_cli.calculus.extrapolation import Leaves, Level, Rates, Stepper, level_for

__all__ = ["Flow", "Leaves"]

LOOSE = 100.0
DEPTH = 6
CHECKED = 20.0
"""The polynomial within a step may miss by so many tolerances of a step."""


@dataclass(slots=True)
class _Cell:
    """A polynomial on [a, b] (b before a in the backward direction), in Newton's form."""

    a: Any
    b: Any
    nodes: tuple[Any, ...]
    table: list[list[Any]]

    def at(self, t: Any) -> list[Any]:
        x = (t - self.a) / (self.b - self.a)
        found = list(self.table[-1])
        for node, row in zip(reversed(self.nodes[:-1]), reversed(self.table[:-1]), strict=True):
            away = x - node
            found = [c + away * v for c, v in zip(row, found, strict=True)]
        return found


@dataclass(slots=True)
class _Step:
    """The state at the end of a step, what is known of its error, and the polynomials within."""

    t: Any
    y: list[Any]
    rates: list[Any] | None
    error: list[float]
    sizes: list[float]
    scales: list[float]
    cells: list[_Cell] = field(default_factory=list)
    broken: tuple[int, Leaves] | None = None
    """Why there are none, and the column aimed at when they were tried."""


@lru_cache(maxsize=16)
def _places(n: int) -> tuple[tuple[float, ...], tuple[int, ...]]:
    """n + 1 Chebyshev points on [0, 1] and an order in which Newton's form is stable (Leja's)."""
    points = tuple(round(math.sin(math.pi * j / (2 * n)) ** 2 * 2**30) / 2**30 for j in range(n + 1))
    order, left = [n], list(range(n))
    while left:
        best = max(left, key=lambda i: math.prod(abs(points[i] - points[k]) for k in order))
        order.append(best)
        left.remove(best)
    return points, tuple(order)


class _Branch:
    """The steps in one direction of time; none goes beyond `stop`."""

    def __init__(self, stepper: Stepper, t0: Any, y0: list[Any], direction: int, stop: Any = None) -> None:
        self.stepper, self.direction, self.stop = stepper, direction, stop
        zero = [0.0 for _ in y0]
        sizes = [abs(float(a)) for a in y0]
        self.steps = [_Step(t0, y0, None, zero, sizes, zero)]
        self.keys = [0.0]
        self.carry = [a - a for a in y0]
        self.next: Any = None
        self.target = 4
        self.barrier: Leaves | None = None
        self.shadow = [list(y0)]
        self.apart = [zero]

    @property
    def level(self) -> Level:
        return self.stepper.level

    def reach(self, t: Any) -> int:
        """The index of the first step that ends at t or later."""
        while (self.steps[-1].t - t) * self.direction < 0:
            if self.barrier is not None:
                raise Leaves(self.barrier.told, self.steps[-1].t) from self.barrier
            try:
                self._extend(t)
            except Leaves as e:
                self.barrier = e
        return bisect_left(self.keys, abs(float(t - self.steps[0].t)), hi=len(self.keys) - 1)

    def _extend(self, t: Any) -> None:
        last, make = self.steps[-1], self.level.make
        if last.rates is None:
            last.rates = self._rates(last.t, last.y)
        if self.next is None:
            self.next = self.direction * make(_first_step(last.y, last.rates, abs(float(t - last.t))))
        whole = None
        if self.stop is not None and (last.t + self.next - self.stop) * self.direction > 0:
            whole = self.next = self.stop - last.t
        run = max(abs(float(last.t)), abs(float(last.t - self.steps[0].t)), 1e-9 * abs(float(self.next)))
        limit = make(64 * self.level.unit * run)
        following = None
        while following is None:
            step, trial, scales = self.stepper.accepted(last.t, last.y, last.rates, self.next, self.target, 1.0, limit)
            assert trial.delta is not None
            end = self.stop if whole is not None and step == whole else last.t + step
            delta = [d + c for d, c in zip(trial.delta, self.carry, strict=True)]
            y = [a + d for a, d in zip(last.y, delta, strict=True)]
            try:
                following = self._rates(end, y)
            except Leaves:
                if abs(step) <= limit:
                    raise
                self.next = step / 4
        self.carry = [d - (b - a) for d, a, b in zip(delta, last.y, y, strict=True)]
        self.steps.append(
            _Step(
                end,
                y,
                following,
                [a + b for a, b in zip(last.error, trial.error, strict=True)],
                [max(s, abs(float(a))) for s, a in zip(last.sizes, y, strict=True)],
                [max(a, b) for a, b in zip(last.scales, scales, strict=True)],
            )
        )
        self.keys.append(abs(float(end - self.steps[0].t)))
        self.next, self.target = step * make(trial.factor), trial.target

    def _rates(self, t: Any, y: list[Any]) -> list[Any]:
        try:
            return self.stepper.rates(t, y)
        except ArithmeticError as e:
            raise Leaves(str(e) or type(e).__name__, t) from e

    def at(self, t: Any) -> list[Any]:
        index = self.reach(t)
        step = self.steps[index]
        if t == step.t:
            return list(step.y)
        if (t - step.t) * self.direction > 0:
            index += 1
            step = self.steps[index]
        before = self.steps[index - 1]
        if t == before.t:
            return list(before.y)
        if not step.cells:
            if step.broken is not None and step.broken[0] == self.target:
                raise Leaves(step.broken[1].told, step.broken[1].reached) from step.broken[1]
            try:
                step.cells = self._cells(before.t, before.y, step.t, step.y, step.scales, 0)
            except Leaves as e:
                step.broken = self.target, e
                raise
        cell = next(c for c in step.cells if (t - c.b) * self.direction <= 0)
        return cell.at(t)

    def _cells(self, a: Any, ya: list[Any], b: Any, yb: list[Any], scales: list[float], depth: int) -> list[_Cell]:
        """Polynomials from a to b: one if it agrees with the equation between its nodes, else two halves, and so on."""
        n = self.level.nodes
        make, points = self.level.make, _places(n)[0]
        times = [a, *(a + (b - a) * make(x) for x in points[1:-1]), b]
        target = max(3, self.target // 2)
        states = [ya]
        for t0, t1 in pairwise(times[:-1]):
            states.append(self.stepper.advance(t0, states[-1], t1, target))
        states.append(yb)
        cell = self._hermite(a, b, times, states)
        middle = n // 2
        check = times[middle] + (times[middle + 1] - times[middle]) / 2
        true = self.stepper.advance(times[middle], states[middle], check, target)
        allowed = CHECKED * self.level.tolerance
        close = all(
            abs(float(p - q)) <= allowed * max(s, abs(float(q)))
            for p, q, s in zip(cell.at(check), true, scales, strict=True)
        )
        if close or depth >= DEPTH:
            if not close:
                raise Leaves("no polynomial follows the motion", a)
            return [cell]
        half, there = times[middle], states[middle]
        return [
            *self._cells(a, ya, half, there, scales, depth + 1),
            *self._cells(half, there, b, yb, scales, depth + 1),
        ]

    def _hermite(self, a: Any, b: Any, times: list[Any], states: list[list[Any]]) -> _Cell:
        """Divided differences over every node taken twice; the states relative to the first keep rounding small."""
        span = b - a
        order = _places(self.level.nodes)[1]
        nodes = [(times[i] - a) / span for i in order for _ in (0, 1)]
        rates = [[span * r for r in self.stepper.rates(times[i], states[i])] for i in order]
        column: list[list[Any]] = [states[i] for i in order for _ in (0, 1)]
        table = [column[0]]
        for k in range(1, len(nodes)):
            following = []
            for i in range(len(nodes) - k):
                gap = nodes[i + k] - nodes[i]
                if k == 1 and i % 2 == 0:
                    following.append(rates[i // 2])
                else:
                    following.append([(q - p) / gap for p, q in zip(column[i], column[i + 1], strict=True)])
            column = following
            table.append(column[0])
        return _Cell(a, b, tuple(nodes), table)

    def error(self, t: Any) -> tuple[list[float], list[float]]:
        """Bounds of the errors at t, and the sizes that the components have had."""
        index = self.reach(t)
        while len(self.shadow) <= index:
            a, b = self.steps[len(self.shadow) - 1], self.steps[len(self.shadow)]
            middle = a.t + (b.t - a.t) / 2
            y = self.stepper.advance(a.t, self.shadow[-1], middle, self.target, LOOSE)
            y = self.stepper.advance(middle, y, b.t, self.target, LOOSE)
            apart = [abs(float(p - q)) for p, q in zip(y, b.y, strict=True)]
            self.shadow.append(y)
            self.apart.append([max(p, q) for p, q in zip(self.apart[-1], apart, strict=True)])
        step = self.steps[index]
        rounding = self.level.unit * (4 + math.sqrt(index))
        within = CHECKED * self.level.tolerance if t != step.t else 0.0
        bounds = [
            4 * d + e + rounding * size + within * max(s, size)
            for d, e, size, s in zip(self.apart[index], step.error, step.sizes, step.scales, strict=True)
        ]
        return bounds, [max(size, 1e-3 * s) for size, s in zip(step.sizes, step.scales, strict=True)]


def _first_step(y: Sequence[Any], rates: Sequence[Any], span: float) -> float:
    """A careful first step: a hundredth of the shortest time in which a component would change by its size."""
    times = [abs(float(a)) / abs(float(b)) for a, b in zip(y, rates, strict=True) if a and b]
    return min([0.01 * t for t in times] + [span / 8])


class Flow:
    """The solution of y' = rhs(t, y) through y0 at t0.

    Up to 13 digits it is computed in floats; beyond in mpmath's numbers, or in decimals if y0 holds decimals: `rhs` is
    called with such numbers and returns such. `digits` sets the tolerance; what came out is told by `certain`.
    Leaves, an ArithmeticError with `reached`: the motion leaves the domain of rhs, becomes infinite, or needs more
    than `evaluations` of rhs (a million in floats and decimals, 300,000 in mpmath's numbers). `breaks`: times at which
    rhs has a corner, as where the lines of a table meet; from there it is followed anew. `floors`: sizes of components
    below which none counts as small.
    """

    def __init__(
        self,
        rhs: Rates,
        t0: Any,
        y0: Sequence[Any],
        digits: int = 20,
        evaluations: int | None = None,
        breaks: Sequence[Any] = (),
        floors: Sequence[float] = (),
    ) -> None:
        self.rhs, self.digits, self.evaluations = rhs, digits, evaluations
        self.floors = tuple(floors)
        self._parts: dict[int, Flow] = {}
        self.level = level_for(digits, any(isinstance(a, Decimal) for a in y0), evaluations)
        self.stepper = Stepper(rhs, self.level, floors)
        with self.level.context():
            self.t0 = self.level.make(t0)
            self.y0 = [self.level.make(a) for a in y0]
            self.breaks = sorted(b for b in map(self.level.make, breaks) if b != self.t0)
            after = next((b for b in self.breaks if b > self.t0), None)
            before = next((b for b in reversed(self.breaks) if b < self.t0), None)
            self._forward = _Branch(self.stepper, self.t0, self.y0, 1, after)
            self._backward = _Branch(self.stepper, self.t0, self.y0, -1, before)

    def _beyond(self, time: Any) -> Flow | None:
        """The flow from the next break on; None: the time lies before it."""
        side = 1 if time > self.t0 else -1
        ahead = [b for b in self.breaks if (b - self.t0) * side > 0][::side]
        if not ahead or (time - ahead[0]) * side <= 0:
            return None
        if side not in self._parts:
            there = self._branch(ahead[0]).at(ahead[0])
            rest = ahead[1:]
            self._parts[side] = Flow(self.rhs, ahead[0], there, self.digits, self.evaluations, rest, self.floors)
        return self._parts[side]

    def _branch(self, t: Any) -> _Branch:
        return self._forward if t >= self.t0 else self._backward

    def at(self, t: Any) -> list[Any]:
        """The state at a time, before or after t0."""
        with self.level.context():
            time = self.level.make(t)
            beyond = self._beyond(time)
            return self._branch(time).at(time) if beyond is None else beyond.at(time)

    def rates(self, t: Any) -> list[Any]:
        """The right-hand side at a time."""
        with self.level.context():
            time = self.level.make(t)
            return self.stepper.rates(time, self.at(time))

    def error(self, t: Any) -> list[float]:
        """A bound of the error of each component of at(t), as far as two runs can tell; made when first asked for."""
        with self.level.context():
            return self._error(self.level.make(t))[0]

    def _error(self, time: Any) -> tuple[list[float], list[float]]:
        """Bounds and sizes; errors of the parts before the last break add up."""
        beyond = self._beyond(time)
        if beyond is None:
            return self._branch(time).error(time)
        before, after = self._branch(beyond.t0).error(beyond.t0), beyond._error(time)
        return [a + b for a, b in zip(before[0], after[0], strict=True)], list(map(max, before[1], after[1]))

    def certain(self, t: Any) -> int:
        """So many digits of at(t) are certain, counted from the largest value each component had between t0 and t."""
        with self.level.context():
            time = self.level.make(t)
            bounds, sizes = self._error(time)
        worst = max((b / s for b, s in zip(bounds, sizes, strict=True) if s), default=0.0)
        return max(0, math.floor(-math.log10(max(worst, self.level.unit))))
