"""How good the numbers of a run are: its global error by a second run, and how fast the smallest error grows.

The error that an integrator keeps small is that of one step; what has come of all steps at the end is another matter:
in a chaotic motion a millionfold. It is measured by a second run with TIGHTER times the tolerance, whose own error is
negligible beside it, or with half the step (`by_halving`). On the reference problems
(tests/test_estimates.py) that is within a factor 10 of the truth, from the loosest tolerance down to rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from planar_cli.integrators.base import EPSILON
from planar_cli.records import record

TIGHTER = 1 / 32
"""The tolerance of the second run, in parts of that of the first. With an eighth both errors happen to agree now and
then: of a double pendulum 4 % of the error were told.
"""
TIGHTEST = 2e-15
"""A smaller tolerance has no meaning."""
LOST = 0.1
"""Where a difference has grown to this part of the scales no digit is left."""
STEADY = 0.1
"""What has not grown by more than ten since half of the time has made one jump, at an impact; it does not go on."""
GROWN = 100.0
"""A unit in the last place that has not grown by more than this grows no further in any way that matters."""


@record
class Estimate:
    """Numbers with their errors."""

    values: tuple[float, ...]
    errors: tuple[float, ...]
    """How far each may be off, in its own unit."""


@record
class Growth:
    """What becomes of a small difference at the start."""

    factor: float
    """By how much it has grown at the end."""
    horizon: float | None
    """The time beyond which one unit in the last place has grown to everything: digits mean nothing there. None: the
    difference does not grow like that."""
    extrapolated: bool
    """Does the horizon lie beyond the end of the run, and follow from how fast the difference has grown?"""


def tighter(tolerance: float) -> float:
    """The tolerance of the run to compare with."""
    return max(TIGHTER * tolerance, TIGHTEST)


def by_halving(order: int) -> float:
    """By what the difference from a run with half its step tells the error of a run with equal steps.

    A method of order p errs by C h^p, and with half the step by 2^-p of that, which is half of it for p = 1: the
    difference is the rest.
    """
    return 1.0 / (1.0 - 2.0**-order)


def estimated(run: Callable[[float], Sequence[float]], tolerance: float) -> Estimate:
    """The numbers that a run gives with a tolerance, and their errors. Both runs must meet the same events."""
    values, finer = run(tolerance), run(tighter(tolerance))
    return Estimate(tuple(values), tuple(abs(a - b) for a, b in zip(values, finer, strict=True)))


def shifts(scale: Sequence[float], size: float) -> list[float]:
    """A small displacement of a start, this part of the scales, in no special direction."""
    golden = math.pi * (3.0 - math.sqrt(5.0))
    return [size * s * math.cos(1.0 + golden * i) for i, s in enumerate(scale)]


def growth(differences: Sequence[tuple[float, float]], shift: float) -> Growth:
    """From the largest differences (time, part of the scales) of two runs that began `shift` apart."""
    so_far, curve = 0.0, []
    for t, difference in differences:
        so_far = max(so_far, difference)
        curve.append((t, so_far))
    (begin, _), (end, largest) = curve[0], curve[-1]
    factor = largest / shift
    # The least growth that carries a unit in the last place to LOST: the same curve, moved by shift/EPSILON.
    lost = LOST * shift / EPSILON
    reached = next((t for t, d in curve if d >= min(lost, LOST)), None)
    if reached is not None and lost <= LOST:
        return Growth(factor, reached, False)
    halfway = next(d for t, d in curve if t >= 0.5 * (begin + end))
    if factor <= GROWN or end == begin or halfway >= STEADY * largest:
        return Growth(factor, None, False)
    until = reached if reached is not None else end
    rate = math.log(min(largest, LOST) / shift) / (until - begin)
    return Growth(factor, begin + math.log(LOST / EPSILON) / rate, True)
