"""Several unknown constants found by shooting: the motion is followed with many of their values, and from those that
come nearest Newton's method leads on.

Every state after the first is told by one relation, by its time where that is given; what the states say besides are as
many equations as there are constants. Their residuals, in parts of their scales, are differentiated by differences.
Another solution, far from all starts, is not excluded: whoever uses this says that it was found by trial.

Reference: Stoer and Bulirsch, Introduction to Numerical Analysis, 7.3: the shooting method.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from planar_cli.problem.implied.not_negative import not_negative
from planar_cli.problem.language.expression import Relation, Statement
from planar_cli.problem.scene.scene import Problem, State, Symbol
from planar_cli.records import record
from planar_cli.simulate.shooting import motion_with, passes, scales_tried
from planar_cli.simulate.timetable import Timetable, is_time, mode_of
from planar_cli.units import PURE, parse_unit

STARTS, NEAREST = 400, 16
"""So many starts are tried at most, and so many of them, those that come nearest, are followed on."""
DECADES = 2.0
"""Sizes of constants are looked for within so many powers of ten about an ordinary one."""
SHIFT, ROUNDS = 1e-6, 30
"""Of a constant, for a difference; of Newton's method, at most."""
HOLDS, SAME = 1e-9, 1e-6
"""At a solution relations are off by less than this part of their scale; solutions closer than that are one."""
Residuals = Callable[[Sequence[float]], list[float] | None]


@record
class Shots:
    """What is left of the relations of the states when each of them is told by one."""

    problem: Problem
    """The problem with one relation for each state."""
    left: tuple[tuple[str, Relation], ...]
    """The others, with their states."""


def shooting_at_several(problem: Problem, known: Mapping[str, float]) -> list[dict[str, float]] | None:
    """Values of all unknowns with which the motion passes all states, in SI units, as far as they were found; None: the
    states do not say as much more than when they are, or there is one unknown alone. `known`: numbers of other names.
    """
    unknowns = problem.unknowns
    if len(unknowns) < 2 or problem.symbols:
        return None
    every = list(_shots(problem))
    sizes = _sizes(problem, known) if every else []
    sizes_alone = [i for i, u in enumerate(unknowns) if u.name in not_negative(problem)]
    usual: list[tuple[float, ...]] = []
    others: list[tuple[float, ...]] = []
    for start in _starts(unknowns, sizes) if every else ():
        (usual if all(start[i] >= 0 for i in sizes_alone) else others).append(start)
    # What can not be negative is looked for so only where nothing else fits, to be told.
    for starts in (usual, others):
        for shots in every:
            residuals = _residuals(shots, [u.name for u in unknowns], known)
            found = []
            for root in _roots(residuals, iter(starts), sizes):
                values = dict(zip((u.name for u in unknowns), root, strict=True))
                if passes(problem, {**known, **values}):
                    found.append(values)
            if found:
                return each_once(problem, found, known, sizes)
    return [] if every else None


def each_once(
    problem: Problem, found: Sequence[dict[str, float]], known: Mapping[str, float], sizes: Sequence[float]
) -> list[dict[str, float]]:
    """Each motion once. A direction by whole turns more is the same direction, unless something counts its turns: its
    angle is the one in (-180, 180] deg, or the one nearest to zero that the file allows.
    """
    angles = [u.name for u in problem.unknowns if _is_angle(u)]
    distinct: list[dict[str, float]] = []
    for values in sorted(found, key=lambda v: sum(abs(v[name]) for name in angles)):
        turned = {name: _within_a_turn(v) if name in angles else v for name, v in values.items()}
        alike = [v for v in distinct if _same([*_less(v, angles)], [*_less(turned, angles)], sizes)]
        if any(_same_motion(problem, {**known, **v}, {**known, **values}) for v in alike):
            continue
        allowed = turned != values and _same_motion(problem, {**known, **values}, {**known, **turned})
        distinct.append(turned if allowed else values)
    return distinct


def _less(values: Mapping[str, float], angles: Sequence[str]) -> Iterator[float]:
    """The constants in their order, angles within a turn."""
    yield from (_within_a_turn(v) if name in angles else v for name, v in values.items())


def _same_motion(problem: Problem, one: Mapping[str, float], other: Mapping[str, float]) -> bool:
    """Does it pass all states at the same times, places and velocities with these other values?"""
    runs = [run for values in (one, other) if (run := motion_with(problem, values)) is not None]
    moments = [run.measures.moments for run in runs]
    if len(runs) < 2 or any(state.name not in m for state in problem.states for m in moments):
        return False
    scales = [runs[0].model.scales.time, *runs[0].model.scale]
    for state in problem.states:
        a, b = ((m[state.name].t, *m[state.name].y) for m in moments)
        if any(abs(p - q) > SAME * max(abs(p), scale) for p, q, scale in zip(a, b, scales, strict=True)):
            return False
    return True


def _is_angle(unknown: Symbol) -> bool:
    unit = parse_unit(unknown.unit or "1")
    return unit.angle and unit.dimension == PURE


def _within_a_turn(angle: float) -> float:
    """The same direction in (-pi, pi]."""
    return angle if -math.pi < angle <= math.pi else math.pi - (math.pi - angle) % math.tau


def _shots(problem: Problem) -> Iterator[Shots]:
    """Every way of telling each state by one relation, by its time where that is given."""
    told = [[s for s in state.relations if _tells(s)] for state in problem.states[1:]]
    if not all(told) or sum(len(t) - 1 for t in told) != len(problem.unknowns):
        return
    for kept in product(*(_telling(t) for t in told)):
        left = [
            (state.name, r)
            for state, relations, one in zip(problem.states[1:], told, kept, strict=True)
            for r in relations
            if r is not one
        ]
        if not all(isinstance(r, Relation) and mode_of(r) is None for _, r in left):
            continue
        gone = [r for _, r in left]
        states = (problem.states[0], *(_without(s, gone) for s in problem.states[1:]))
        yield Shots(replace(problem, states=states), tuple((n, r) for n, r in left if isinstance(r, Relation)))


def _tells(statement: Statement) -> bool:
    return not isinstance(statement, Relation) or statement.operator == "="


def _telling(relations: Sequence[Statement]) -> list[Statement]:
    """The relations by which a state may be told, its time first: then all is open that else may happen by then. But
    many motions have come nearly to rest by then that never turn, as it is said: so the others tell it too.
    """
    times: list[Statement] = [r for r in relations if isinstance(r, Relation) and is_time(r)]
    return [*times[:1], *(r for r in relations if r not in times)]


def _without(state: State, gone: Sequence[Statement]) -> State:
    return replace(state, relations=tuple(r for r in state.relations if not any(r is g for g in gone)))


def _sizes(problem: Problem, known: Mapping[str, float]) -> list[float]:
    """An ordinary size of each unknown [SI]."""
    scales = scales_tried(problem, known)
    dimensions = [parse_unit(u.unit or "1").dimension for u in problem.unknowns]
    return [
        scales.length ** float(d.length) * scales.mass ** float(d.mass) * scales.time ** float(d.time)
        for d in dimensions
    ]


def _starts(unknowns: Sequence[Symbol], sizes: Sequence[float]) -> Iterator[tuple[float, ...]]:
    """Values of both signs, over some powers of ten; angles all round."""
    count = int(STARTS ** (1 / len(unknowns)))
    choices = []
    for unknown, size in zip(unknowns, sizes, strict=True):
        if _is_angle(unknown):
            choices.append([math.tau * k / count for k in range(count)])
            continue
        half = max(count // 2, 2)
        powers = [size * 10 ** (DECADES * (2 * k / (half - 1) - 1)) for k in range(half)]
        choices.append([*powers, *(-p for p in powers)])
    return product(*choices)


def _residuals(shots: Shots, names: Sequence[str], known: Mapping[str, float]) -> Residuals:
    def residuals(values: Sequence[float]) -> list[float] | None:
        # Most of these motions only show the way; the last one is balanced.
        run = motion_with(shots.problem, {**known, **dict(zip(names, values, strict=True))}, balanced=False)
        if run is None:
            return None
        table, found = Timetable(run.problem, run.measures), []
        for state, relation in shots.left:
            moment = run.measures.moments.get(state)
            off = [] if moment is None else run.measures.gap(relation, moment.regime)(moment.t, moment.y)
            if len(off) != 1:
                return None
            found.append(off[0] / table.scale(relation.left, relation.right))
        return found

    return residuals


# --- roots ------------------------------------------------------------------------------------------------------------


def _roots(
    residuals: Residuals, starts: Iterator[tuple[float, ...]], sizes: Sequence[float]
) -> list[tuple[float, ...]]:
    """Where all relations hold, as far as Newton's method gets there from the nearest of the starts."""
    tried = [(off, start) for start in starts if (off := residuals(start)) is not None]
    tried.sort(key=lambda pair: math.hypot(*pair[0]))
    found: list[tuple[float, ...]] = []
    for off, start in tried[:NEAREST]:
        root = _newton(residuals, start, off, sizes)
        # Beside an ordinary size, what is left of a zero is none.
        root = (
            None if root is None else tuple(0.0 if abs(x) <= HOLDS * s else x for x, s in zip(root, sizes, strict=True))
        )
        if root is not None and not any(_same(root, other, sizes) for other in found):
            found.append(root)
    return found


def _same(one: Sequence[float], other: Sequence[float], sizes: Sequence[float]) -> bool:
    return all(
        abs(a - b) <= SAME * max(abs(a), abs(b), SAME * size) for a, b, size in zip(one, other, sizes, strict=True)
    )


def _newton(
    residuals: Residuals, start: Sequence[float], off: list[float], sizes: Sequence[float]
) -> tuple[float, ...] | None:
    """Newton's method with steps that are halved until they lead nearer; None: it does not get there."""
    x = list(start)
    for _ in range(ROUNDS):
        if math.hypot(*off) <= HOLDS:
            return tuple(x)
        step = _step(residuals, x, off, sizes)
        better = None if step is None else _nearer(residuals, x, step, off)
        if better is None:
            return None
        x, off = better
    return None


def _step(residuals: Residuals, x: Sequence[float], off: list[float], sizes: Sequence[float]) -> list[float] | None:
    columns = []
    for i, size in enumerate(sizes):
        shift = SHIFT * max(abs(x[i]), SHIFT * size)
        beside = residuals([v + shift * (k == i) for k, v in enumerate(x)])
        if beside is None:
            return None
        columns.append([(b - a) / shift for a, b in zip(off, beside, strict=True)])
    slopes = np.array(columns).T
    weights = np.array([max(abs(v), SHIFT * size) for v, size in zip(x, sizes, strict=True)])
    return [float(v) for v in np.linalg.lstsq(slopes * weights, -np.array(off), rcond=None)[0] * weights]


def _nearer(
    residuals: Residuals, x: Sequence[float], step: Sequence[float], off: list[float]
) -> tuple[list[float], list[float]] | None:
    """The first of ever shorter steps that leads nearer, with what the relations are off there."""
    for k in range(10):
        there = [a + s / 2**k for a, s in zip(x, step, strict=True)]
        found = residuals(there)
        if found is not None and math.hypot(*found) < math.hypot(*off):
            return there, found
    return None
