"""An unknown constant found by shooting: the motion is followed for many of its values, until all relations hold.

A state after the first is told by one relation; what it states besides is what the constant is sought for. As the
constant changes, the difference of the two sides of that relation changes its sign at a root; every sign change between
neighbouring values is bracketed, and the root counts where the motion then passes all states of the file.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from planar_cli.errors import PlanarError
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.scales import Scales
from planar_cli.problem.language.expression import Extreme, Name, Quantity, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem, State, Symbol
from planar_cli.records import record
from planar_cli.simulate.measures import modes_of
from planar_cli.simulate.run import Run, Settings, followed, prepared
from planar_cli.simulate.timetable import Timetable, chooses, is_time, mode_of
from planar_cli.units import PURE, parse_unit

DECADES, PER_DECADE = 4, 4
"""Within so many powers of ten about an ordinary size a constant is looked for, at so many values in each."""
DEGREES = 5
"""An angle is looked for all round, in steps of so many degrees."""
SHARES = 20
"""A restitution is looked for from 0 to 1 in so many steps."""
EDGE = 12
"""Where a state ceases to be reached, between two such values, is enclosed in so many steps."""
TOLERANCE = 1e-11
"""Of the steps of a motion, in parts of the scene's scales."""
TIMES, STEPS = 500.0, 1500
"""A state is looked for over so many characteristic times, and so many steps, at most."""
PROBED = 2.0
"""Over so many characteristic times it is looked whether a constant changes anything."""
PROBES, GOLDEN = 5, 0.6180339887498949
"""For so many values of it, which multiples of the golden ratio scatter."""
IN_A_ROW = 3
"""So many values in a row with which the steps do not suffice tell that they do not with larger ones."""
ROUNDS, CLOSE = 80, 1e-13
"""A root is enclosed in so many steps at most, up to this part of its size."""
SHORT = 1e-3
"""By this part of the way to it a secant stops short of the edge of what is reached, if it must."""
HOLDS = 1e-7
"""At a root the relation is off by less than this part of its scale; a jump through zero is none."""
NOTHING = 1e-9
"""Beside the least value that is tried, what is smaller than this part of it is zero."""
SAME = 1e-7
"""Roots that are apart by less than this part of the larger one are the same."""
Missed = Callable[[float], float | None]
"""By how much, in parts of its scale, a relation is off with a value; None: its state is not reached; not a number:
it has its time, and the steps do not suffice to come there.
"""
Shown = tuple[float, float]
"""A value of the constant, and by how much the relation is off with it."""


@record
class Shot:
    """What is left of one relation when the others tell the state."""

    problem: Problem
    """The problem without it."""
    state: str
    left: Relation


def shooting(problem: Problem, known: Mapping[str, float]) -> tuple[float, ...] | None:
    """All values of the only unknown with which the motion passes all states, in SI units, negative ones only where
    there are no others; None: the file has other unknowns, or not just one relation more than tells its states, or it
    is an extreme that chooses the constant. `known`: numbers of other names.
    """
    ways = list(shots(problem)) if len(problem.unknowns) == 1 and not problem.symbols else []
    if not ways or any(chooses(problem, state) for state in problem.states):
        return None
    unknown = problem.unknowns[0]
    for values in values_tried(problem, unknown, known):
        found: list[float] = []
        least = min(abs(v) for v in values if v)
        # A root may be one of a relation only that is left out of one of the states: each is tried.
        for shot in ways:
            for at in _roots(_missed(shot, unknown.name, known), values):
                root = 0.0 if abs(at) <= NOTHING * least else at
                new = not any(abs(root - other) <= SAME * max(abs(other), least) for other in found)
                if new and passes(problem, {**known, unknown.name: root}):
                    found.append(root)
        if found:
            return tuple(sorted(found))
    return ()


def has_no_effect(problem: Problem, known: Mapping[str, float]) -> bool:
    """Is all that the states say the same with several values of the only unknown, on motions that do not
    pass them?
    """
    ways = list(shots(problem)) if len(problem.unknowns) == 1 and not problem.symbols else []
    if not ways:
        return False
    values = next(values_tried(problem, problem.unknowns[0], known))
    # Not evenly: two angles with one cosine would tell nothing.
    tried = [values[round(k * GOLDEN % 1.0 * (len(values) - 1))] for k in range(1, PROBES + 1)]
    # Of a spring, say, that pushes only while it is compressed two of them might leave everything at rest.
    probes = [p for v in tried if (p := _sides(ways[0].problem, {**known, problem.unknowns[0].name: v}))]
    return len(probes) > 1 and all(_alike(one, other) for one, other in pairwise(probes))


def _alike(one: list[float], other: list[float]) -> bool:
    pairs = zip(one, other, strict=False)
    return len(one) == len(other) and all(abs(a - b) <= SAME * max(abs(a), abs(b)) for a, b in pairs)


def _sides(problem: Problem, values: Mapping[str, float]) -> list[float] | None:
    """How long the motion lasts that misses a state, and by how much the relations of its states are off as it ends;
    None: there is no such motion.
    """
    run = motion_with(problem, values, PROBED)
    if run is None or all(s.name in run.measures.moments for s in problem.states):
        return None
    told = [r for s in problem.states[1:] for r in telling(s)]
    relations = [r for r in told if isinstance(r, Relation) and mode_of(r) is None]
    if len(relations) < len(told):
        # A mode is no number that could be compared.
        return None
    others = {q.at for r in relations for q in walk(r) if isinstance(q, Quantity) and q.at is not None}
    if not run.trajectory.segments or not others <= set(run.measures.moments):
        return None
    last = run.trajectory.segments[-1]
    assert isinstance(last.regime, Regime)
    regime = last.regime
    return [last.t1, *(off for r in relations for off in run.measures.gap(r, regime)(last.t1, last.end))]


def shots(problem: Problem) -> Iterator[Shot]:
    """The relation that is one too many for a motion with known constants, in every way of telling its state."""
    much = [(s, n) for s in problem.states[1:] if (n := len(telling(s)) - 1) > 0]
    if [n for _, n in much] != [1]:
        return
    ((state, _),) = much
    if any(isinstance(r, Extreme) for r in state.relations):
        # What is largest there is so beside motions with other values, not of one that is followed.
        return
    for relation in telling(state):
        if not isinstance(relation, Relation) or is_time(relation) or mode_of(relation) is not None:
            continue
        less = replace(state, relations=tuple(r for r in state.relations if r is not relation))
        states = tuple(less if s is state else s for s in problem.states)
        yield Shot(replace(problem, states=states), state.name, relation)


def telling(state: State) -> list[Statement]:
    """The statements of which each would tell when a state is."""
    return [s for s in state.relations if not isinstance(s, Relation) or s.operator == "="]


def values_tried(problem: Problem, unknown: Symbol, known: Mapping[str, float]) -> Iterator[list[float]]:
    """Where the constant is looked for, in SI units: positive values, then much larger ones, then negative ones, then
    next to zero; an angle all round.
    """
    unit = parse_unit(unknown.unit or "1")
    if unit.angle and unit.dimension == PURE:
        yield [math.radians(d) for d in range(-180, 181, DEGREES)]
        return
    written = (getattr(joint, "restitution", None) for joint in problem.joints)
    if any(isinstance(e, Name) and e.name == unknown.name for e in written):
        yield [k / SHARES for k in range(SHARES + 1)]
        return
    scales = scales_tried(problem, known)
    d = unit.dimension
    size = scales.length ** float(d.length) * scales.mass ** float(d.mass) * scales.time ** float(d.time)
    positive = [size * 10 ** (k / PER_DECADE) for k in range(-DECADES * PER_DECADE, DECADES * PER_DECADE + 1)]
    yield positive
    # The ordinary size rests on the times of a motion with 1 for the constant, and a buffer may be much stiffer.
    yield [positive[-1] * 10 ** (k / PER_DECADE) for k in range(DECADES * PER_DECADE + 1)]
    yield [-v for v in positive]
    # Smaller ones than these, of either sign: what is off with nothing at all is mostly off the other way beyond them.
    yield [-positive[0], 0.0, positive[0]]


def scales_tried(problem: Problem, known: Mapping[str, float]) -> Scales:
    """The scales of the motion with 1 for every unknown, which need not be one that the file allows. What else the
    first state is to be may tell which of two starts it is.
    """
    first, sought = problem.states[0], {u.name for u in problem.unknowns}
    told = tuple(
        r
        for r in first.relations
        if not isinstance(r, Relation) or r.operator == "=" or sought.isdisjoint(_names_in(r))
    )
    less = replace(problem, assume=(), states=(replace(first, relations=told), *problem.states[1:]))
    return prepared(less, {**known, **{u.name: 1.0 for u in problem.unknowns}}).model.scales


def _names_in(relation: Relation) -> set[str]:
    return {n.name for n in walk(relation) if isinstance(n, Name)}


def _missed(shot: Shot, name: str, known: Mapping[str, float]) -> Missed:
    dated = any(is_time(r) for s in shot.problem.states if s.name == shot.state for r in s.relations)

    def missed(value: float) -> float | None:
        run = motion_with(shot.problem, {**known, name: value}, balanced=False)
        moment = None if run is None else run.measures.moments.get(shot.state)
        if dated and run is not None and moment is None and run.trajectory.outcome.kind == "long":
            return math.nan
        if run is None or moment is None or _acts_no_more(shot.left, moment.regime):
            return None
        scale = Timetable(run.problem, run.measures).scale(shot.left.left, shot.left.right)
        off = run.measures.gap(shot.left, moment.regime)(moment.t, moment.y)
        return off[0] / scale if len(off) == 1 else None

    return missed


def _acts_no_more(relation: Relation, regime: Regime) -> bool:
    """Does it speak of the force at a joint that has come apart? That it is zero there tells nothing."""
    forces = (q for q in walk(relation) if isinstance(q, Quantity) and q.word in ("N", "tension"))
    modes = modes_of(regime)
    return any(modes.get(q.things[0]) in ("apart", "slack") for q in forces)


def motion_with(
    problem: Problem, values: Mapping[str, float], times: float = TIMES, balanced: bool = True
) -> Run | None:
    """The motion with these numbers; None: with them there is none. `balanced`: see the settings."""
    settings = Settings(
        values=values, tolerance=TOLERANCE, estimate=False, times=times, most_steps=STEPS, balanced=balanced
    )
    try:
        return followed(prepared(problem, values), settings)
    except PlanarError:
        return None


def passes(problem: Problem, values: Mapping[str, float]) -> bool:
    """Does the motion pass all states of the file?"""
    run = motion_with(problem, values)
    return run is not None and all(s.name in run.measures.moments for s in problem.states)


# --- roots ------------------------------------------------------------------------------------------------------------


def _roots(missed: Missed, values: Sequence[float]) -> Iterator[float]:
    """Where a relation holds, between these values."""
    found = list(_tried(missed, values))
    for low, high in pairwise(found):
        ends = _reached(missed, low, high)
        root = None if ends is None else enclosed(missed, *ends)
        if root is None and ends is not None and None in (low[1], high[1]):
            root = _at_edge(missed, *(ends if low[1] is None else ends[::-1]))
        if root is not None:
            yield root


def _tried(missed: Missed, values: Sequence[float]) -> Iterator[tuple[float, float | None]]:
    """The values with what comes of them; where up to a given time the steps do not suffice with some in a row, as of
    what goes round faster and faster, they do not with larger ones.
    """
    grow, spent = all(abs(a) <= abs(b) for a, b in pairwise(values)), 0
    for value in values:
        off = missed(value)
        yield value, off
        spent = spent + 1 if off is not None and math.isnan(off) else 0
        if grow and spent == IN_A_ROW:
            return


def _reached(
    missed: Missed, low: tuple[float, float | None], high: tuple[float, float | None]
) -> tuple[Shown, Shown] | None:
    """Two values between which the state is reached; None: it is not, or that is not known."""
    (a, f), (b, g) = low, high
    if any(off is not None and math.isnan(off) for off in (f, g)):
        return None
    if f is None:
        return None if g is None else (_edge(missed, a, (b, g)), (b, g))
    return (a, f), (_edge(missed, b, (a, f)) if g is None else (b, g))


def _edge(missed: Missed, lost: float, reached: Shown) -> Shown:
    """The last value, from one that reaches a state towards one that does not, with which it is reached."""
    for _ in range(EDGE):
        middle = (lost + reached[0]) / 2
        f = missed(middle)
        if f is None or math.isnan(f):
            lost = middle
        else:
            reached = middle, f
    return reached


def _at_edge(missed: Missed, edge: Shown, inner: Shown) -> float | None:
    """The root where the state ceases to be reached, as where a contact is only just kept: the relation tends to it
    from one side alone, so it is approached by secants that stop a little before it. None: there is no such root.
    """
    (x, f), (y, g) = edge, inner
    for _ in range(ROUNDS):
        if abs(f) <= TOLERANCE:
            return x
        if f * g <= 0 or abs(f) >= abs(g):
            return None
        root = x - f * (x - y) / (f - g)
        stop, share = root, 0.0
        h = missed(stop)
        while h is None and share < 1.0:
            share = 2 * share or SHORT
            stop = root + share * (x - root)
            h = missed(stop)
        if h is None or math.isnan(h):
            return x if abs(f) <= HOLDS else None
        (y, g), (x, f) = (x, f), (stop, h)
    return x if abs(f) <= HOLDS else None


def enclosed(missed: Missed, low: Shown, high: Shown, tolerance: float = TOLERANCE) -> float | None:
    """The root between two values, up to this part of the scale of the relation; None: there is no change of sign, or a
    jump. By false position; an end that stays counts half.

    Reference: Dowell and Jarratt, A modified regula falsi method, BIT 11 (1971), the Illinois variant.
    """
    (a, f), (b, g) = low, high
    if f == 0 or f * g >= 0:
        return a if f == 0 else None
    for _ in range(ROUNDS):
        x = (a * g - b * f) / (g - f)
        h = missed(x)
        if h is None or math.isnan(h):
            return None
        if abs(h) <= tolerance or abs(b - a) <= CLOSE * max(abs(a), abs(b)):
            return x if abs(h) <= HOLDS else None
        if h * g < 0:
            a, f = b, g
        else:
            f /= 2
        b, g = x, h
    return None
