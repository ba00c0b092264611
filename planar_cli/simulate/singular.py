"""Singular positions on the way of a motion, as the change point of a parallelogram linkage: there the conditions of
some joints depend on each other, so that they do not fix how it goes on, nor the forces of these joints, which grow
without bound on the way there.

They are found where the volume that the rows of the conditions span, each of length one, has a minimum of zero.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise

from planar_cli.integrators.base import OUTSIDE
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.source import compiled
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.nodes.reading import listed
from planar_cli.records import record
from planar_cli.simulate.measures import Moment
from planar_cli.simulate.run import Run
from planar_cli.simulate.table import HERE

EACH, MOST = 4, 4000
"""Looked at within each step, and in a whole motion."""
DEEP, NIL = 0.5, 1e-5
"""A minimum below this part of the largest volume is looked at; one below this is zero."""
GOLDEN, CUTS = (math.sqrt(5) - 1) / 2, 40
SHARE = 1e-4
"""A condition with less than this part in the dependence has none."""
BESIDE, NEARER, GROWS = 0.1, 0.02, 2.5
"""Forces at these parts of a sample beside a position, and by how much more the nearer ones are where they grow like
1/distance.
"""
TOLD = 3
"""So many times are told of more."""


@record
class SingularPosition:
    """Where a motion passes through positions in which the same joints depend on each other."""

    times: tuple[float, ...]
    """s."""
    joints: tuple[str, ...]
    in_line: tuple[str, ...]
    """Their points, where these lie on one line then."""
    unbounded: bool
    """Do their forces grow without bound on the way there?"""

    @property
    def words(self) -> str:
        """As a sentence."""
        some = [f"{t:.4g} s" for t in self.times[:TOLD]]
        many = len(self.times) - len(some)
        when = f"{', '.join(some)} and {many} times more" if many else listed(some, "and")
        joints = f"the joints {listed(self.joints, 'and')}"
        place = f"{listed(self.in_line, 'and')} lie on one line (a change point)"
        place = place if self.in_line else f"the conditions of {joints} depend on each other (a singular position)"
        forces = f"there the forces of {joints} are not determined, and they grow without bound on the way there; "
        forces = forces if self.unbounded else "there the joints would also let it go on in another way; "
        return f"at t = {when} {place}: {forces}it goes on as it was moving"


@record
class _Found:
    t: float
    joints: tuple[str, ...]
    in_line: tuple[str, ...]
    unbounded: bool


def singular_positions(run: Run) -> tuple[SingularPosition, ...]:
    """All of a motion, those of the same joints together."""
    segments = run.trajectory.segments
    steps = sum(len(s.steps) for s in segments)
    each = max(1, min(EACH, MOST // max(steps, 1)))
    groups: dict[tuple[str, ...], list[_Found]] = {}
    for found in (f for s in segments if isinstance(s.regime, Regime) for f in _of_segment(run, s, s.regime, each)):
        groups.setdefault(found.joints, []).append(found)
    return tuple(
        SingularPosition(tuple(f.t for f in same), joints, same[0].in_line, any(f.unbounded for f in same))
        for joints, same in groups.items()
    )


def _of_segment(run: Run, segment: Segment, regime: Regime, each: int) -> Iterator[_Found]:
    kept = [regime.constraints[k] for k in regime.parts.independent.kept]
    if len(kept) < 2 or not segment.steps:
        return
    layout, length = regime.layout, regime.parts.scales.length
    sizes = [1.0 if s.kind == "theta" else length for s in layout.slots]
    numbers = compiled([t for c in kept for t in c.row.values()], layout.state, layout.time).function

    def rows(t: float) -> list[list[float]]:
        entries = iter(numbers(t, _state(segment, t)))
        return [_unit({i: next(entries) * sizes[i] for i in c.row}, layout.count) for c in kept]

    def spanned(t: float) -> float:
        return _volume(rows(t))

    samples = [(t, spanned(t)) for t in _times(segment, each)]
    largest = max((v for _, v in samples), default=0.0)
    for k, (_, volume) in enumerate(samples):
        before, after = samples[max(k - 1, 0)], samples[min(k + 1, len(samples) - 1)]
        if volume > DEEP * largest or volume > before[1] or volume >= after[1]:
            continue
        t, least = _least(spanned, before[0], after[0])
        if least <= NIL * largest:
            joints = _dependent(rows(t), [c.joint for c in kept])
            place = _in_line(run, joints, Moment(regime, {}, t, tuple(segment.at(t))))
            yield _Found(t, joints, place, _grows(segment, regime, joints, t, after[0] - before[0]))


def _state(segment: Segment, t: float) -> Sequence[float]:
    """The state at a time, as the step there has it: it closes the joints but for the error of the step."""
    k = min(bisect_right(segment.steps, t, key=lambda step: step.t1), len(segment.steps) - 1)
    return segment.steps[k].at(t)


def _times(segment: Segment, each: int) -> list[float]:
    """From the beginning of a segment to its end."""
    ends = [segment.t0, *(s.t1 for s in segment.steps if s.t1 < segment.t1), segment.t1]
    return [a + (b - a) * i / each for a, b in pairwise(ends) for i in range(each)] + [segment.t1]


def _unit(row: dict[int, float], count: int) -> list[float]:
    size = math.sqrt(math.fsum(v * v for v in row.values())) or 1.0
    return [row.get(i, 0.0) / size for i in range(count)]


def _volume(rows: list[list[float]]) -> float:
    """What rows of length one span: 1 where they stand perpendicular to each other, 0 where they depend."""
    whole, across = 1.0, list[list[float]]()
    for row in rows:
        left = row
        for other in across:
            share = math.fsum(a * b for a, b in zip(left, other, strict=True))
            left = [a - share * b for a, b in zip(left, other, strict=True)]
        size = math.sqrt(math.fsum(a * a for a in left))
        whole *= size
        if size:
            across.append([a / size for a in left])
    return whole


def _least(function: Callable[[float], float], low: float, high: float) -> tuple[float, float]:
    """The minimum between two times, and its value, by golden sections."""
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    fa, fb = function(a), function(b)
    for _ in range(CUTS):
        if fa < fb:
            high, b, fb = b, a, fa
            a = high - GOLDEN * (high - low)
            fa = function(a)
        else:
            low, a, fa = a, b, fb
            b = low + GOLDEN * (high - low)
            fb = function(b)
    return (a, fa) if fa < fb else (b, fb)


def _dependent(rows: list[list[float]], joints: Sequence[str]) -> tuple[str, ...]:
    """The joints whose conditions have a part in the dependence."""
    # Few motions come to a singular position.
    import numpy as np

    shares = np.abs(np.linalg.svd(np.array(rows))[0][:, -1])
    own = [name for name, share in zip(joints, shares, strict=True) if share > SHARE * max(shares) and name]
    return tuple(sorted(set(own)))


def _in_line(run: Run, joints: Iterable[str], moment: Moment) -> tuple[str, ...]:
    """The points of pins that lie on one line, along it; (): they do not, or there are fewer than three."""
    at = {j.name: getattr(j, "at", None) for j in run.problem.joints}
    names = list(dict.fromkeys(p for j in joints if isinstance(p := at.get(j), str)))
    try:
        places = {n: run.measures.at(Quantity("r", (n,), None, (), None, HERE), moment) for n in names}
    except OUTSIDE:
        return ()
    if len(places) < 3:
        return ()
    (x, y), far = places[names[0]], max(places.values(), key=lambda p: math.dist(p, places[names[0]]))
    size = math.dist(far, (x, y))
    along = ((far[0] - x) / size, (far[1] - y) / size) if size else (0.0, 0.0)
    if any(abs((p[0] - x) * along[1] - (p[1] - y) * along[0]) > SHARE * size for p in places.values()):
        return ()
    return tuple(sorted(names, key=lambda n: (places[n][0] - x) * along[0] + (places[n][1] - y) * along[1]))


def _grows(segment: Segment, regime: Regime, joints: Sequence[str], t: float, beside: float) -> bool:
    """Do the forces of some joints grow like one over the distance to a position?"""
    own = [k for k, push in enumerate(regime.reactions) if push.joint in joints]

    def size(part: float) -> float:
        near = [t + part * beside, t - part * beside]
        forces = [regime.forces(at, segment.at(at)) for at in near if segment.t0 < at < segment.t1]
        return max((abs(f[k]) for f in forces for k in own), default=0.0)

    return size(NEARER) > GROWS * size(BESIDE)
