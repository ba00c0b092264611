"""Has a motion come to where it goes as the time goes on without end: to rest, or to velocities that stay?

What dies out, however slowly, has done so when over the later half of the time nothing changes any more beside the
tolerance; what goes round for ever, or slows down like a power of the time, never has.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import islice

from planar_cli.motion.trajectory.segment import Segment

NOISE = 10.0
"""Less than so many tolerances is what errors of steps make of it."""
FINEST = 1e-13
"""However small the tolerance is: so much the rounding of the velocities leaves."""
ROUNDING = 1e-9
"""A power of two is reached but for rounding."""
WITHIN = 4
"""Every step is looked at in so many places."""


def next_look(since: float, t: float, span: float) -> float:
    """The next time at which that is looked at: a power of two of time scales after the last state."""
    elapsed = (t - since) / span
    power = max(0, math.floor(math.log2(max(elapsed, 0.5)) + ROUNDING) + 1)
    return since + span * 2.0**power


def settled(segments: Sequence[Segment], since: float, scale: Sequence[float], tolerance: float) -> bool:
    """Do the velocities stay over the later half of the time since then; and, where these are zero, the places?"""
    t, y = segments[-1].t1, segments[-1].end
    half, least = len(y) // 2, NOISE * max(tolerance, FINEST)
    resting = all(abs(v) <= least * s for v, s in zip(y[half:], scale[half:], strict=True))
    first = 0 if resting else half
    return all(
        abs(a - b) <= least * s
        for state in _states(segments, 0.5 * (since + t))
        for a, b, s in islice(zip(state, y, scale, strict=True), first, None)
    )


def _states(segments: Sequence[Segment], begin: float) -> Iterator[Sequence[float]]:
    """The states since then, the latest first."""
    for segment in reversed(segments):
        if segment.t1 <= begin:
            return
        for step in reversed(segment.steps):
            for k in range(WITHIN):
                t = step.t1 - (step.t1 - step.t0) * k / WITHIN
                if begin <= t <= segment.t1:
                    yield step.at(t)
