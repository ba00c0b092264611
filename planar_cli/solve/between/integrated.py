"""The equations of motion of every stretch, as they were derived, integrated beside the motion that was followed.

What was followed comes from position residuals and wrenches of all bodies; the equations of motion come from the
balances that the solution prints. Both start a stretch alike: where they agree along it, each confirms the other.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

import sympy as sp

from planar_cli.errors import NoValue
from planar_cli.integrators.base import Setting, StepTooSmall, Vector
from planar_cli.motion.drive import drive
from planar_cli.solve.between.events import FollowedSegment
from planar_cli.solve.regimes.regime import number_function

TOLERANCE = 1e-12
LOOKS = 4
"""So often a stretch is looked at."""


def apart(segments: Iterable[FollowedSegment], sizes: Mapping[sp.Symbol, float]) -> float | None:
    """The largest difference of a letter along the stretches, in parts of its size; None: an equation of motion has no
    value on the way, or its steps become too small.
    """
    try:
        return max((_apart(s, sizes) for s in segments if s.t1 > s.t0 and s.regime.letters[1:]), default=0.0)
    except (NoValue, StepTooSmall):
        return None


def _apart(segment: FollowedSegment, sizes: Mapping[sp.Symbol, float]) -> float:
    regime, letters = segment.regime, segment.regime.letters[1:]
    changes = {**regime.rates, **regime.accelerations}
    f = number_function([changes[s] for s in letters], regime.letters, segment.value)

    def rates(t: float, y: Vector) -> Vector:
        return f(t, *y)

    times = [segment.t0 + (segment.t1 - segment.t0) * k / LOOKS for k in range(1, LOOKS + 1)]
    known = [segment.at(t) for t in times]
    scale = [max([sizes[s], *(abs(here[s]) for here in known)]) for s in letters]
    run = drive(rates, segment.t0, [segment.start[s] for s in letters], segment.t1, Setting(scale, TOLERANCE))
    pairs = (
        (a, here[s], size)
        for t, here in zip(times, known, strict=True)
        for a, s, size in zip(run.at(t), letters, scale, strict=True)
    )
    return max((abs(a - b) / size for a, b, size in pairs), default=0.0)


def digits(difference: float) -> int:
    """How many digits agree."""
    return min(15, int(-math.log10(difference))) if difference > 0 else 15
