"""The modes of a motion: its states in order, those that we put in among them, and what acts from each to the next."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field, replace
from typing import Any

import sympy as sp

from planar_cli.equation.scene.displacement import CoordinateNames
from planar_cli.equation.system.setup import has_quantity, names_in
from planar_cli.joints.base import Joint
from planar_cli.problem.checks.held_masses import Held, held_from
from planar_cli.problem.language.expression import JustAfter, Name, Relation, Statement
from planar_cli.problem.scene.order_of_states import as_listed
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.records import changing, record
from planar_cli.solve.instant.instant import Instant
from planar_cli.solve.regimes.general import General, drawn_instant, make_general
from planar_cli.solve.regimes.lasting import LastingContact, lasting_from
from planar_cli.solve.regimes.regime import Regime


@record
class Span:
    """From one state of the file to the next: what acts meanwhile."""

    problem: Problem
    always: tuple[Statement, ...]
    held: Held = ()
    """Masses that no stream changes meanwhile."""

    @property
    def key(self) -> tuple[Any, ...]:
        """Tells spans apart in which different things act."""
        members = (*self.always, *self.problem.joints, *self.problem.loads)
        # What an impact leaves is made for each span anew.
        acting = ((x.name, x.during) if isinstance(x, LastingContact) else id(x) for x in members)
        return (*acting, *self.held, *self.problem.going)


@record
class Stretch:
    """What acts from one state (also one that we put in) to the next: a span in one choice of modes."""

    span: Span
    """Of the motion; where an impact or an impulse ends it, of the motion before that."""
    choice: tuple[int, ...]
    """The mode of every joint."""
    resting: frozenset[str] = frozenset()
    """Names of free speeds that are zero from the beginning and stay so."""
    ways: tuple[tuple[str, int], ...] = ()
    """Signs of free speeds by name, where a resistance asks for them, and sides of places, |x|, from which distances
    are measured."""
    blow: Span | None = None
    """What strikes, and the joints that hold after it, where the next state is just after this one."""
    blow_choice: tuple[int, ...] | None = None
    """The modes of what strikes; None: the first."""


CALLED = {
    "not compressed": "touch",
    "not stretched": "taut",
    "move apart": "taut",
    "compressed": "free",
    "stretched": "slack",
    "the tension pulls": "slack",
    "press": "leaves",
    "within its limit": "slips",
    "are apart": "meets",
    "stops sliding": "stops",
}
"""What a state is called that is put in where an assumption ends, by the words of that; others are called `turn`."""


@record
class ModeSequence:
    """The states of a motion, and which modes hold from each to the next."""

    states: tuple[State, ...]
    """In their order, with those that we put in."""
    stretches: tuple[Stretch, ...]
    """`stretches[i]` runs from `states[i]` to `states[i + 1]`."""
    turnings: Mapping[str, tuple[sp.Expr, str]] = field(default_factory=dict)
    """States that we put in, and those that a mode alone tells, each with what vanishes there (a formula of the general
    position) and what happens.
    """
    equilibria: tuple[tuple[State, Stretch], ...] = ()
    """States that stand beside the order, as no motion leads to them, each with what acts there."""
    beyond: Stretch | None = None
    """From the last state on; None: what acted before it."""

    def stretch(self, i: int) -> Stretch:
        """What acts from state i on, also from the last."""
        return self.stretches[i] if i < len(self.stretches) else self.beyond or self.stretches[-1]

    def changed(self, i: int, choice: tuple[int, ...]) -> ModeSequence:
        """Another choice of modes from stretch i on, as long as the same things act. What nothing set in motion before
        need not rest any longer.
        """
        if i >= len(self.stretches):
            return replace(self, beyond=replace(self.stretch(i), choice=choice, resting=frozenset()))
        key = self.stretches[i].span.key
        found = list(self.stretches)
        same = True
        for j in range(i, len(found)):
            same = same and found[j].span.key == key
            found[j] = replace(found[j], choice=choice if same else found[j].choice, resting=frozenset())
        beyond = None if self.beyond is None else replace(self.beyond, resting=frozenset())
        return replace(self, stretches=tuple(found), beyond=beyond)

    def struck(self, i: int, choice: tuple[int, ...]) -> ModeSequence:
        """Other modes of the blow on stretch i."""
        stretch = replace(self.stretches[i], blow_choice=choice)
        return replace(self, stretches=(*self.stretches[:i], stretch, *self.stretches[i + 1 :]))

    def going(self, i: int, ways: Mapping[str, int]) -> ModeSequence:
        """Other signs of speeds from stretch i on."""
        found = list(self.stretches)
        if i >= len(found):
            here = self.stretch(i)
            return replace(self, beyond=replace(here, ways=tuple(sorted({**dict(here.ways), **ways}.items()))))
        for j in range(i, len(found)):
            found[j] = replace(found[j], ways=tuple(sorted({**dict(found[j].ways), **ways}.items())))
        return replace(self, stretches=tuple(found))

    def with_resting(self, names: frozenset[str]) -> ModeSequence:
        """The same modes with speeds that stay zero."""
        beyond = None if self.beyond is None else replace(self.beyond, resting=self.beyond.resting | names)
        return replace(
            self, stretches=tuple(replace(s, resting=s.resting | names) for s in self.stretches), beyond=beyond
        )

    def turned(self, i: int, expr: sp.Expr, words: str) -> ModeSequence:
        """A state put in on stretch i where an assumption ends."""
        first = next((name for said, name in CALLED.items() if said in words), "turn")
        put_in = [s for s in self.states if s.name.startswith(first) and s.name in self.turnings and not s.relations]
        name = first if not put_in else f"{first}_{len(put_in) + 1}"
        while any(s.name == name for s in self.states):
            name += "_"
        state = State(name, (), self.states[i].mark)
        states = (*self.states[: i + 1], state, *self.states[i + 1 :])
        stretches = (*self.stretches[: i + 1], *self.stretches[i:])
        return replace(self, states=states, stretches=stretches, turnings={**self.turnings, name: (expr, words)})

    def dated(self, i: int) -> ModeSequence:
        """State i, which was put in, is the very instant that state i + 1 asks for: this takes its place."""
        put_in, state = self.states[i : i + 2]
        found = replace(
            self,
            states=(*self.states[:i], *self.states[i + 1 :]),
            stretches=(*self.stretches[:i], *self.stretches[i + 1 :]),
            turnings={state.name if n == put_in.name else n: what for n, what in self.turnings.items()},
        )
        return found if i + 1 < len(self.stretches) else replace(found, beyond=self.stretches[i])


def spans_of(problem: Problem, states: tuple[State, ...]) -> list[Span]:
    """The spans between states in their order, each with the laws, joints and loads that act in it."""
    if not states:
        return [_span(problem, lambda during: during is None)]
    return [acting_after(problem, s) for s in states[: max(len(states) - 1, 1)]]


def acting_from(problem: Problem, state: State) -> Callable[[tuple[str, str] | None], bool]:
    """Does what is said `during` a span act from a state on?"""
    order = {s.name: i for i, s in enumerate(as_listed(problem.states))}
    here = order.get(state.name, 0)
    return lambda during: during is None or order[during[0]] <= here < order[during[1]]


def acting_after(problem: Problem, state: State) -> Span:
    """What acts from a state on, though no state may follow."""
    massed, held = held_from(problem, state)
    massed = _going_from(massed, state)
    return replace(_span(massed, acting_from(problem, state), lasting_from(problem, state)), held=held)


def _going_from(problem: Problem, state: State, arrives: bool = False) -> Problem:
    """The problem with what still goes one way from a state on, or as that is reached."""
    if not problem.going:
        return problem
    order = {s.name: i for i, s in enumerate(as_listed(problem.states))}
    here = order.get(state.name, 0) - arrives
    return replace(problem, going=tuple(w for w in problem.going if not w[1].until or here < order[w[1].until]))


def _span(problem: Problem, acts: Callable[[tuple[str, str] | None], bool], lasting: tuple[Joint, ...] = ()) -> Span:
    """`lasting`: the contacts that impacts have left."""
    always = tuple(law.statement for law in problem.motion if acts(law.during))
    joints = (*(j for j in problem.joints if acts(j.during) and not j.strikes), *lasting)
    loads = tuple(x for x in problem.loads if acts(x.during) and not x.strikes)
    if joints == problem.joints and loads == problem.loads:
        return Span(problem, always)
    members: tuple[Any, ...] = (*problem.joints, *problem.loads)
    strikers = tuple(m for m in members if m.strikes)
    idle = tuple(j for j in problem.joints if j.touches and j not in joints)
    return Span(replace(problem, joints=joints, loads=loads, strikers=strikers, idle=idle), always)


def blow_before(problem: Problem, before: State, state: State) -> tuple[Span, Span] | None:
    """What strikes between two states of which the second is just after the first, and what acts after it; None: time
    passes between them.
    """
    if not any(isinstance(s, JustAfter) for s in state.relations):
        return None
    after = acting_after(problem, state)
    now = acting_from(problem, before)
    joints = tuple(j for j in problem.joints if now(j.during) or j in after.problem.joints)
    loads = tuple(x for x in problem.loads if x.strikes and now(x.during))
    massed, held = held_from(problem, before)
    massed = _going_from(massed, before)
    return Span(replace(massed, joints=joints, loads=loads), after.always, held), after


def arriving_at(problem: Problem, state: State) -> Span:
    """What acts as a state is reached: joints that begin there do not hold yet."""
    order = {s.name: i for i, s in enumerate(as_listed(problem.states))}
    now, here = acting_from(problem, state), order.get(state.name, 0)
    massed, held = held_from(problem, state)
    massed = _going_from(massed, state, arrives=True)
    acting = _span(massed, lambda during: during is None or (now(during) and order[during[0]] < here))
    return replace(acting, held=held)


@changing
class Workshop:
    """Makes what several sequences of modes of one problem share: scenes as drawn, and regimes."""

    earlier: Mapping[str, Any]
    by_axes: bool = False
    """Does everything count along the axes of the file, whichever way it goes?"""
    left: bool = False
    """Was it left for another one, in which what goes one way counts so?"""
    letters: dict[tuple[int, sp.Symbol, str], sp.Symbol] = field(default_factory=dict)
    made: CoordinateNames = field(default_factory=CoordinateNames)
    _drawn: dict[Any, Instant] = field(default_factory=dict)
    _regimes: dict[Any, Regime] = field(default_factory=dict)
    _generals: dict[Any, General] = field(default_factory=dict)

    def drawn(self, span: Span) -> Instant:
        """The scene of a span as drawn."""
        if span.key not in self._drawn:
            self._drawn[span.key] = drawn_instant(span.problem, span.always, self.earlier)
        return self._drawn[span.key]

    def regime(self, stretch: Stretch) -> Regime:
        """The regime of a stretch."""
        key = (stretch.span.key, stretch.choice, stretch.resting, stretch.ways)
        if key not in self._regimes:
            sides = tuple((name, way) for name, way in stretch.ways if name.startswith("|"))
            plain = (*key[:3], sides)
            if plain not in self._generals:
                self._generals[plain] = self._general(stretch, dict(sides))
            # The same letters, whichever way things go.
            general = replace(self._generals[plain], finisher=None, stages=[], solution=None, closed_forms={})
            self._regimes[key] = Regime(general, dict(stretch.ways))
        return self._regimes[key]

    def _general(self, stretch: Stretch, sides: Mapping[str, int]) -> General:
        span = stretch.span
        drawn = self.drawn(span)
        known = (span.problem, span.always, self.earlier, drawn)
        return make_general(*known, stretch.choice, stretch.resting, self.made, sides)


def nearest(sequence: ModeSequence, i: int, choices: Iterable[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """Choices of modes for stretch i, those first that differ in the fewest joints from the stretch before, where the
    same things act in it.
    """
    if i == 0 or sequence.stretches[i - 1].span.key != sequence.stretch(i).span.key:
        return list(choices)
    before = sequence.stretches[i - 1].choice
    return sorted(choices, key=lambda c: sum(a != b for a, b in zip(c, before, strict=True)))


def fixed_time(relations: tuple[Statement, ...]) -> Relation | None:
    """The relation that says at which time a state is."""
    for s in relations:
        if isinstance(s, Relation) and s.operator == "=":
            for one, other in ((s.left, s.right), (s.right, s.left)):
                if isinstance(one, Name) and one.name == "t" and not has_quantity(other) and "t" not in names_in(other):
                    return s
    return None
