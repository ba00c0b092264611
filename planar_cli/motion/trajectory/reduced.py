"""What of the state has to be integrated: coordinates that joints make of the others are computed from these.

A pin on a rod tells both coordinates of its centre from its angle, as a rolling wheel's place follows from its turn:
wherever a coordinate enters a relation of places with a constant coefficient, and all others in it are known before, it
is solved for. An open chain so keeps its joints to rounding at every instant, inside a step too; of a mechanism in
loops only the relations that close them are left to the projection. The integrator has that much less to carry along.

Where one degree of freedom is left and energy is kept, it tells the speed: every step ends with the velocities that
have it. (With more degrees of freedom it tells one direction of many, and true errors are no smaller for it.)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from planar_cli.integrators.base import Integrator, Project, Rates, Setting, Step, StepTooSmall
from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.replacing import replaced
from planar_cli.motion.terms.routine import Routine, View
from planar_cli.motion.terms.source import Code, Singular, compiled
from planar_cli.motion.terms.terms import Term, ordered

SLIGHT = 1e-3
"""A coefficient below this part of the largest of its relation solves for nothing."""
TURN = 1.5
"""No step turns what carries places round by more than this [rad], as far as its beginning tells: they are followed
round, though the angle may change in the simplest way."""
SWIFT = 1e-3
"""What is missing of the energy is put right where it is less than this part of the kinetic energy."""
MISSED = 1e-9
"""A state that misses its joints by more than this part of the scales is not reduced."""


def told(layout: Layout, constraints: Sequence[Constraint]) -> dict[int, Term]:
    """Coordinates by number, as terms of those that are left and of the time: angles first, then places."""
    found: dict[int, Term] = {}
    angles = {i for i, s in enumerate(layout.slots) if s.kind == "theta"}
    placed = [c for c in constraints if c.place is not None]
    turning = [c for c in placed if angles.issuperset(c.row) and all(t.constant for t in c.row.values())]
    _solve(layout, turning, angles, found)
    _solve(layout, [c for c in placed if c not in turning], set(range(layout.count)) - angles, found)
    return found


def _solve(layout: Layout, constraints: Sequence[Constraint], among: Collection[int], found: dict[int, Term]) -> None:
    """Solve each relation for the only one of these coordinates that no other has told; what stays open is told."""
    open_, waiting = set(among), list(constraints)
    while waiting:
        left: list[Constraint] = []
        for constraint in waiting:
            unknown = [i for i in constraint.row if i in open_]
            if len(unknown) > 1:
                left.append(constraint)
            elif unknown:
                open_.remove(unknown[0])
                if _solves(constraint, unknown[0]):
                    found[unknown[0]] = _solution(layout, constraint, unknown[0], found)
        if len(left) == len(waiting):
            # Several bodies hang together freely: one of them is told by nothing.
            unknown = [i for i in left[0].row if i in open_]
            best = max(unknown, key=lambda i: (_solves(left[0], i), -i))
            open_ -= set(unknown) - {best}
        waiting = left


def _solves(constraint: Constraint, i: int) -> bool:
    """Is a coordinate's coefficient constant, and not slight?"""
    row = constraint.row
    return row[i].constant and abs(row[i].value) >= SLIGHT * max(abs(t.value) for t in row.values() if t.constant)


def _solution(layout: Layout, constraint: Constraint, i: int, found: Mapping[int, Term]) -> Term:
    assert constraint.place is not None
    coordinates, number = layout.coordinates, layout.graph.number
    by = {coordinates[j]: found[j] for j in constraint.row if j in found}
    # What cancels in the relation, as the places of wheels of one size under a belt do, may have any value.
    by |= {q: number(layout.drawn[j]) for j, q in enumerate(coordinates) if j not in constraint.row}
    rest = replaced(constraint.place, {**by, coordinates[i]: number(0.0)})
    return rest * (-1.0 / constraint.row[i].value)


class Reduced:
    """A regime as the integrator sees it: the independent coordinates and their rates."""

    def __init__(
        self,
        layout: Layout,
        given: Mapping[int, Term],
        loops: int,
        scale: Sequence[float],
        rates: Callable[[View, Sequence[int]], Routine],
        anywhere: Rates,
        energies: tuple[Term, Term] | None,
    ) -> None:
        """`given`: what `told` has found. `loops`: so many relations are left to the projection. `rates`: from a view
        of the state to a routine for the accelerations of some coordinates; `anywhere`: the rates of a whole state, by
        another way. `energies`: kinetic and potential, where their sum is kept.
        """
        self.layout, self.given, self.loops, self.scale = layout, given, loops, scale
        self.anywhere, self.energies = anywhere, energies
        count = layout.count
        self.free = tuple(i for i in range(count) if i not in given)
        self._places = (*self.free, *(count + i for i in self.free))
        """Where the independent ones stand in the state."""
        slots, graph = layout.slots, layout.graph
        round_ = {v for t in ordered(given.values()) if t.op in ("sin", "cos") for v in ordered(t.args)}
        turns = [k for k, i in enumerate(self.free) if slots[i].kind == "theta" and slots[i].coordinate in round_]
        self._turning = [len(self.free) + k for k in turns]
        """Where the rates of the angles with which places go round stand among them."""
        one = {layout.time: graph.number(1.0)}
        terms = list(given.values())
        self._speeds = graph.rates(terms, one | {slots[i].coordinate: slots[i].rate for i in self.free})
        known = {slots[i].coordinate: t for i, t in given.items()}
        known |= {slots[i].rate: t for i, t in zip(given, self._speeds, strict=True)}
        self._known = known
        self.inputs = (*(slots[i].coordinate for i in self.free), *(slots[i].rate for i in self.free))
        self._accelerations = rates(View(self.inputs, known, self.whole), self.free)
        self._whole: Code | None = None
        self._both: Code | None = None
        self._energies: Code | None = None
        self._supplied = 0.0
        """The energy that the end of the last step was given [J]."""
        self._end: tuple[Sequence[float], list[float], list[float]] = ((), [], [])
        """The end of the last step: as the integrator sees it, the state, its rates."""

    def part(self, y: Sequence[float]) -> list[float]:
        """The independent numbers of a state."""
        return [y[i] for i in self._places]

    def whole(self, t: float, z: Sequence[float]) -> list[float]:
        """The state of which these are the independent numbers."""
        if self._whole is None:
            outputs = [self._known.get(v, v) for v in self.layout.state]
            self._whole = compiled(outputs, self.inputs, self.layout.time)
        return self._whole.function(t, z)

    def rates(self, t: float, z: Sequence[float]) -> list[float]:
        """z'."""
        for function in self._accelerations.serving:
            try:
                return function(t, z)
            except (Singular, ZeroDivisionError):
                continue
        try:
            return self._accelerations.regular(t, z)
        except Singular:
            return self.part(self.anywhere(t, self.whole(t, z)))

    def whole_rates(self, t: float, z: Sequence[float]) -> list[float]:
        """The rates of the whole state."""
        return self._at(t, z, self.rates(t, z))[1]

    @property
    def operations(self) -> int:
        """Of one evaluation of `rates`."""
        return self._accelerations.operations

    def fits(self, t: float, y: Sequence[float]) -> bool:
        """Do the independent numbers of a state tell the others?"""
        there = self.whole(t, self.part(y))
        return all(abs(a - b) <= MISSED * s for a, b, s in zip(there, y, self.scale, strict=True))

    def steps(
        self, integrator: Integrator, f: Rates, t0: float, y0: Sequence[float], t1: float, setting: Setting
    ) -> Iterator[Step]:
        """The steps of the whole state that an integrator makes; `f`: `rates`, perhaps between two times only."""
        z0 = self.part(y0)
        try:
            yield from map(self.step, integrator.steps(f, t0, z0, t1, self.setting(setting, t0, z0)))
        except StepTooSmall as stuck:
            stuck.y = self.whole(stuck.t, stuck.y)
            raise

    def setting(self, setting: Setting, t: float, z: Sequence[float]) -> Setting:
        """The same of the independent numbers, for a motion from this start."""
        scale, project = self.part(setting.scale), self._projected(setting.project, t, z)
        if not self._turning:
            return replace(setting, scale=scale, project=project)
        gains = self.rates(t, z)
        gain = max(abs(gains[i]) for i in self._turning)
        return replace(setting, scale=scale, project=project, limit=partial(self._longest, gain))

    def _longest(self, gain: float, z: Sequence[float]) -> float:
        """The longest step from a state, if turning speeds up by `gain`: what is at rest now may soon be fast."""
        fastest = max([abs(z[i]) for i in self._turning])
        sooner = fastest + math.sqrt(fastest * fastest + 2.0 * TURN * gain)
        return 2.0 * TURN / sooner if sooner else math.inf

    def _projected(self, project: Project | None, t0: float, z0: Sequence[float]) -> Project | None:
        if project is None:
            return None
        if self.energies is None or len(self.free) - self.loops != 1:
            return (lambda t, z: self._closed(project, t, z)) if self.loops else None
        total = sum(self._energy(t0, z0))
        return lambda t, z: self._as_swift(t, self._closed(project, t, z) if self.loops else z, total)

    def _closed(self, project: Project, t: float, z: list[float]) -> list[float]:
        """With closed loops."""
        return self.part(project(t, self.whole(t, z)))

    def _energy(self, t: float, z: Sequence[float]) -> list[float]:
        """Kinetic and potential [J]."""
        if self._energies is None:
            assert self.energies is not None
            self._energies = compiled(self.energies, self.inputs, self.layout.time, given=self._known)
        return self._energies.function(t, z)

    def _as_swift(self, t: float, z: list[float], total: float) -> list[float]:
        """With velocities that make up the whole energy."""
        kinetic, potential = self._energy(t, z)
        missing = total - potential - kinetic
        if not abs(missing) < SWIFT * kinetic:
            self._supplied = 0.0
            return z
        self._supplied = missing
        half, factor = len(self.free), math.sqrt(1.0 + missing / kinetic)
        return [*z[:half], *(factor * v for v in z[half:])]

    def step(self, step: Step) -> Step:
        """A step of the whole state."""
        inside = step.inside
        before, y0, r0 = self._end
        if before is not step.y0:
            y0, r0 = self._at(step.t0, step.y0, step.r0)
        y1, r1 = self._at(step.t1, step.y1, step.r1)
        self._end = step.y1, y1, r1
        return Step(
            step.t0,
            y0,
            r0,
            step.t1,
            y1,
            r1,
            lambda t: self.whole(t, inside(t)),
            step.error,
            step.fastest,
            self._supplied,
        )

    def _at(self, t: float, z: Sequence[float], r: Sequence[float]) -> tuple[list[float], list[float]]:
        """State and rates."""
        if self._both is None:
            self._both = self._states_and_rates()
        half = self.layout.count
        found = self._both.function(t, [*z, *r[len(self.free) :]])
        return found[: 2 * half], found[half:]

    def _states_and_rates(self) -> Code:
        """The state, and behind it the accelerations."""
        layout, graph = self.layout, self.layout.graph
        first = len(graph.names)
        seconds = {i: graph.variable(f"second{first}_{i}", 0.0) for i in self.free}
        slots = layout.slots
        rates = {slots[i].coordinate: slots[i].rate for i in self.free} | {slots[i].rate: a for i, a in seconds.items()}
        given = graph.rates(self._speeds, {layout.time: graph.number(1.0), **rates})
        known = seconds | dict(zip(self.given, given, strict=True))
        outputs = [*(self._known.get(v, v) for v in layout.state), *(known[i] for i in range(layout.count))]
        return compiled(outputs, (*self.inputs, *seconds.values()), layout.time)
