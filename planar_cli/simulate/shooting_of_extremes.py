"""The value of an unknown constant for which something is largest or smallest at a state that something else dates.

The motion is followed for many values of the constant. The best of them is an interior one, where the derivative with
respect to the constant vanishes, or the last one with which the state is still reached, and all inequalities hold.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from planar_cli.problem.language.expression import Extreme
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.records import record
from planar_cli.simulate.run import Run
from planar_cli.simulate.shooting import motion_with, telling, values_tried
from planar_cli.simulate.timetable import chooses

NARROW = 0.02
"""An interior extreme is first enclosed between values that differ by this part of the first enclosure."""
GOLDEN = 0.381966011250105
STENCIL = ((1, 45.0), (2, -9.0), (3, 1.0))
"""Central differences of sixth order: weights of f(x + k h) - f(x - k h), in parts of 60 h."""
HALVINGS = 60
"""An edge of reach, or a zero of the derivative, is enclosed in so many steps at most."""
CLOSE, CLOSE_TO_EDGE = 1e-10, 1e-6
"""Up to this part of its size."""
FLAT = 1e-8
"""What differs by less than this part of its size, between neighbouring values, is the same."""
Size = Callable[[float], float | None]
"""What is to be largest, with a value of the constant; None: the state is not reached."""
Allowed = Callable[[Run], bool]
"""Do the inequalities of the file hold on a motion?"""


@record
class Best:
    """A value of the constant."""

    value: float
    """In SI units."""
    size: float
    """How large is what is to be largest."""
    state: str = ""
    """The state that beyond this value is no more reached as it is told; "": the value lies among others that do."""


def best_value(problem: Problem, known: Mapping[str, float], allowed: Allowed) -> Best | None:
    """The best value of the only unknown; None: this is not what the file asks for, or none is best among those
    that are tried. `known`: numbers of other names.
    """
    if len(problem.unknowns) != 1 or problem.symbols:
        return None
    choosing = [s for s in problem.states[1:] if chooses(problem, s)]
    if len(choosing) != 1 or any(len(telling(s)) > 1 for s in problem.states[1:] if s is not choosing[0]):
        return None
    (state,) = choosing
    extremes = [r for r in state.relations if isinstance(r, Extreme)]
    if len(extremes) != 1 or len(telling(state)) != 2:
        return None
    size = _size(problem, state, extremes[0], known, allowed)
    for values in values_tried(problem, problem.unknowns[0], known):
        found = _best(size, values)
        if found is not None:
            return replace(found, state=state.name) if found.state else found
    return None


def _size(problem: Problem, state: State, extreme: Extreme, known: Mapping[str, float], allowed: Allowed) -> Size:
    less = replace(state, relations=tuple(r for r in state.relations if r is not extreme))
    others = replace(problem, states=tuple(less if s is state else s for s in problem.states))
    name = problem.unknowns[0].name

    def size(value: float) -> float | None:
        run = motion_with(others, {**known, name: value})
        moment = None if run is None else run.measures.moments.get(state.name)
        if run is None or moment is None or not allowed(run):
            return None
        return extreme.sense * run.measures.function(extreme.side, moment.regime)(moment.t, moment.y)[0]

    return size


def _best(size: Size, values: Sequence[float]) -> Best | None:
    """The best of all candidates; None: it is the first or last of the values, or there is none."""
    sizes = [size(v) for v in values]
    found: list[Best] = []
    for k in range(1, len(values) - 1):
        low, high, here = sizes[k - 1], sizes[k + 1], sizes[k]
        if here is not None and low is not None and high is not None and _stands_out(low, here, high):
            inner = _interior(size, values[k - 1], values[k + 1])
            found += [] if inner is None else [inner]
    for (a, f), (b, g) in pairwise(zip(values, sizes, strict=True)):
        if f is None and g is not None:
            found.append(_edge(size, a, Best(b, g)))
        if f is not None and g is None:
            found.append(_edge(size, b, Best(a, f)))
    best = max(found, key=lambda one: one.size, default=None)
    ends = [s for s in (sizes[0], sizes[-1]) if s is not None]
    return None if best is None or any(s > best.size for s in ends) else best


def _stands_out(low: float, here: float, high: float) -> bool:
    """Is it larger than beside it? What is the same with many values is largest with none of them."""
    return low <= here >= high and 2 * here - low - high > FLAT * max(abs(low), abs(here), abs(high))


def _edge(size: Size, lost: float, reached: Best) -> Best:
    """The last value with which the state is reached, from one with which it is towards one with which it is not."""
    for _ in range(HALVINGS):
        if abs(lost - reached.value) <= CLOSE_TO_EDGE * max(abs(lost), abs(reached.value)):
            break
        middle = (lost + reached.value) / 2
        f = size(middle)
        if f is None:
            lost = middle
        else:
            reached = Best(middle, f)
    return replace(reached, state="lost")


def _interior(size: Size, a: float, b: float) -> Best | None:
    """Where the derivative vanishes between two values; None: the state is not reached all the way."""
    h = NARROW * (b - a)
    while b - a > h:
        left, right = golden_section(a, b)
        f, g = size(left), size(right)
        if f is None or g is None:
            return None
        a, b = (a, right) if f > g else (left, b)
    p, q = _slope(size, a, h), _slope(size, b, h)
    for _ in range(HALVINGS):
        if p is None or q is None or p * q > 0:
            return None
        x = a if p == 0 else b if q == 0 else (a * q - b * p) / (q - p)
        if min(abs(x - a), abs(x - b)) <= CLOSE * max(abs(a), abs(b)):
            break
        r = _slope(size, x, h)
        if r is None:
            return None
        if p * r <= 0:
            b, q = x, r
        else:
            a, p = x, r
    here = size(x)
    return None if here is None else Best(x, here)


def golden_section(a: float, b: float) -> tuple[float, float]:
    """The two values between others at which a section that is golden looks."""
    return a + GOLDEN * (b - a), b - GOLDEN * (b - a)


def _slope(size: Size, x: float, h: float) -> float | None:
    """The derivative with respect to the constant, times 60 h."""
    total = 0.0
    for k, weight in STENCIL:
        after, before = size(x + k * h), size(x - k * h)
        if after is None or before is None:
            return None
        total += weight * (after - before)
    return total
