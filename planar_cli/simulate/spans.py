"""Quantities over a span of a motion: integrals over its segments, and what impacts add in between.

    work ∫ F · v dt,   impulse ∫ F dt,   path length ∫ |v| dt,   mean ∫ x dt / T,   heat of friction -∫ F · v dt

Integrals are taken from step to step of the integrator (quadrature.py).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from planar_cli.errors import Diagnostic, FileProblem, Undecided
from planar_cli.integrators.base import Step
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.crossings import root
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Part, Quantity, Relation
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.simulate.blows import Blows
from planar_cli.simulate.heat import heat_of
from planar_cli.simulate.measures import Measures
from planar_cli.simulate.occurrences import Occurrences
from planar_cli.simulate.quadrature import Piece, integral
from planar_cli.simulate.timetable import Timetable

LOOKS, NEAR = 8, 1e-8
"""A step is looked at so often for what comes to hold in it; below this part of its scale a gap is zero."""
Function = Callable[[float, Sequence[float]], Sequence[float]]
Note = Callable[[float, Sequence[float]], None]
Close = Callable[[Step], int]
"""In how many parts of a step no body turns far."""


@record
class Stretch:
    """A part of a segment."""

    segment: Segment
    t0: float
    t1: float

    def pieces(self) -> Iterator[tuple[float, float, Step | None]]:
        """From step to step; at rest one piece without a step."""
        if not self.segment.steps:
            yield self.t0, self.t1, None
        for step in self.segment.steps:
            a, b = max(step.t0, self.t0), min(step.t1, self.t1)
            if b > a:
                yield a, b, step

    def parts(self, of: Function, note: Note | None, close: Close) -> Iterator[Piece]:
        """What is to be integrated from step to step; without a step the state stays as it is. `note` is told a state
        inside the step first: that of the directions in which things slide.
        """
        for a, b, step in self.pieces():
            along = partial(_along, of, step, self.segment.start)
            inside = None if note is None or step is None else partial(note, (a + b) / 2, step.at((a + b) / 2))
            ends = [a + (b - a) * i / close(step) for i in range(close(step))] if step is not None else [a]
            for start, end in pairwise([*ends, b]):
                yield Piece(along if inside is None else partial(_noted, inside, along), start, end)

    def looks(self, close: Close) -> Iterator[float]:
        """Times close enough to see what comes to hold."""
        for a, b, step in self.pieces():
            number = LOOKS if step is None else LOOKS * close(step)
            yield from (a + (b - a) * i / number for i in range(number))
        yield self.t1


def _along(of: Function, step: Step | None, still: Sequence[float], t: float) -> Sequence[float]:
    """As a function of time alone."""
    return of(t, still if step is None else step.at(t))


def _size(of: Callable[[float], Sequence[float]], t: float) -> tuple[float]:
    """The size of a vector."""
    return (math.hypot(*of(t)),)


def _reversals(piece: Piece) -> Iterator[float]:
    """When a velocity turns round within a piece: it goes through zero there, or nearly so."""
    times = [piece.a + (piece.b - piece.a) * i / LOOKS for i in range(LOOKS)] + [piece.b]
    for (a, before), (b, after) in pairwise((t, piece.of(t)) for t in times):
        if sum(p * q for p, q in zip(before, after, strict=True)) < 0:
            way = [q - p for p, q in zip(before, after, strict=True)]
            yield root(partial(_part_along, way, piece.of), a, b)


def _part_along(way: Sequence[float], of: Callable[[float], Sequence[float]], t: float) -> float:
    return sum(v * w for v, w in zip(of(t), way, strict=True))


def _noted(note: Callable[[], None], of: Callable[[float], Sequence[float]], t: float) -> Sequence[float]:
    note()
    return of(t)


class Spans:
    """Quantities over spans of one trajectory."""

    def __init__(self, measures: Measures, trajectory: Trajectory, scope: Scope) -> None:
        self.measures, self.trajectory, self.scope = measures, trajectory, scope
        self.blows = Blows(measures, trajectory, scope)

    def value(self, q: Quantity) -> tuple[float, ...]:
        """The quantity over its span, with its parts."""
        assert isinstance(q.at, tuple)
        found = self._whole(q, *(self._time(name, q) for name in q.at))
        for part in q.parts:
            found = self._part(found, part, q)
        return found

    def _part(self, found: tuple[float, ...], part: Part, q: Quantity) -> tuple[float, ...]:
        """A part of a vector; directions that turn are those at the beginning of the span."""
        if len(found) != 2:
            raise FileProblem([Diagnostic(q.mark, "PL551", f".{part.kind} of a number", "only a vector has parts")])
        assert isinstance(q.at, tuple)
        moment, graph = self.measures.moments[q.at[0]], self.measures.model.graph
        vector = Vec(graph.number(found[0]), graph.number(found[1]))

        def made(asked: Quantity, regime: Regime) -> list[Term]:
            return [self.measures.quantities(regime).part(vector, part, asked)]

        function = self.measures.routine(f"{part.kind} of {found}", q, moment.regime, made)
        return tuple(function(moment.t, moment.y))

    def _time(self, state: str, q: Quantity) -> float:
        moment = self.measures.moments.get(state)
        if moment is None:
            raise Undecided(f"{q.mark.file}:{q.mark.line}: the state {state} is not reached, so this has no value")
        return moment.t

    def _whole(self, q: Quantity, t0: float, t1: float) -> tuple[float, ...]:
        match q.word:
            case "mean":
                total = self._integral(q, t0, t1, self._argument)
                return tuple(v / (t1 - t0) for v in total)
            case "count":
                return (float(self._count(q, t0, t1)),)
            case "path_length":
                return self._length(q, t0, t1)
            case "impulse":
                return self._impulse(q, t0, t1)
            case "work":
                (steady,) = self._integral(q, t0, t1, self._power)
                return (steady + sum(self.blows.work(q, x) for x in self.blows.between(q)),)
        (steady,) = self._integral(q, t0, t1, self._heat)
        return (steady + sum(self.blows.heat(q, x) for x in self.blows.between(q)),)

    def stretches(self, t0: float, t1: float) -> Iterator[Stretch]:
        """The parts of the segments in a span."""
        for segment in self.trajectory.segments:
            a, b = max(segment.t0, t0), min(segment.t1, t1)
            if b > a:
                yield Stretch(segment, a, b)

    def _integral(
        self, q: Quantity, t0: float, t1: float, made: Callable[[Quantity, Regime], list[Term]]
    ) -> tuple[float, ...]:
        pieces: list[Piece] = []
        skids = self.measures.model.skids
        note, close = skids.note if skids.slidings else None, self.measures.model.pieces
        for stretch in self.stretches(t0, t1):
            regime = stretch.segment.regime
            assert isinstance(regime, Regime)
            pieces += stretch.parts(self.measures.routine("span", q, regime, made), note, close)
        self.measures.wind(t1)
        return integral(pieces) or (0.0,)

    def _length(self, q: Quantity, t0: float, t1: float) -> tuple[float, ...]:
        """∫ |v| dt, which has a corner wherever the velocity turns round."""
        pieces: list[Piece] = []
        for stretch in self.stretches(t0, t1):
            regime = stretch.segment.regime
            assert isinstance(regime, Regime)
            velocity = self.measures.routine("velocity", q, regime, self._velocity)
            for whole in stretch.parts(velocity, None, self.measures.model.pieces):
                ends = [whole.a, *_reversals(whole), whole.b]
                pieces += [Piece(partial(_size, whole.of), a, b) for a, b in pairwise(ends)]
        return integral(pieces) or (0.0,)

    # --- integrands --------------------------------------------------------------------------------------------------

    def _argument(self, q: Quantity, regime: Regime) -> list[Term]:
        assert q.argument is not None
        assert not isinstance(q.argument, Relation)
        return self.measures.terms(q.argument, self.measures.quantities(regime))

    def _velocity(self, q: Quantity, regime: Regime) -> list[Term]:
        return self.measures.terms(replace(q, word="v", at=None, parts=()), self.measures.quantities(regime))

    def _power(self, q: Quantity, regime: Regime) -> list[Term]:
        return self.measures.terms(replace(q, word="power", at=None, parts=()), self.measures.quantities(regime))

    def _heat(self, q: Quantity, regime: Regime) -> list[Term]:
        """Of one joint, or of all joints and of the loads that waste energy."""
        return [heat_of(q.things[0], self.measures.quantities(regime), regime, self.measures.model.scene)]

    def _force(self, q: Quantity, regime: Regime) -> list[Term]:
        """The resultant on the body, and its moment about the point behind the stroke."""
        quantities = self.measures.quantities(regime)
        reactions = quantities.reactions
        assert reactions is not None
        graph = self.measures.model.graph
        about = self._about(q)
        bare = q if about is None else replace(q, things=q.things[:1])
        wrenches = [w for w in reactions.upon(bare) if w.body != "ground"]
        if len(q.things) == 1 and q.things[0] not in self.scope.bodies and q.things[0] != "all":
            wrenches = [w for w in wrenches if w.body == wrenches[0].body]
        total, moment = Vec(graph.number(0.0), graph.number(0.0)), graph.number(0.0)
        for w in wrenches:
            moment = moment + w.couple
            if w.force is not None:
                total = total + w.force
                if about is not None:
                    moment = moment + (w.point - self.measures.model.scene.point(about)).cross(w.force)
        return [graph.of(total.x), graph.of(total.y)] if about is None else [graph.of(moment)]

    def _about(self, q: Quantity) -> str | None:
        """The point behind the stroke, if it is one."""
        from planar_cli.problem.checks.check_dimensions import about

        return about(q, self.scope)

    def _impulse(self, q: Quantity, t0: float, t1: float) -> tuple[float, ...]:
        """∫ F dt, and the impulses of impacts in between."""
        steady = self._integral(q, t0, t1, self._force) if t1 > t0 else ()
        total: Sequence[float] = steady or ((0.0,) if self._about(q) is not None else (0.0, 0.0))
        for x in self.blows.between(q):
            total = [a + b for a, b in zip(total, self.blows.impulse(q, self._about(q), x), strict=True)]
        return tuple(total)

    def _count(self, q: Quantity, t0: float, t1: float) -> int:
        """How often a relation comes to hold: by a change of sign, or of an equation by a touch."""
        relation = q.argument
        assert isinstance(relation, Relation)
        near = NEAR * Timetable(self.measures.model.scene.problem, self.measures).scale(relation.left, relation.right)
        found = Occurrences(relation.operator, near)
        for stretch in self.stretches(t0, t1):
            regime = stretch.segment.regime
            assert isinstance(regime, Regime)
            gap = self.measures.gap(relation, regime)
            self.measures.wind(t1)
            found.part(_within(gap, stretch.segment), stretch.looks(self.measures.model.pieces))
        return found.number


def _within(gap: Function, segment: Segment) -> Callable[[float], float]:
    """A gap as a function of the time in a segment."""
    return lambda t: gap(t, segment.at(t))[0]
