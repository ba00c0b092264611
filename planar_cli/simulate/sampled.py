"""A motion as curves over the time: quantities at many moments, in pieces between which they may jump."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.integrators.base import OUTSIDE
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.language.expression import Side
from planar_cli.records import record
from planar_cli.simulate.run import Run

FEWEST = 2
"""A segment has at least so many moments beside its ends."""


@record
class Sampled:
    """One part of the motion: its moments [s], and the values of each quantity there (SI): a number, or x and y."""

    times: tuple[float, ...]
    values: tuple[tuple[tuple[float, ...], ...], ...]


def sampled(run: Run, sides: Sequence[Side], count: int) -> tuple[Sampled, ...]:
    """Some `count` moments over the whole motion, with the ends of every part and all states of the file among them.

    Where a quantity has no value, the curve is interrupted.
    """
    found: list[Sampled] = []
    for segment in run.trajectory.segments:
        if isinstance(segment.regime, Regime):
            found += _pieces(run, sides, segment, moments_of_segment(run.trajectory, segment, count))
    return tuple(found)


def moments_of_segment(trajectory: Trajectory, segment: Segment, count: int) -> list[float]:
    """Its part of `count` moments over the whole motion, with its ends and the states of the file."""
    t0, t1 = segment.t0, segment.t1
    if t1 <= t0:
        return [t0]
    many = FEWEST + math.ceil((t1 - t0) / (trajectory.t1 - trajectory.t0) * count)
    even = (t0 + (t1 - t0) * k / many for k in range(many))
    return sorted({*even, t1, *(e.t for e in trajectory.events if t0 < e.t < t1)})


def _pieces(run: Run, sides: Sequence[Side], segment: Segment, moments: Sequence[float]) -> Iterator[Sampled]:
    """A segment, in one piece unless something has no value in between."""
    assert isinstance(segment.regime, Regime)
    function = run.measures.several(sides, segment.regime)
    times: list[float] = []
    values: list[tuple[tuple[float, ...], ...]] = []
    for t in moments:
        run.measures.wind(t)
        try:
            now = tuple(tuple(v) for v in function(t, segment.at(t)))
            whole = all(math.isfinite(x) for v in now for x in v)
        except OUTSIDE:
            whole = False
        if whole:
            times.append(t)
            values.append(now)
        elif times:
            yield Sampled(tuple(times), tuple(values))
            times, values = [], []
    if times:
        yield Sampled(tuple(times), tuple(values))
