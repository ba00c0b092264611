"""The plot of a motion: its states in order, those that we put in among them, and what acts from each to the next."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import Any

from planar_cli.equation.setup import has_quantity, names_in
from planar_cli.problem.expression import Name, Relation, Statement
from planar_cli.problem.scene import Problem, State
from planar_cli.solve.course.general import General, drawn_instant, make_general
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.instant import Instant


@dataclass(frozen=True, slots=True)
class Span:
    """From one state of the file to the next: what acts meanwhile."""

    problem: Problem
    always: tuple[Statement, ...]

    @property
    def key(self) -> tuple[Any, ...]:
        """Tells spans apart in which different things act."""
        members = (*self.always, *self.problem.joints, *self.problem.loads)
        return tuple(id(x) for x in members)


@dataclass(frozen=True, slots=True)
class Stretch:
    """What acts from one state (also one that we put in) to the next: a span in one choice of modes; `signs`: which way
    free speeds go, by name, where that matters.
    """

    span: Span
    choice: tuple[int, ...]
    signs: tuple[tuple[str, int], ...] = ()


@dataclass(frozen=True, slots=True)
class Plot:
    """`stretches[i]` runs from `states[i]` to `states[i + 1]`. `turnings`: names of states that we put in."""

    states: tuple[State, ...]
    stretches: tuple[Stretch, ...]
    turnings: frozenset[str] = frozenset()

    def changed(self, i: int, stretch: Stretch) -> Plot:
        """The same plot with another stretch."""
        return replace(self, stretches=(*self.stretches[:i], stretch, *self.stretches[i + 1 :]))

    def turned(self, i: int, state: State, after: Stretch) -> Plot:
        """A state put in on stretch i, and what acts after it."""
        states = (*self.states[: i + 1], state, *self.states[i + 1 :])
        stretches = (*self.stretches[: i + 1], after, *self.stretches[i + 1 :])
        return Plot(states, stretches, self.turnings | {state.name})


def spans_of(problem: Problem, states: tuple[State, ...]) -> list[Span]:
    """The spans between states in their order, each with the laws, joints and loads that act in it."""
    order = {s.name: i for i, s in enumerate(states)}

    def acts(during: tuple[str, str] | None, i: int) -> bool:
        return during is None or order[during[0]] <= i < order[during[1]]

    found = []
    for i in range(max(len(states) - 1, 1)):
        always = tuple(law.statement for law in problem.motion if acts(law.during, i))
        joints = tuple(j for j in problem.joints if acts(j.during, i))
        loads = tuple(x for x in problem.loads if acts(x.during, i))
        whole = joints == problem.joints and loads == problem.loads
        found.append(Span(problem if whole else replace(problem, joints=joints, loads=loads), always))
    return found


@dataclass(slots=True)
class Workshop:
    """Makes what several plots of one problem share: scenes as drawn, and regimes."""

    earlier: Mapping[str, Any]
    _drawn: dict[Any, Instant] = field(default_factory=dict)
    _regimes: dict[Any, Regime] = field(default_factory=dict)

    def drawn(self, span: Span) -> Instant:
        """The scene of a span as drawn."""
        if span.key not in self._drawn:
            self._drawn[span.key] = drawn_instant(span.problem, span.always, self.earlier)
        return self._drawn[span.key]

    def regime(self, stretch: Stretch) -> Regime:
        """The regime of a stretch."""
        key = (stretch.span.key, stretch.choice, stretch.signs)
        if key not in self._regimes:
            self._regimes[key] = Regime(self._general(stretch))
        return self._regimes[key]

    def _general(self, stretch: Stretch) -> General:
        speeds = {name: Decimal(sign) * (Decimal("0.71") + i) for i, (name, sign) in enumerate(stretch.signs)}
        span = stretch.span
        return make_general(span.problem, span.always, self.earlier, self.drawn(span), stretch.choice, speeds)


def fixed_time(relations: tuple[Statement, ...]) -> Relation | None:
    """The relation that says at which time a state is."""
    for s in relations:
        if isinstance(s, Relation) and s.operator == "=":
            for one, other in ((s.left, s.right), (s.right, s.left)):
                if isinstance(one, Name) and one.name == "t" and not has_quantity(other) and "t" not in names_in(other):
                    return s
    return None
