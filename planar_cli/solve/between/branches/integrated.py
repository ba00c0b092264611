"""The equations of motion of every stretch, as they were derived, integrated beside the motion that was followed.

What was followed comes from position residuals and wrenches of all bodies; the equations of motion come from the
balances that the solution prints. Both start a stretch alike: where they agree along it, each confirms the other.

An equation of motion may divide by what passes through zero on the way (v_x = -y v_y / x of a particle on a string that
turns through x = 0). The motion itself goes on, but nothing can be integrated across such a pole: the stretch is
compared on both sides of it, each side from where the motion that was followed is.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import pairwise, takewhile

import sympy as sp

from planar_cli.errors import NoValue
from planar_cli.integrators.base import Setting, StepTooSmall, Vector
from planar_cli.motion.trajectory.drive import drive
from planar_cli.solve.between.roots.events import FollowedSegment
from planar_cli.solve.regimes.regime import number_function

TOLERANCE = 1e-12
LOOKS = 4
"""So often a stretch is looked at."""
NEAR_POLE = 0.02
"""Next to a pole a divisor is smaller than this part of its largest value: nothing is compared there."""


def apart(
    segments: Iterable[FollowedSegment], sizes: Mapping[sp.Symbol, float], sought: Mapping[str, Collection[sp.Symbol]]
) -> float | None:
    """The largest difference along the stretches of a letter, in parts of its size; None: an equation of motion has no
    value on the way, its steps become too small, or nothing was integrated at all. `sought`: by the state that ends a
    stretch, the letters that must agree, by "" those of any other; with them all that their equations of motion hold.
    """
    try:
        found = [_apart(s, sizes, sought.get(s.reaches, sought[""])) for s in segments if s.t1 > s.t0]
        return max((off for off in found if off is not None), default=None)
    except (NoValue, StepTooSmall):
        return None


def _apart(segment: FollowedSegment, sizes: Mapping[sp.Symbol, float], sought: Collection[sp.Symbol]) -> float | None:
    """The same of one stretch; None: none of these letters moves in it."""
    regime = segment.regime
    changes = {**regime.rates, **regime.accelerations}
    letters = _joined(sought, changes)
    if not letters:
        return None
    exprs = [sp.sympify(changes[s]) for s in letters]
    f = number_function(exprs, [regime.time, *letters], segment.value)

    def rates(t: float, y: Vector) -> Vector:
        return f(t, *y)

    def compared(t0: float, t1: float) -> float:
        times = [t0 + (t1 - t0) * k / LOOKS for k in range(1, LOOKS + 1)]
        known = [segment.at(t) for t in times]
        scale = [max([sizes[s], *(abs(here[s]) for here in known)]) for s in letters]
        start = segment.at(t0)
        run = drive(rates, t0, [start[s] for s in letters], t1, Setting(scale, TOLERANCE))
        pairs = (
            (a, here[s], size)
            for t, here in zip(times, known, strict=True)
            for a, s, size in zip(run.at(t), letters, scale, strict=True)
        )
        return max((abs(a - b) / size for a, b, size in pairs), default=0.0)

    parts = _between_poles(segment, _divisors(exprs, letters), letters)
    return max((compared(t0, t1) for t0, t1 in parts), default=None)


def _divisors(exprs: Iterable[sp.Expr], letters: Collection[sp.Symbol]) -> list[sp.Expr]:
    """What the expressions divide by, as far as these letters stand in it and its sign may change."""
    powers = {p for x in exprs for p in x.atoms(sp.Pow) if p.exp.is_Integer and p.exp.is_negative}
    found = {p.base for p in powers if p.base.free_symbols.intersection(letters)}
    # A distance has no other sign anywhere, so that the whole stretch need not be looked at for it.
    return sorted((d for d in found if not (d.is_nonnegative or d.is_nonpositive)), key=sp.default_sort_key)


def _between_poles(
    segment: FollowedSegment, divisors: Sequence[sp.Expr], letters: Sequence[sp.Symbol]
) -> list[tuple[float, float]]:
    """The parts of a stretch over which no divisor changes its sign."""
    if not divisors:
        return [(segment.t0, segment.t1)]
    times = segment.looks(segment.t1)
    f = number_function(divisors, [segment.regime.time, *letters], segment.value)
    seen = [f(t, *(here[s] for s in letters)) for t in times for here in (segment.at(t),)]
    poles = {step for values in zip(*seen, strict=True) for step in _next_to_poles(values)}
    steps = [(t0, t1) for step, (t0, t1) in enumerate(pairwise(times)) if step not in poles and t1 > t0]
    parts: list[tuple[float, float]] = []
    for t0, t1 in steps:
        if parts and parts[-1][1] == t0:
            parts[-1] = (parts[-1][0], t1)
        else:
            parts.append((t0, t1))
    return parts


def _next_to_poles(values: Sequence[float]) -> set[int]:
    """The steps over which the values change their sign, and those beside them in which they are small."""
    small = NEAR_POLE * max(abs(v) for v in values)
    found = set()
    for step, (a, b) in enumerate(pairwise(values)):
        if a * b <= 0:
            found.add(step)
            found |= set(takewhile(lambda i: abs(values[i + 1]) < small, range(step - 1, -1, -1)))
            found |= set(takewhile(lambda i: abs(values[i]) < small, range(step + 1, len(values) - 1)))
    return found


def _joined(sought: Collection[sp.Symbol], changes: Mapping[sp.Symbol, sp.Expr]) -> list[sp.Symbol]:
    """These letters, and all on which their rates of change rest."""
    found: set[sp.Symbol] = set()
    more = {s for s in sought if s in changes}
    while more:
        found |= more
        more = {s for x in more for s in sp.sympify(changes[x]).free_symbols if s in changes} - found
    return [s for s in changes if s in found]


def digits(difference: float) -> int:
    """How many digits agree."""
    return min(15, int(-math.log10(difference))) if difference > 0 else 15
