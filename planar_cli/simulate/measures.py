"""What is asked of a motion at one moment, as numbers: quantities, sides and relations of the language.

What varies is compiled once for every regime; what stands behind `@ state` is a number as soon as that state has been
reached.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import partial
from itertools import islice
from typing import TypeVar

from planar_cli.errors import Diagnostic, FileProblem, Mark, Undecided
from planar_cli.integrators.base import OUTSIDE
from planar_cli.joints.base import distinct
from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.motion.regime.model import Model
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.terms.routine import Routine
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.language.expression import Grouped, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.ended import told_before
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.records import changing, record

Asked = TypeVar("Asked", bound=Side | Relation)


Values = Callable[[float, Sequence[float]], list[float]]
"""f(t, y)."""
Several = Callable[[float, Sequence[float]], list[list[float]]]
"""f(t, y) of several things: a number, or the two components of a vector, of each."""
ASIDE = 1e-3
"""Rates of forces are differences over this part of the time scale, exact up to its fourth power."""
DIFFERENCES = ((-2, 1 / 12), (-1, -2 / 3), (1, 2 / 3), (2, -1 / 12))
START = ""
"""The name under which the beginning of the motion is kept, beside that of the first state."""
LATER = frozenset(
    ("a", "alpha", "coriolis", "N", "friction", "reaction", "moment", "tension", "force", "power", "ddot")
)
"""Where something changes, these have the value just after; places and velocities are those that arrive."""


@record
class Moment:
    """An instant of the motion."""

    regime: Regime
    """What acts as it arrives."""
    modes: Mapping[str, str]
    """The modes just after, of the joints that have several, by the joint's name in the file."""
    t: float
    """s."""
    y: tuple[float, ...]
    """The state as it arrives."""
    after: tuple[Regime, tuple[float, ...]] | None = None
    """What acts just after, and the state then, where the motion goes on."""

    def instant(self, what: Side) -> tuple[Regime, tuple[float, ...]]:
        """The regime and the state in which something that is asked has its value."""
        words = {node.word for node in walk(what) if isinstance(node, Quantity)}
        return self.after if self.after is not None and words & LATER else (self.regime, self.y)


@changing
class Measures:
    """Numbers of one model's motion."""

    model: Model
    moments: dict[str, Moment] = field(default_factory=dict)
    """The states of the file that have been reached, by name."""
    known: Mapping[str, Moment] = field(default_factory=dict)
    """States that are known beforehand, as relations of others speak of them before they are reached."""
    followed: Trajectory | None = None
    """The motion, once it has been followed."""
    _way: Sequence[tuple[float, Sequence[float]]] = ()
    """Times and states along it, close enough to count turns; made when turns are asked for."""
    _wound: tuple[float, int] = (math.nan, 0)
    """The time up to which turns and directions of sliding are noted, and of how many of them."""
    _accelerations: list[Term] = field(default_factory=list)
    _pushes: dict[str, Term] = field(default_factory=dict)
    _rates: dict[tuple[Regime, Side], Values] = field(default_factory=dict)
    _routines: dict[tuple[Regime, str, Side | Relation], Routine] = field(default_factory=dict)

    def __post_init__(self) -> None:
        graph = self.model.graph
        self._accelerations = [graph.variable(f"acceleration{i}", 0.0) for i in range(self.model.layout.count)]

    # --- numbers -----------------------------------------------------------------------------------------------------

    def at(self, what: Side, moment: Moment) -> tuple[float, ...]:
        """A number, or the two components of a vector, in SI units. Undecided: it has no value there."""
        regime, y = moment.instant(what)
        function = self.function(what, regime)
        self.wind(moment.t)
        try:
            return tuple(function(moment.t, y))
        except OUTSIDE as outside:
            mark = _mark(what)
            text = f"this has no value at t = {moment.t:.9g} s ({outside})"
            raise Undecided(f"{mark.file}:{mark.line}: {text}") from outside

    def wind(self, time: float) -> None:
        """Note turns and directions of sliding from the beginning to a moment; while the motion is being followed they
        are at hand.
        """
        slidings = len(self.model.skids.slidings)
        noted, until = len(self.model.graph.turned) + slidings, time if slidings else math.inf
        if self.followed is not None and noted and self._wound != (until, noted):
            self._wound = until, noted
            self.model.begin()
            self._way = self._way or tuple(way_of(self.followed, self.model))
            k = bisect_right(self._way, until, key=lambda noted: noted[0])
            for t, y in self._way[:k]:
                self.model.note(t, y)
            self.model.wind(self._way[k:])
            self.model.skids.recall(until)
        if self.followed is not None:
            self.model.recall(time)

    def number(self, what: Side, moment: Moment) -> float:
        """A number."""
        found = self.at(what, moment)
        if len(found) != 1:
            text = "this is a vector"
            raise FileProblem([Diagnostic(_mark(what), "PL550", text, "ask for a part: .x .y .mag .angle")])
        return found[0]

    def function(self, what: Side, regime: Regime) -> Callable[[float, Sequence[float]], list[float]]:
        """A side as a function of time and state in one regime."""
        return self.routine("value", what, regime, lambda side, r: self.terms(side, self.quantities(r)))

    def several(self, sides: Sequence[Side], regime: Regime) -> Several:
        """Some sides as functions of time and state in one regime; what the state alone tells is one function."""
        quantities, unknowns = self.quantities(regime), self._unknowns(regime)
        terms = [self.terms(side, quantities) for side in sides]
        apart = {
            k: self.function(sides[k], regime)
            for k, own in enumerate(terms)
            if not set(ordered(own)).isdisjoint(unknowns)
        }
        whole = regime.routine([t for k, own in enumerate(terms) if k not in apart for t in own], unknowns)

        def values(t: float, y: Sequence[float]) -> list[list[float]]:
            told = iter(whole(t, y))
            return [apart[k](t, y) if k in apart else list(islice(told, len(own))) for k, own in enumerate(terms)]

        return values

    def gap(self, relation: Relation, regime: Regime) -> Callable[[float, Sequence[float]], list[float]]:
        """Left less right side."""

        def less(what: Relation, regime: Regime) -> list[Term]:
            quantities = self.quantities(regime)
            left, right = self.terms(what.left, quantities), self.terms(what.right, quantities)
            for side, other in ((left, what.right), (right, what.left)):
                if len(side) == 2 and _is_zero(other):
                    # A vector that vanishes: its magnitude does.
                    return [quantities.magnitude(Vec(side[0], side[1]))]
            if len(left) != len(right):
                text = f"'{what.text}' compares a vector with a number"
                raise FileProblem([Diagnostic(what.mark, "PL550", text, "compare .x and .y, or .mag")])
            return [a - b for a, b in zip(left, right, strict=True)]

        return self.routine("gap", relation, regime, less)

    def rate(self, what: Side, regime: Regime) -> Callable[[float, Sequence[float]], list[float]]:
        """The time derivative of a side, along the motion."""
        key = (regime, what)
        if key not in self._rates:
            self._rates[key] = self._rate(what, regime)
        return self._rates[key]

    def _rate(self, what: Side, regime: Regime) -> Values:
        def derived(side: Side, regime: Regime) -> list[Term]:
            quantities = self.quantities(regime)
            return [quantities.rate(term) for term in self.terms(side, quantities)]

        quantities = self.quantities(regime)
        if all(quantities.followed(term) for term in self.terms(what, quantities)):
            return self.routine("rate", what, regime, derived)
        # Accelerations and forces have no formula for their rates.
        return along(self.function(what, regime), regime, ASIDE * self.model.time_scale)

    # --- terms -------------------------------------------------------------------------------------------------------

    def terms(self, what: Side, quantities: Quantities) -> list[Term]:
        """A side as one term, or two of a vector."""
        found: Term | Vec
        if isinstance(what, Quantity):
            found = quantities.any(what)
        elif isinstance(what, Grouped):
            return [quantities.scene.graph.number(v) for v in self.elsewhere(what.at, what.operand)]
        else:
            found = quantities.sides.value(what)
        return [found.x, found.y] if isinstance(found, Vec) else [found]

    def elsewhere(self, state: str, side: Side) -> tuple[float, ...]:
        """What stands before `@ state`. Undecided: that state has not been reached."""
        moment = self.known.get(state) or self.moments.get(state)
        if moment is None:
            mark = _mark(side)
            raise Undecided(f"{mark.file}:{mark.line}: the state {state} is not reached, so this has no value")
        if told_before(side, self.model.scene.problem, state):
            moment = replace(moment, after=None)
        return self.at(side, moment)

    def quantities(self, regime: Regime | None) -> Quantities:
        """The quantities of the language in one regime; None: those of places and velocities alone."""
        model = self.model
        graph = model.graph
        accelerations = dict(zip(model.layout.speeds, self._accelerations, strict=True))
        pushes = tuple((p, self._push(p.name)) for p in regime.reactions) if regime is not None else ()
        wrenches = regime.parts.wrenches if regime is not None else ()
        written = model.scene.problem.joints
        names = {ours.name: theirs.name for ours, theirs in zip(distinct(written), written, strict=True)}
        if isinstance(model, HybridModel):
            # Bodies that an impact leaves in contact may touch in several ways.
            names |= {way.name: names[impact] for impact, ways in model.encounters.items() for way in ways}
        reactions = Reactions(pushes, wrenches, names, graph.number(0.0))
        scene = model.scene

        def numbers(state: str, side: Side) -> Term | Vec:
            parts = [graph.number(v) for v in self.elsewhere(state, side)]
            return Vec(*parts) if len(parts) > 1 else parts[0]

        stored = scene.stored_energy if regime is None else partial(scene.stored_energy, loads=regime.parts.acting)
        return Quantities(scene, stored, accelerations, reactions, numbers)

    def _push(self, name: str) -> Term:
        if name not in self._pushes:
            self._pushes[name] = self.model.graph.variable(f"push_{len(self._pushes)}", 0.0)
        return self._pushes[name]

    def routine(self, kind: str, what: Asked, regime: Regime, made: Callable[[Asked, Regime], list[Term]]) -> Routine:
        """What is `made` of something asked for, compiled once for each regime; `kind` tells what is made of it."""
        key = (regime, kind, what)
        if key not in self._routines:
            self._routines[key] = regime.routine(made(what, regime), self._unknowns(regime))
        return self._routines[key]

    def _unknowns(self, regime: Regime) -> list[Term]:
        """The variables that stand for accelerations and pushes."""
        return [*self._accelerations, *(self._push(p.name) for p in regime.reactions)]


def along(values: Values, regime: Regime, h: float) -> Values:
    """The rates of values on the way that a regime goes: on its tangent they change as on itself, to first order."""

    def rates(t: float, y: Sequence[float]) -> list[float]:
        towards = regime.rates(t, y)
        found: list[float] = []
        for place, weight in DIFFERENCES:
            step = place * h
            beside = values(t + step, [a + step * r for a, r in zip(y, towards, strict=True)])
            found = [a + weight / h * b for a, b in zip(found or [0.0] * len(beside), beside, strict=True)]
        return found

    return rates


def modes_of(regime: Regime) -> dict[str, str]:
    """The modes of its joints, by name."""
    return {held.joint: held.mode.name for held in regime.parts.held if held.mode.name}


def moments_of(
    trajectory: Trajectory,
    moments: Mapping[str, Moment],
    settled: Callable[[Moment], tuple[Regime, tuple[float, ...]] | None],
) -> dict[str, Moment]:
    """The moments with what acts just after each of them; `settled` finds that where the motion ends."""
    found = {}
    for name, moment in moments.items():
        if any(x.kind == "impact" and x.t == moment.t and x.before == moment.y for x in trajectory.transitions):
            # What strikes now is not yet there: forces are those with which it arrives.
            found[name] = replace(moment, modes=modes_of(moment.regime))
            continue
        segment = next((s for s in trajectory.segments if s.t0 == moment.t), None)
        segment = segment or next((s for s in trajectory.segments if s.t0 < moment.t < s.t1), None)
        after: tuple[Regime, tuple[float, ...]] | None = None
        if segment is None:
            after = settled(moment) if moment.t >= trajectory.t1 else None
        elif isinstance(segment.regime, Regime):
            after = segment.regime, segment.start if segment.t0 == moment.t else moment.y
        regime = moment.regime if after is None else after[0]
        # Nothing arrives at the beginning: what acts there is what the motion begins with.
        arriving = regime if segment is not None and moment.t == trajectory.t0 else moment.regime
        found[name] = replace(moment, regime=arriving, modes=modes_of(regime), after=after)
    return found


def way_of(trajectory: Trajectory, model: Model) -> Iterator[tuple[float, Sequence[float]]]:
    """The states at the beginning of every segment and along every step, close enough to count turns."""
    for segment in trajectory.segments:
        yield segment.t0, segment.start
        for step in segment.steps:
            yield from ((t, y) for t, y in model.between(step) if t <= segment.t1)


def _mark(side: Side) -> Mark:
    return side.mark


def _is_zero(side: Side) -> bool:
    """Is it the number 0, which may also stand against a vector?"""
    return isinstance(side, Number) and not side.value
