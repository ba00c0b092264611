"""Energy and momentum over a segment: what is there at the end, less what was there before and what came in.

The engine follows accelerations; that energy and momentum add up is a check by laws that it does not use.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from planar_cli.integrators.base import Step
from planar_cli.motion.automaton import Outside, Regime, Resultant
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
    note(t0, y0)
    before = regime.energy(t0, y0)
    work, size = (0.0, 0.0) if regime.conservative else _work(regime, t1, steps, note)
    swing = 0.0
    for step in steps[:-1]:
        note(step.t1, step.y1)
        swing = max(swing, abs(regime.energy(step.t1, step.y1) - before))
    note(t1, y1)
    after = regime.energy(t1, y1)
    scale = max(abs(after - before), size, swing, least)
    if outside is None:
        return Balance(after - before - work, scale, (), ())
    sums, sizes = _impulses(outside.at, t1, steps, note)
    note(t1, y1)
    old, new = regime.momentum(t0, y0), regime.momentum(t1, y1)
    off = tuple(b - a - s for a, b, s in zip(old, new, sums, strict=True))
    largest = tuple(max(abs(a), abs(b), *s) for a, b, *s in zip(old, new, sizes, outside.least, strict=True))
    return Balance(after - before - work, scale, off, largest)


def _impulses(outside: Resultant, t1: float, steps: Sequence[Step], note: Note) -> tuple[list[float], list[float]]:
    """The impulses that come in until t1, and the same without signs."""
    sums, sizes = [0.0] * 3, [0.0] * 3
    for step in steps:
        note(step.t0, step.y0)
        end = min(step.t1, t1)
        half, middle = (end - step.t0) / 2, (end + step.t0) / 2
        for x, weight in NODES:
            t = middle + half * x
            for k, value in enumerate(outside(t, step.at(t))):
                sums[k] += half * weight * value
                sizes[k] += abs(half * weight * value)
    return sums, sizes


def _work(regime: Regime, t1: float, steps: Sequence[Step], note: Note) -> tuple[float, float]:
    """The work that comes in until t1, and the same without signs [J]."""
    work = size = 0.0
    for step in steps:
        note(step.t0, step.y0)
        end = min(step.t1, t1)
        half, middle = (end - step.t0) / 2, (end + step.t0) / 2
        for x, weight in NODES:
            t = middle + half * x
            part = half * weight * regime.power(t, step.at(t))
            work += part
            size += abs(part)
    return work, size
