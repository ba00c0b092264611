"""The states of a file as the schedule of a motion: what tells, in numbers, that each of them has been reached."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from planar_cli.errors import Diagnostic, FileProblem, Mark
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.trajectory.automaton import Choice
from planar_cli.motion.trajectory.automaton import Regime as AnyRegime
from planar_cli.motion.trajectory.schedule import Condition, Crossing, Event, Schedule
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import (
    AtRest,
    Equilibrium,
    Extreme,
    JustAfter,
    Name,
    Number,
    Quantity,
    Relation,
    Side,
    Statement,
    Word,
)
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.simulate.measures import Measures, Values

NEAR = 1e-7
"""Where one relation of a state holds, the others hold if they are off by less than this part of their scale."""
SLACK = 1e-9
"""An inequality may be missed by this part of its scale: what was set equal lies on its edge."""


def schedule_of(problem: Problem, measures: Measures, breakpoints: Sequence[float]) -> Schedule:
    """What the file says of time. FileProblem: a state that a motion followed step by step can not look for."""
    if not problem.states:
        return Schedule("", (), tuple(breakpoints))
    # The direction of a place counts its turns from the beginning on, whenever a state looks at it.
    asked = (n for s in problem.states for r in s.relations for n in walk(r) if isinstance(n, Quantity))
    for q in (q for q in asked if q.word == "r" and q.at is None and any(p.kind == "angle" for p in q.parts)):
        measures.quantities(None).any(q)
    reader = Timetable(problem, measures)
    events = tuple(reader.event(state) for state in problem.states[1:])
    return Schedule(problem.states[0].name, events, tuple(breakpoints))


class Timetable:
    """Reads the relations of states."""

    def __init__(self, problem: Problem, measures: Measures) -> None:
        self.problem, self.measures = problem, measures
        self.kinds = Kinds(Scope(problem, ()))

    def event(self, state: State) -> Event:
        """One state after the first."""
        crossing: Crossing | None = None
        time, after, rest, endless = None, "", False, False
        equal = list[Relation]()
        modes: list[tuple[str, str]] = []
        conditions: list[Condition] = []
        for statement in self._telling(state):
            match statement:
                case JustAfter():
                    after = statement.state
                case Equilibrium() if statement.body is None:
                    rest = True
                case AtRest() | Equilibrium():
                    crossing = crossing or self._slowest(statement.body, statement.mark)
                    conditions.append(self._still(statement.body, statement.mark))
                case Extreme():
                    crossing = self._extreme(statement)
                case Relation() if (mode := mode_of(statement)) is not None:
                    modes.append(mode)
                case Relation() if is_time(statement) and time is None:
                    time = self._time(statement)
                    if time == math.inf:
                        # Where the motion goes: it is followed until it has settled.
                        time, endless = None, True
                case Relation() if statement.operator == "=" and crossing is None and time is None:
                    size = _vanishing(statement)
                    if size is None:
                        crossing = self._crossing(statement)
                        equal.append(statement)
                    else:
                        # A magnitude does not change its sign: it is smallest there, and nothing.
                        crossing = self._extreme(Extreme(size, -1, statement.text, statement.mark))
                        conditions.append(self._condition(statement))
                case Relation():
                    conditions.append(self._condition(statement))
                    if equal and statement.operator == "=" and _vanishing(statement) is None:
                        equal.append(statement)
        if len(equal) > 1:
            conditions.append(self._condition(equal[0]))
        others = tuple(self._crossing(r) for r in equal[1:])
        return Event(state.name, time, crossing, others, tuple(modes), tuple(conditions), after, rest, endless)

    # --- what tells it -----------------------------------------------------------------------------------------------

    def _telling(self, state: State) -> list[Statement]:
        """The statements, what tells most sharply when they hold first.

        Rest tells better than a place that is only just reached in it, and so does what is largest. Of something that
        is largest where something else dates the state, a sought constant makes the most, not the time.
        """
        rest = [s for s in state.relations if isinstance(s, AtRest | Equilibrium)]
        other = [s for s in state.relations if not isinstance(s, AtRest | Equilibrium)]
        if chooses(self.problem, state):
            other = [s for s in other if not isinstance(s, Extreme)]
        return [*rest, *sorted(other, key=lambda s: not isinstance(s, Extreme))]

    def _time(self, relation: Relation) -> float:
        side = relation.right if isinstance(relation.left, Name) and relation.left.name == "t" else relation.left
        return self.measures.model.scene.sides.value(side).value

    def _crossing(self, relation: Relation) -> Crossing:
        known: dict[Regime, Values] = {}

        def value(regime: AnyRegime, choice: Choice, t: float, y: Sequence[float]) -> float:
            assert isinstance(regime, Regime)
            if regime not in known:
                known[regime] = self.measures.gap(relation, regime)
            return known[regime](t, y)[0]

        return Crossing(value, self.scale(relation.left, relation.right))

    def _extreme(self, extreme: Extreme) -> Crossing:
        """The rate falls through zero where something is largest, and rises where it is smallest."""
        vector = _without_mag(extreme.side)
        known: dict[Regime, tuple[Values, Values]] = {}

        def functions(regime: Regime) -> tuple[Values, Values]:
            side = extreme.side if vector is None else vector
            rates = self.measures.rate(side, regime)
            return rates if vector is None else self.measures.function(side, regime), rates

        def rate(regime: AnyRegime, choice: Choice, t: float, y: Sequence[float]) -> float:
            assert isinstance(regime, Regime)
            if regime not in known:
                known[regime] = functions(regime)
            value, rates = known[regime]
            if vector is None:
                return rates(t, y)[0]
            # The rate of the square of a magnitude has a value where it vanishes, too.
            return sum(a * b for a, b in zip(value(t, y), rates(t, y), strict=True))

        scale = self.scale(extreme.side) / self.measures.model.scales.time
        return Crossing(rate, scale if vector is None else scale * self.scale(extreme.side), -extreme.sense)

    def _condition(self, relation: Relation) -> Condition:
        scale = self.scale(relation.left, relation.right)

        def holds(regime: AnyRegime, choice: Choice, t: float, y: Sequence[float]) -> bool:
            assert isinstance(regime, Regime)
            off = self.measures.gap(relation, regime)(t, y)
            if relation.operator == "=":
                return all(abs(v) <= NEAR * scale for v in off)
            slack = SLACK * scale
            return off[0] < slack if relation.operator in ("<", "<=") else off[0] > -slack

        return holds

    def _moving(self, body: str | None, mark: Mark) -> list[int]:
        """The numbers of a body's coordinates, or of all."""
        layout = self.measures.model.layout
        if body is None:
            return list(range(layout.count))
        frame = layout.frames.get(body)
        if frame is None:
            raise FileProblem([Diagnostic(mark, "PL553", f"{body} is no body that moves")])
        return [n for n in (frame.x, frame.y, frame.theta) if n is not None]

    def _slowest(self, body: str | None, mark: Mark) -> Crossing:
        """The rate of Σ (v/scale)²/2, which rises through zero where everything is slowest."""
        model = self.measures.model
        count, scale = model.layout.count, model.scale
        weights = [(count + n, scale[count + n] ** -2) for n in self._moving(body, mark)]

        def rate(regime: AnyRegime, choice: Choice, t: float, y: Sequence[float]) -> float:
            rates = regime.rates(t, y)
            return sum(y[n] * rates[n] * weight for n, weight in weights)

        # Where a resistance stays until then, it only touches zero.
        return Crossing(rate, 1.0 / model.time_scale, 0)

    def _still(self, body: str | None, mark: Mark) -> Condition:
        """A body, or everything, at rest."""
        model = self.measures.model
        count, scale = model.layout.count, model.scale
        limits = [(count + n, NEAR * scale[count + n]) for n in self._moving(body, mark)]

        def still(regime: AnyRegime, choice: Choice, t: float, y: Sequence[float]) -> bool:
            return all(abs(y[n]) <= limit for n, limit in limits)

        return still

    def scale(self, *sides: Side) -> float:
        """The usual size of what these sides measure."""
        for side in sides:
            kind = dimension_of(side, self.kinds.of)
            if kind.dimension is not None:
                d, scales = kind.dimension, self.measures.model.scales
                return float(
                    scales.length ** float(d.length) * scales.mass ** float(d.mass) * scales.time ** float(d.time)
                )
        return 1.0


def mode_of(relation: Relation) -> tuple[str, str] | None:
    """The joint and the mode of `mode(C) = stick`."""
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if isinstance(side, Quantity) and side.word == "mode" and isinstance(other, Word) and relation.operator == "=":
            return side.things[0], other.word
    return None


def _without_mag(side: Side) -> Quantity | None:
    """The vector of which a side is the magnitude."""
    if isinstance(side, Quantity) and side.parts and side.parts[-1].kind == "mag":
        return replace(side, parts=side.parts[:-1])
    return None


def _vanishing(relation: Relation) -> Side | None:
    """The magnitude of which a relation says that it is zero."""
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if _without_mag(side) is not None and isinstance(other, Number) and other.value == 0:
            return side
    return None


def chooses(problem: Problem, state: State) -> bool:
    """Is something largest or smallest where something else dates the state? Then it chooses a sought constant."""
    others = [s for s in state.relations if not isinstance(s, Extreme)]
    dated = any(isinstance(s, AtRest | Equilibrium) or _dates(s) for s in others)
    return dated and bool(problem.unknowns) and len(others) < len(state.relations)


def _dates(statement: Statement) -> bool:
    """Does a statement tell when a state is reached?"""
    if isinstance(statement, Relation):
        return statement.operator == "=" and mode_of(statement) is None
    return isinstance(statement, JustAfter)


def is_time(statement: Statement) -> bool:
    """Does a statement give the time itself?"""
    if not isinstance(statement, Relation) or statement.operator != "=":
        return False
    for side, other in ((statement.left, statement.right), (statement.right, statement.left)):
        if isinstance(side, Name) and side.name == "t" and side.at is None:
            inner = [n for n in walk(other) if isinstance(n, Quantity) or (isinstance(n, Name) and n.name == "t")]
            return not inner
    return False


def breakpoints_of(scene: MovingScene) -> tuple[float, ...]:
    """Times at which a table jumps or has a kink."""
    return tuple(sorted({x for table in scene.graph.tables.values() for x, _ in table.points}))
