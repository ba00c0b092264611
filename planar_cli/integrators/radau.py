"""The implicit method Radau IIA with five stages, on plain lists."""

from __future__ import annotations

import math
from typing import ClassVar, final

from planar_cli.integrators._adaptive import Adaptive, Method
from planar_cli.integrators._linear import Factors
from planar_cli.integrators._radau_tableau import (
    COMPLEX,
    COMPLEX_ROWS,
    COMPLEX_VECTORS,
    ERROR,
    NODES,
    REAL,
    REAL_ROW,
    REAL_VECTOR,
)
from planar_cli.integrators.base import EPSILON, OUTSIDE, Counts, Rates, Setting, Vector, norm

STAGES = len(NODES)
APART = [c * math.prod(c - d for d in NODES if d != c) for c in NODES]
"""The products of the differences of each node from the others and from the start: Lagrange's denominators."""
FORGETTING = 0.8
"""From step to step, what is known of the convergence is trusted less: this power of it."""
ITERATIONS = 10
"""Newton's method converges within so many iterations, or the step is too long."""
SOLVED = 1e-3
"""The stages are solved to this part of what the tolerance allows."""
STALE = 1e-2
"""Slower convergence asks for a new Jacobian matrix."""
Stages = list[Vector]
"""What is added to the state at the start of a step, for each of its stages."""


@final
class Radau(Adaptive):
    """Radau IIA with five stages and order 9, implicit, with step control.

    Meaning
        For stiff scenes: its steps follow what moves slowly, however stiff the rest. A vibration much faster than the
        steps dies out in it, so what remains is the motion without that vibration. The stages are solved by Newton's
        method; the Jacobian matrix comes from differences and is kept as long as it serves.

    Equations
        Y_i = y + h Σ_j a_ij f(t + c_j h, Y_j),   i = 1 … 5     y(t + h) = Y_5

    Valid when
        The rates are smooth between the ends of a run.

    Reference
        E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.5, IV.8.
    """

    kind: ClassVar[str] = "radau"
    order: ClassVar[int] = 9
    implicit: ClassVar[bool] = True

    def method(self, f: Rates, setting: Setting, counts: Counts, y: Vector) -> Method:
        return _Steps(f, setting, counts, y)


class Collocation:
    """Dense output: the polynomial of degree five through the start and the stages."""

    __slots__ = ("_stages", "_t", "_y", "h")

    def __init__(self, t: float, y: Vector, h: float, stages: Stages, new: Vector) -> None:
        self._t, self._y, self.h = t, y, h
        # The end may have been projected since.
        self._stages = [*stages[:-1], [b - a for a, b in zip(y, new, strict=True)]]

    def __call__(self, t: float) -> Vector:
        x = (t - self._t) / self.h
        away = [x - c for c in NODES]
        if 0.0 in away:
            return [v + a for v, a in zip(self._y, self._stages[away.index(0.0)], strict=True)]
        whole = x * math.prod(away)
        p, q, r, s, u = [whole / (a * d) for a, d in zip(away, APART, strict=True)]
        return [
            v + p * a + q * b + r * c + s * d + u * e for v, a, b, c, d, e in zip(self._y, *self._stages, strict=True)
        ]


@final
class _Steps(Method):
    """The steps of one run; keeps the Jacobian matrix and the factors from step to step.

    All matrices are those of the components in parts of their scales, so that pivots are compared without units.
    """

    safety: ClassVar[float] = 0.9
    least: ClassVar[float] = 0.2
    most: ClassVar[float] = 6.0
    keep: ClassVar[float] = 1.2
    power: ClassVar[float] = 1 / (STAGES + 1)

    def __init__(self, f: Rates, setting: Setting, counts: Counts, y: Vector) -> None:
        self.f, self.setting, self.counts = f, setting, counts
        self.weights = setting.weights(y)
        self.scale = list(setting.scale)
        self.enough = SOLVED if setting.step is None else 0.0
        self.jacobian: list[list[float]] = []
        """Empty when a new one is due."""
        self.fresh = False
        """Is it that of the start of this step?"""
        self.h = 0.0
        """The length of the step whose factors are at hand."""
        self.left = 1.0
        """What Newton's method leaves after an iteration, in parts of its change, as far as the last step tells."""
        self.stages: Stages = []
        self.last: Collocation | None = None

    def begin(self, t: float, y: Vector, rates: Vector) -> None:
        self.t, self.y, self.rates = t, y, rates
        self.fresh = False

    def renew(self, y: Vector, ahead: float) -> None:
        self.weights = self.setting.weights(y)

    def trial(self, h: float, again: bool) -> tuple[Vector, float]:
        """With an old Jacobian matrix first, if there is one; a large error is filtered twice if `again`."""
        rate = self._solved(h)
        if not self.stages and not self.fresh:
            self.jacobian = []
            rate = self._solved(h)
        if not self.stages:
            return self.y, math.inf
        error = self._error(h, self.stages, again)
        if rate > STALE and not self.fresh:
            self.jacobian = []
        return [a + b for a, b in zip(self.y, self.stages[-1], strict=True)], error

    def inside(self, new: Vector, after: Vector) -> Collocation:
        self.last = Collocation(self.t, self.y, self.h, self.stages, new)
        return self.last

    def _solved(self, h: float) -> float:
        """Solve for the stages, [] if that fails; returns the rate of convergence."""
        try:
            self._prepare(h)
            self.stages, rate = self._newton(h, self.last, self.enough)
        except OUTSIDE:
            self.stages, rate = [], math.inf
        return rate

    def _prepare(self, h: float) -> None:
        """The Jacobian matrix and the factors of γ/h - J for the real and the complex eigenvalues."""
        if not self.jacobian:
            self.jacobian, self.fresh, self.h, self.left = self._differences(), True, 0.0, 1.0
        if h != self.h:
            self.real = Factors(self._shifted(REAL / h))
            self.complex = [Factors(self._shifted_complex(c / h)) for c in COMPLEX]
            self.counts.factorisations += 1
            self.h = h

    def _shifted(self, gamma: float) -> list[list[float]]:
        rows = [[-a for a in row] for row in self.jacobian]
        for i, row in enumerate(rows):
            row[i] += gamma
        return rows

    def _shifted_complex(self, gamma: complex) -> list[list[complex]]:
        rows = [[complex(-a) for a in row] for row in self.jacobian]
        for i, row in enumerate(rows):
            row[i] += gamma
        return rows

    def _differences(self) -> list[list[float]]:
        """∂f/∂y by forward differences, in parts of the scales."""
        columns = []
        for i, s in enumerate(self.scale):
            ahead = list(self.y)
            ahead[i] += math.sqrt(EPSILON) * max(abs(ahead[i]), s)
            small = ahead[i] - self.y[i]
            moved = self.f(self.t, ahead)
            columns.append([(b - a) / small * s for a, b in zip(self.rates, moved, strict=True)])
        self.counts.evaluations += len(columns)
        self.counts.jacobians += 1
        return [[column[i] / s for column in columns] for i, s in enumerate(self.scale)]

    def _newton(self, h: float, last: Collocation | None, enough: float) -> tuple[Stages, float]:
        """The stages, [] if they do not converge, and the rate of convergence."""
        stages = self._guess(h, last)
        size, rate, before = 0.0, 0.0, math.inf
        self.left = max(self.left, EPSILON) ** FORGETTING
        for k in range(ITERATIONS):
            rates = [
                self.f(self.t + c * h, [a + b for a, b in zip(self.y, z, strict=True)])
                for c, z in zip(NODES, stages, strict=True)
            ]
            self.counts.evaluations += STAGES
            change = self._correction(h, stages, rates)
            stages = [[a + b for a, b in zip(z, d, strict=True)] for z, d in zip(stages, change, strict=True)]
            size = math.sqrt(sum([norm(d, self.weights) ** 2 for d in change]) / STAGES)
            if not size < math.inf:
                return [], math.inf
            rate = size / before if k else 0.0
            if k and rate >= 1.0:
                # Rounding is reached, or there is no convergence.
                return (stages, 0.0) if before <= 0.1 else ([], math.inf)
            if k:
                self.left = rate / (1.0 - rate)
            if self.left * size <= enough:
                return stages, rate
            before = size
        return (stages, rate) if size <= 0.1 else ([], math.inf)

    def _guess(self, h: float, last: Collocation | None) -> Stages:
        """The stages to begin with: the last step's polynomial goes on, if the new step is not much longer."""
        if last is None or abs(h) > 2.0 * abs(last.h):
            return [[0.0] * len(self.y) for _ in NODES]
        return [[b - a for a, b in zip(self.y, last(self.t + c * h), strict=True)] for c in NODES]

    def _correction(self, h: float, stages: Stages, rates: Stages) -> Stages:
        """One iteration of the simplified Newton method: what to add to the stages."""
        scale, n = self.scale, len(self.scale)
        gamma = REAL / h
        right = [
            sum([p * (r - gamma * z) for p, r, z in zip(REAL_ROW, f, s, strict=True)]) / size
            for f, s, size in zip(zip(*rates, strict=True), zip(*stages, strict=True), scale, strict=True)
        ]
        found = self.real.solve(right)
        change = [[v * a for a in found] for v in REAL_VECTOR]
        for value, row, vector, factors in zip(COMPLEX, COMPLEX_ROWS, COMPLEX_VECTORS, self.complex, strict=True):
            delta = value / h
            wanted = [
                sum([p * (r - delta * z) for p, r, z in zip(row, f, s, strict=True)]) / size
                for f, s, size in zip(zip(*rates, strict=True), zip(*stages, strict=True), scale, strict=True)
            ]
            part = factors.solve(wanted)
            for i, v in enumerate(vector):
                line = change[i]
                change[i] = [line[j] + (v * part[j]).real for j in range(n)]
        return [[a * s for a, s in zip(line, scale, strict=True)] for line in change]

    def _error(self, h: float, stages: Stages, again: bool) -> float:
        """The error of an embedded method of order 5, through (1 - h J/γ)⁻¹, which takes stiff parts out of it."""
        ahead = [sum([e * z for e, z in zip(ERROR, parts, strict=True)]) for parts in zip(*stages, strict=True)]
        errors = self._filtered(h, self.rates, ahead)
        size = norm(errors, self.weights)
        if size > 1.0 and again:
            self.counts.evaluations += 1
            try:
                moved = self.f(self.t, [a + b for a, b in zip(self.y, errors, strict=True)])
            except OUTSIDE:
                return size
            size = norm(self._filtered(h, moved, ahead), self.weights)
        return size

    def _filtered(self, h: float, rates: Vector, ahead: Vector) -> Vector:
        gamma = REAL / h
        right = [(r + gamma * a) / s for r, a, s in zip(rates, ahead, self.scale, strict=True)]
        return [a * s for a, s in zip(self.real.solve(right), self.scale, strict=True)]
