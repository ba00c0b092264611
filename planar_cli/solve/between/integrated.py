"""The equations of motion of every stretch, as they were derived, integrated beside the motion that was followed.

What was followed comes from position residuals and wrenches of all bodies; the equations of motion come from the
balances that the solution prints. Both start a stretch alike: where they agree along it, each confirms the other.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping

import sympy as sp

from planar_cli.errors import NoValue
from planar_cli.integrators.base import Setting, StepTooSmall, Vector
from planar_cli.motion.drive import drive
from planar_cli.solve.between.events import FollowedSegment
from planar_cli.solve.regimes.regime import number_function

TOLERANCE = 1e-12
LOOKS = 4
"""So often a stretch is looked at."""


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
    f = number_function([changes[s] for s in letters], [regime.time, *letters], segment.value)

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
