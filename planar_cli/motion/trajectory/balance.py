"""Energy and momentum over a segment: what is there at the end, less what was there before and what came in.

The engine follows accelerations; that energy and momentum add up is a check by laws that it does not use.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from planar_cli.integrators.base import OUTSIDE, Step
from planar_cli.motion.trajectory.automaton import Outside, Regime
from planar_cli.records import record

Note = Callable[[float, Sequence[float]], None]
NODES = (
    (-0.9061798459386640, 0.2369268850561891),
    (-0.5384693101056831, 0.4786286704993665),
    (0.0, 0.5688888888888889),
    (0.5384693101056831, 0.4786286704993665),
    (0.9061798459386640, 0.2369268850561891),
)
"""Gauss and Legendre with five points: exact for polynomials of degree nine."""
ALLOWED = 1e4
"""A balance may be off by so many times the tolerance: errors of many steps add up, and grow in unstable motions."""


@record
class Balance:
    """What does not add up."""

    energy: float
    """Energy at the end - energy at the beginning - work done meanwhile [J]."""
    energy_scale: float
    """The largest energy or work among them, counted from the lowest [J]."""
    momentum: tuple[float, ...]
    """The same of linear momentum x, y [N s] and of angular momentum about the origin [N m s], less the impulses of all
    forces from outside; () where these were not asked for."""
    momentum_scale: tuple[float, ...]
    """The largest of each."""

    @property
    def told(self) -> str:
        """What does not add up, in words."""
        found = [(abs(self.energy), self.energy_scale, "energy", "J")]
        kinds = (("linear momentum along x", "N s"), ("linear momentum along y", "N s"), ("angular momentum", "N m s"))
        for value, scale, (name, unit) in zip(self.momentum, self.momentum_scale, kinds, strict=False):
            found.append((abs(value), scale, name, unit))
        value, scale, name, unit = max(found, key=lambda f: f[0] / f[1] if f[1] else 0.0)
        return f"{name} does not add up: {value:.3g} {unit} of {scale:.3g} {unit}"

    @property
    def off(self) -> float:
        """The largest part of its scale by which one of them is off."""
        parts = [abs(self.energy) / self.energy_scale if self.energy_scale else 0.0]
        parts += [abs(p) / s for p, s in zip(self.momentum, self.momentum_scale, strict=True) if s]
        return max(parts)


def balance_of(
    regime: Regime,
    t0: float,
    y0: Sequence[float],
    t1: float,
    y1: Sequence[float],
    steps: Sequence[Step],
    least: float,
    note: Note,
    outside: Outside | None = None,
) -> Balance:
    """The balance of a segment; `least`: an energy that counts as usual in this scene [J]. `note` is told the states in
    their order, as angles and directions that go on count from the last one. `outside`: what acts from outside, where
    momentum is to be looked at too.
    """
    # Back the way it came, as turns are counted from what was noted last.
    for step in reversed(steps):
        note(step.t0, step.y0)
    note(t0, y0)
    before, old = regime.energy(t0, y0), regime.momentum(t0, y0)
    swing, work = 0.0, _Sum(1)
    impulse = _Sum(3)
    for step in steps:
        note(step.t0, step.y0)
        swing = max(swing, abs(regime.energy(step.t0, step.y0) - before))
        if regime.conservative and outside is None:
            continue
        for t, weight in nodes(step.t0, min(step.t1, t1)):
            y = step.at(t)
            if not regime.conservative:
                work.add(weight, (regime.power(t, y),))
            if outside is not None:
                try:
                    impulse.add(weight, outside.at(t, y))
                except OUTSIDE:
                    # Where the ends of a spring meet it pulls in no direction; that is looked at no further.
                    outside = None
    note(t1, y1)
    after, new = regime.energy(t1, y1), regime.momentum(t1, y1)
    scale = max(abs(after - before), work.sizes[0], swing, least)
    # What was put right is not hidden from the check.
    left = after - before - work.sums[0] - sum(step.supplied for step in steps)
    if outside is None:
        return Balance(left, scale, (), ())
    off = tuple(b - a - s for a, b, s in zip(old, new, impulse.sums, strict=True))
    largest = tuple(max(abs(a), abs(b), *s) for a, b, *s in zip(old, new, impulse.sizes, outside.least, strict=True))
    return Balance(left, scale, off, largest)


class _Sum:
    """Integrals of several functions, and the same without signs."""

    def __init__(self, count: int) -> None:
        self.sums, self.sizes = [0.0] * count, [0.0] * count

    def add(self, weight: float, values: Sequence[float]) -> None:
        """One node more."""
        for k, value in enumerate(values):
            self.sums[k] += weight * value
            self.sizes[k] += abs(weight * value)


def nodes(t0: float, t1: float) -> Iterator[tuple[float, float]]:
    """Times at which an interval is looked at, with their weights [s]."""
    half, middle = (t1 - t0) / 2, (t1 + t0) / 2
    return ((middle + half * x, half * weight) for x, weight in NODES)
