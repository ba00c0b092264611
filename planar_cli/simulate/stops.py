"""Where a motion ends by `--stop`: the first instant at which one of the relations comes to hold."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.language.expression import Relation
from planar_cli.simulate.measures import Measures

LOOKS = 8
"""A step is looked at so many times."""
HALVINGS = 80


def first_stop(relations: Sequence[Relation], measures: Measures, trajectory: Trajectory) -> float | None:
    """When the first of the relations holds for the first time, after the start [s]; None: never."""
    for segment in trajectory.segments:
        times = [t for r in relations if (t := _within(r, measures, segment)) is not None]
        if times:
            return min(times)
    return None


def _within(relation: Relation, measures: Measures, segment: Segment) -> float | None:
    regime = segment.regime
    assert isinstance(regime, Regime)
    gap = measures.gap(relation, regime)

    def value(t: float) -> float:
        return gap(t, segment.at(t))[0]

    times = _looks(segment)
    before = value(times[0])
    for a, b in pairwise(times):
        after = value(b)
        crosses = after == 0.0 or (before < 0.0 < after) or (after < 0.0 < before)
        if crosses and (relation.operator == "=" or (after > 0) == (relation.operator in (">", ">="))):
            return _root(value, a, b)
        before = after
    return None


def _looks(segment: Segment) -> list[float]:
    ends = [(max(s.t0, segment.t0), min(s.t1, segment.t1)) for s in segment.steps] or [(segment.t0, segment.t1)]
    inside = [a + (b - a) * i / LOOKS for a, b in ends for i in range(LOOKS)]
    return [*inside, segment.t1]


def _root(value: Callable[[float], float], a: float, b: float) -> float:
    """Where the value changes its sign, by halving: sure, and quick enough for one root."""
    sign = value(a) < 0
    for _ in range(HALVINGS):
        middle = 0.5 * (a + b)
        if middle in (a, b):
            break
        if (value(middle) < 0) == sign:
            a = middle
        else:
            b = middle
    return b
