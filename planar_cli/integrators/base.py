"""The contract of the shelf of integrators: y' = f(t, y) from one time to another, step by step.

A member is one file with one final class, named as its `kind`; its docstring is its manual page. It gives

1. `kind`, `order`, `adaptive`, `implicit`;
2. `steps`, a generator of accepted steps that ends exactly at t1 and counts its work in `counts`;
3. in every step the rates at both ends and `inside`, the solution between them (dense output), made when asked for.

Tolerances are relative to scales that the caller gives, one for each component: an error of `tolerance * scale[i]` in
component i is as bad as one of `tolerance * scale[j]` in j. So nothing depends on units. Where a component has grown so
large that this is below its rounding, its rounding counts.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

from planar_cli.errors import Undecided
from planar_cli.records import changing, record

Vector = list[float]
Rates = Callable[[float, Vector], Vector]
"""f(t, y): the rates of all components."""
Project = Callable[[float, Vector], Vector]
"""The state brought back onto the constraints."""
Limit = Callable[[Vector], float]
"""From a state to the longest step."""

EPSILON = 2.0**-52
ROUNDING = 8 * EPSILON
"""The part of a component that is taken as its rounding."""
SHORTEST = 16 * EPSILON
"""Steps below this part of the time, or of the whole run, make no progress."""
MOST_STEPS = 400_000
"""More steps than that in one run are refused."""
LEAP = 1e4
"""What moves a state by more than so many times the error allowed in a step does not mend it, but leads elsewhere: to
another branch on which joints hold as well."""
OUTSIDE = (ArithmeticError, ValueError)
"""What rates raise where a trial state lies outside of what they are defined for: the step is tried again, shorter."""


class StepTooSmall(Undecided):
    """The steps became too short, or too many: a singular position, or rates that are not smooth."""

    def __init__(self, message: str, t: float, y: Sequence[float]) -> None:
        self.t, self.y = t, list(y)
        super().__init__(message)


class TooManySteps(StepTooSmall):
    """More steps than a run may make."""


@changing
class Counts:
    """The work that was done."""

    steps: int = 0
    rejected: int = 0
    evaluations: int = 0
    jacobians: int = 0
    factorisations: int = 0


@record
class Step:
    """One accepted step from (t0, y0) to (t1, y1)."""

    t0: float
    y0: Vector
    r0: Vector
    """The rates at its start."""
    t1: float
    y1: Vector
    r1: Vector
    """The rates at its end."""
    inside: Callable[[float], Vector]
    """The solution at a time between the ends."""
    error: float = 0.0
    """The estimated error in parts of what the tolerance allows in one step; 0 where there is no estimate."""
    fastest: float = 0.0
    """An estimate [1/s] of how fast the fastest motion goes; 0 where it was not measured."""
    supplied: float = 0.0
    """The energy that its end was given so that none is lost [J]."""

    def at(self, t: float) -> Vector:
        """The state at a time in the step; its ends are exact."""
        if t == self.t1:
            return list(self.y1)
        return list(self.y0) if t == self.t0 else self.inside(t)


@record
class Setting:
    """How exactly to integrate."""

    scale: Sequence[float]
    """The size of each component; none is zero."""
    tolerance: float = 1e-9
    """The error allowed in one step, in parts of `scale`."""
    step: float | None = None
    """A fixed step, cut to a whole number of equal ones; without it an adaptive method chooses."""
    first: float | None = None
    """The first step to try."""
    longest: float = math.inf
    """No step is longer."""
    limit: Limit | None = None
    """Nor is one that begins in a state longer than this tells; fixed steps are not asked."""
    project: Project | None = None
    """Applied to the end of every accepted step."""
    most_steps: int = MOST_STEPS
    """When to give up."""

    def leaps(self, y: Vector, projected: Vector) -> bool:
        """Has the projection led to another branch?"""
        allowed = LEAP * self.tolerance
        most = zip(y, projected, self.scale, strict=True)
        return any(abs(a - b) > allowed * max(s, abs(a)) for a, b, s in most) if allowed < 1.0 else False

    def longest_from(self, y: Vector) -> float:
        """The longest step from a state."""
        return self.longest if self.limit is None else min(self.longest, self.limit(y))

    def weights(self, y: Sequence[float]) -> Vector:
        """1 / the error allowed, for each component."""
        tolerance = self.tolerance
        return [1.0 / max(tolerance * s, ROUNDING * abs(v)) for s, v in zip(self.scale, y, strict=True)]


class Integrator(ABC):
    """A method of integration. `kind`: its name on the command line. An instance serves one run and keeps `counts`."""

    kind: ClassVar[str]
    order: ClassVar[int]
    adaptive: ClassVar[bool]
    """Does it choose its steps by the tolerance?"""
    implicit: ClassVar[bool] = False
    """Does it take steps much longer than the fastest motion of a stiff scene?"""
    peer: ClassVar[str] = ""
    """The package that it comes from, if it is not our own."""

    def __init__(self) -> None:
        self.counts = Counts()

    @abstractmethod
    def steps(self, f: Rates, t0: float, y0: Sequence[float], t1: float, setting: Setting) -> Iterator[Step]:
        """The accepted steps from t0 to t1, forward or backward in time. Raises StepTooSmall."""

    def available(self) -> bool:
        """Is the package installed that it comes from?"""
        return True


def norm(errors: Sequence[float], weights: Sequence[float]) -> float:
    """The root mean square of errors, each in parts of what is allowed."""
    total = sum([(e * w) ** 2 for e, w in zip(errors, weights, strict=True)])
    return math.sqrt(total / len(errors)) if errors else 0.0


def shortest_step(t: float, t0: float, t1: float) -> float:
    """Below this length a step at t makes no progress."""
    return SHORTEST * max(abs(t), abs(t1 - t0))


def first_step(f: Rates, t0: float, y0: Vector, r0: Vector, t1: float, order: int, setting: Setting) -> float:
    """A first step (> 0) for a method of this order, from the rates and how they change (Hairer, Nørsett, Wanner II.4).

    Sizes come from `scale`, not from the start values, which may all be zero: a body at rest. Where even the rates are
    zero, a millionth of the run is tried, and grows from there.
    """
    run = abs(t1 - t0)
    direction = math.copysign(1.0, t1 - t0)
    size = [1.0 / s for s in setting.scale]
    speed = norm(r0, size)
    trial = min(0.01 / speed, run) if speed * run > 1e-6 else 1e-6 * run
    ahead = [a + direction * trial * r for a, r in zip(y0, r0, strict=True)]
    try:
        change = norm([b - a for a, b in zip(r0, f(t0 + direction * trial, ahead), strict=True)], size) / trial
    except OUTSIDE:
        return 1e-3 * trial
    # The rate of change of the rates is that of a power series: y'' h²/2, …, of which `order` + 1 terms are exact.
    fastest = max(speed, math.sqrt(change))
    if fastest * run <= 1e-6:
        return min(1e-3 * run, setting.longest)
    allowed: float = (0.01 * setting.tolerance) ** (1.0 / (order + 1)) / fastest
    return min(100.0 * trial, allowed, run, setting.longest)
