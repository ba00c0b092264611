"""Energy and momentum over a segment: what is there at the end, less what was there before and what came in.

The engine follows accelerations; that energy and momentum add up is a check by laws that it does not use.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from planar_cli.integrators.base import Step
from planar_cli.motion.automaton import Regime

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


@dataclass(frozen=True, slots=True)
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
    def off(self) -> float:
        """The largest part of its scale by which one of them is off."""
        parts = [abs(self.energy) / self.energy_scale if self.energy_scale else 0.0]
        parts += [abs(p) / s for p, s in zip(self.momentum, self.momentum_scale, strict=True) if s]
        return max(parts)


def balance_of(
    regime: Regime, t0: float, y0: Sequence[float], t1: float, y1: Sequence[float], steps: Sequence[Step], least: float
) -> Balance:
    """The balance of a segment; `least`: an energy that counts as usual in this scene [J]."""
    before, after = regime.energy(t0, y0), regime.energy(t1, y1)
    work = size = swing = 0.0
    for step in steps:
        end = min(step.t1, t1)
        half, middle = (end - step.t0) / 2, (end + step.t0) / 2
        for x, weight in NODES:
            t = middle + half * x
            y = step.at(t)
            power = regime.power(t, y)
            work += half * weight * power
            size += abs(half * weight * power)
        swing = max(swing, abs(regime.energy(end, step.at(end)) - before))
    scale = max(abs(after - before), size, swing, least)
    return Balance(after - before - work, scale, (), ())
