"""States that are told by a quantity over the span up to them, `work(push) @ 1->2 = 40 J`, put at their times.

No step of a motion knows what has come together behind it. The motion is followed without the state, the quantity is
added up along it from step to step, and the state is where the relation first holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import pairwise

from planar_cli.errors import Diagnostic, NoSolution, Undecided
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.crossings import root
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Name, Number, Part, Quantity, Relation, Side
from planar_cli.problem.language.walk import changed, walk
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.simulate.answers import Answers
from planar_cli.simulate.measures import Measures, Moment
from planar_cli.simulate.run import Run, Settings, follow, prepared
from planar_cli.simulate.spans import Spans

GROWING = frozenset(("path_length", "work", "heat", "impulse", "mean"))
"""What comes together little by little; what is counted jumps."""
HORIZONS = (1.0, 16.0, 256.0, 2048.0)
"""So many ordinary times the motion is followed, further each time, until the relation has held."""
LOOKS = 4
"""In every step it is looked at so often."""
TOLERANCE, MOST_STEPS = 1e-12, 6000
HOLDS = 1e-7
"""At its zero a difference is smaller than this part of its sides: what jumps through zero is none."""
NOTHING = 1e-12
"""A way that is smaller than this part of the one that is told is none."""
Value = Callable[[float], tuple[float, float]]
"""Both sides of the relation at a time."""


def span_relation(state: State) -> Relation | None:
    """The equation that alone dates a state, if it speaks of a quantity over a span that ends there; None: it has none,
    or others besides.
    """
    told = [r for r in state.relations if not isinstance(r, Relation) or r.operator == "="]
    if len(told) != 1 or not isinstance(told[0], Relation):
        return None
    spans = [n for n in walk(told[0]) if isinstance(n, Quantity) and isinstance(n.at, tuple)]
    ends = [isinstance(q.at, tuple) and q.at[1] == state.name and q.word in GROWING for q in spans]
    return told[0] if ends and all(ends) else None


def dated_by_spans(problem: Problem, known: Mapping[str, float]) -> Problem | None:
    """The problem with such states at their times; the same object where there are none. None: nothing begins to move,
    though something is to. `known`: numbers of letters and of finds of earlier cases. NoSolution: it never comes so
    far; Undecided: that is not known.
    """
    for k, state in enumerate(problem.states):
        relation = span_relation(state) if k else None
        if relation is not None:
            time = _time(problem, k, relation, known)
            if time is None:
                return None
            dated = replace(state, relations=(*_at(state, time).relations, *_others(state, relation)))
            problem = replace(problem, states=(*problem.states[:k], dated, *problem.states[k + 1 :]))
    return problem


def with_spans_dated(problem: Problem, known: Mapping[str, float]) -> Problem:
    """The same, where a motion is to be followed in any case. NoSolution: nothing begins to move, too."""
    dated = dated_by_spans(problem, known)
    if dated is None:
        state = next(s for s in problem.states if span_relation(s) is not None)
        text = f"state {state.name} is never reached: {state.relations[0].text}"
        raise NoSolution([Diagnostic(state.mark, "PL621", text, "nothing begins to move")])
    return dated


def _speaks_of_spans(side: Side) -> bool:
    return any(isinstance(n, Quantity) and isinstance(n.at, tuple) for n in walk(side))


def _others(state: State, relation: Relation) -> Iterator[Relation]:
    """The inequalities of a state."""
    return (r for r in state.relations if isinstance(r, Relation) and r is not relation)


def _at(state: State, time: float) -> State:
    number = Number(Fraction(time), "s", 1, state.mark)
    return replace(state, relations=(Relation(Name("t", None, state.mark), "=", number, "", state.mark),))


def _time(problem: Problem, k: int, relation: Relation, known: Mapping[str, float]) -> float | None:
    """When the relation of the state at this place first holds [s]; None: no way is gone at all."""
    ordinary = prepared(replace(problem, states=problem.states[:k]), known).model.time_scale
    nearest = math.nan
    for horizon in HORIZONS:
        run = _followed(problem, k, ordinary * horizon, known)
        along = _Along(run, problem.states[k], problem.states[k - 1].name, relation)
        found = along.first()
        if found is not None:
            return found
        nearest = along.nearest
        if _is_over(run):
            break
    else:
        text = f"not decided, as far as the motion was followed it does not come to `{relation.text}`"
        raise Undecided(f"{relation.mark.file}:{relation.mark.line}: {text}")
    if math.isnan(nearest) or abs(nearest) <= NOTHING:
        return None
    state, told = problem.states[k], relation.text.split("=")[0 if _speaks_of_spans(relation.left) else 1].strip()
    words = "the way" if told.startswith("path_length") else told
    far = f"as far as the motion goes on, {words} comes to {100 * nearest:.4g} % of that"
    text = f"state {state.name} is never reached: {relation.text}"
    raise NoSolution([Diagnostic(state.mark, "PL621", text, far)])


def _followed(problem: Problem, k: int, time: float, known: Mapping[str, float]) -> Run:
    """The motion up to a time; the state at this place, and those behind it, are not looked for."""
    begun = prepared(replace(problem, states=problem.states[:1]), known).start.t
    later = tuple(_at(s, begun + (1 + i) * time) for i, s in enumerate(problem.states[k:]))
    states = (*problem.states[:k], *later)
    settings = Settings(begun + time, TOLERANCE, values=known, estimate=False, balanced=False, most_steps=MOST_STEPS)
    return follow(replace(problem, states=states, find=(), answers=()), settings)


def _is_over(run: Run) -> bool:
    """Is the motion over, or everything at rest for good?"""
    trajectory = run.trajectory
    return trajectory.t1 < run.until or not trajectory.segments or not trajectory.segments[-1].steps


class _Along:
    """The relation of a state along a motion."""

    def __init__(self, run: Run, state: State, since: str, relation: Relation) -> None:
        self.run, self.state, self.since = run, state, since
        self.answers = Answers(run.problem, run.measures, run.trajectory, {})
        self.answers.spans = _Growing(run.measures, run.trajectory, self.answers.scope)
        varying = {"t", *run.model.scene.coordinates}

        def here(side: Side) -> Side | None:
            if isinstance(side, Quantity):
                return replace(side, at=state.name) if side.at is None else side
            return replace(side, at=state.name) if isinstance(side, Name) and side.name in varying else None

        sides = (changed(relation.left, here), changed(relation.right, here))
        self.sides = sides if _speaks_of_spans(relation.left) else sides[::-1]
        """What is added up, and what it is to be."""
        self.nearest = math.nan
        """Which part of what it is to be it comes to at most."""

    def first(self) -> float | None:
        """The first time after the state before at which it holds; None: there is none."""
        begun = self.run.measures.moments.get(self.since)
        if begun is None:
            return None
        for segment in self.run.trajectory.segments:
            value = partial(self._off, segment)
            for a, b in pairwise(_looks(segment, begun.t)):
                if (value(a) > 0) != (value(b) > 0):
                    time = root(value, a, b)
                    left, right = self._values(segment, time)
                    if time > begun.t and abs(left - right) <= HOLDS * max(abs(left), abs(right)):
                        return time
        return None

    def _off(self, segment: Segment, t: float) -> float:
        left, right = self._values(segment, t)
        share = left / right if right else math.nan
        self.nearest = share if math.isnan(self.nearest) else max(self.nearest, share)
        return left - right

    def _values(self, segment: Segment, t: float) -> tuple[float, float]:
        """Both sides at a time of a segment."""
        assert isinstance(segment.regime, Regime)
        self.run.measures.moments[self.state.name] = Moment(segment.regime, {}, t, tuple(segment.at(t)))
        (left,), (right,) = (self.answers.value(side) for side in self.sides)
        return left, right


def _looks(segment: Segment, since: float) -> Iterator[float]:
    """Times at which it is looked at, from one on."""
    for step in segment.steps:
        a, b = max(step.t0, since), min(step.t1, segment.t1)
        yield from (a + (b - a) * i / LOOKS for i in range(LOOKS) if b > a)
    if segment.t1 > since:
        yield segment.t1


class _Growing(Spans):
    """Quantities over spans that are asked again and again at later times: what is known is not added up anew."""

    def __init__(self, measures: Measures, trajectory: Trajectory, scope: Scope) -> None:
        super().__init__(measures, trajectory, scope)
        self._known: dict[tuple[Quantity, float], tuple[float, tuple[float, ...]]] = {}
        """By the quantity and the beginning of its span: up to when it is known, and what it is there."""

    def _integral(
        self, q: Quantity, t0: float, t1: float, made: Callable[[Quantity, Regime], list[Term]]
    ) -> tuple[float, ...]:
        return self._grown(q, t0, t1, lambda a, b: super(_Growing, self)._integral(q, a, b, made))

    def _length(self, q: Quantity, t0: float, t1: float) -> tuple[float, ...]:
        return self._grown(q, t0, t1, lambda a, b: super(_Growing, self)._length(q, a, b))

    def _part(self, found: tuple[float, ...], part: Part, q: Quantity) -> tuple[float, ...]:
        if len(found) == 2 and part.kind in ("x", "y"):
            return (found["xy".index(part.kind)],)
        return super()._part(found, part, q)

    def _grown(
        self, q: Quantity, t0: float, t1: float, over: Callable[[float, float], tuple[float, ...]]
    ) -> tuple[float, ...]:
        until, known = self._known.get((q, t0), (t0, ()))
        if t1 < until:
            return over(t0, t1)
        more = over(until, t1) if t1 > until else ()
        total = tuple(a + b for a, b in zip(known, more, strict=True)) if known and more else known or more
        if not total:
            return over(t0, t1)
        self._known[q, t0] = t1, total
        return total
