"""By how much a motion misses a state with the value of an unknown constant with which it comes nearest to it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.simulate.shooting import Shot, motion_with, shots, values_tried
from planar_cli.simulate.shooting_of_extremes import golden_section

NARROW = 1e-6
"""The value is enclosed up to this part of the distance of two that are tried."""
Miss = Callable[[float], float | None]
"""By how much the sides of a relation differ with a value [SI]; None: what else the state says does not come."""


@record
class Nearest:
    """Where a motion comes nearest to a state."""

    value: float
    """Of the unknown, in SI units."""
    relation: Relation
    """The one that does not hold there, where the others of the state do."""
    off: float
    """By how much its sides differ, in SI units."""


def nearest(problem: Problem, known: Mapping[str, float], mark: Mark) -> Nearest | None:
    """The nearest miss of the relation that stands at the mark, over all values of the only unknown; None: it is not
    one relation more than tells the states, or it comes nearer towards the ends of what is tried.
    """
    if len(problem.unknowns) != 1 or problem.symbols:
        return None
    shot = next((s for s in shots(problem) if s.left.mark == mark), None)
    if shot is None:
        return None
    miss = _miss(shot, problem.unknowns[0].name, known)
    values = next(values_tried(problem, problem.unknowns[0], known))
    value = _least(miss, values)
    off = None if value is None else miss(value)
    return None if value is None or off is None else Nearest(value, shot.left, off)


def _miss(shot: Shot, name: str, known: Mapping[str, float]) -> Miss:
    def miss(value: float) -> float | None:
        run = motion_with(shot.problem, {**known, name: value}, balanced=False)
        moment = None if run is None else run.measures.moments.get(shot.state)
        if run is None or moment is None:
            return None
        off = run.measures.gap(shot.left, moment.regime)(moment.t, moment.y)
        return abs(off[0]) if len(off) == 1 else None

    return miss


def _least(miss: Miss, values: Sequence[float]) -> float | None:
    """The value with the least miss, by golden section about the best of those that are tried."""
    found = [(m, k) for k, v in enumerate(values) if (m := miss(v)) is not None]
    if not found or not 0 < min(found)[1] < len(values) - 1:
        return None
    best = min(found)[1]
    a, b = values[best - 1], values[best + 1]
    narrow = NARROW * (b - a)
    while b - a > narrow:
        left, right = golden_section(a, b)
        f, g = miss(left), miss(right)
        if f is None and g is None:
            return None
        a, b = (a, right) if g is None or (f is not None and f < g) else (left, b)
    return (a + b) / 2
