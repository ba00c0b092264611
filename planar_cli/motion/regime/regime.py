"""One regime of a scene: one choice of modes with its equations of motion, as functions of time and state.

    M a = Q + Jᵀ μ + friction,        J a + γ = 0

J and γ come from the position residuals of the joints by differentiation, Q from the loads. Multipliers of joints with
kinetic friction act through their pushes: the friction F = μ_k N goes with its normal force, into one column.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property

from planar_cli.integrators.base import OUTSIDE
from planar_cli.loads.base import Load
from planar_cli.motion.regime.guards import LENGTH, Guard, Measured
from planar_cli.motion.regime.held import Held, add
from planar_cli.motion.regime.project import Projector
from planar_cli.motion.regime.sharing import Sharing, sharing
from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.layout import Column, Layout
from planar_cli.motion.terms.rank import Independent
from planar_cli.motion.terms.replacing import replaced
from planar_cli.motion.terms.routine import Routine, System, Unknowns, View
from planar_cli.motion.terms.scales import Scales
from planar_cli.motion.terms.source import Code, Singular, compiled
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.motion.trajectory.reduced import Reduced, told
from planar_cli.problem.scene.facts import Push, Wrench
from planar_cli.records import record

APART = 0.03
"""How far states before and after a singular position are from it, in parts of the scales."""
STILL = 1e-6
"""Below this part of the scale of speeds nothing moves through a singular position."""


@record
class Parts:
    """What a regime is made of."""

    layout: Layout
    scales: Scales
    held: tuple[Held, ...]
    drives: tuple[Constraint, ...]
    """What the file prescribes of places, velocities and accelerations."""
    wrenches: tuple[Wrench, ...]
    """Of all loads that act."""
    loads: Column
    """Their generalized force."""
    wasting: Column
    """That of the loads without a potential."""
    potential: Term
    """Of all loads that have one, J."""
    acting: tuple[Load, ...]
    """The loads: not a spring that acts one way only and is free for now."""
    measured: tuple[Measured, ...]
    """The conditions under which the regime holds."""
    independent: Independent
    """Which of the constraints say something new."""

    @property
    def constraints(self) -> tuple[Constraint, ...]:
        """All of them: of the joints, then of the drives."""
        return (*(c for h in self.held for c in h.constraints), *self.drives)


class Regime:
    """One choice of modes."""

    def __init__(self, parts: Parts) -> None:
        self.parts = parts
        self.layout = parts.layout
        self.constraints = parts.constraints
        self.reactions: tuple[Push, ...] = tuple(p for h in parts.held for p in h.pushes)
        self.guards: tuple[Guard, ...] = tuple(m.guard for m in parts.measured)
        self._numbers = parts.independent.kept
        self._system = self._equations()
        count = self.layout.count
        speeds = self.layout.speeds
        self._rates = Routine(self._system, lambda u: [*speeds, *u[0][:count]], self.neighbour)
        self._forces = Routine(self._system, self._pushes, self.neighbour)
        self._watch = Routine(self._system, self._watched, self.neighbour)
        self._still: Code | None = None
        self._kinetics: Code | None = None
        self._presumed: Code | None = None
        self.projector = Projector(self.layout, self.constraints, self._numbers, parts.scales, parts.independent.values)

    # --- what a motion asks ------------------------------------------------------------------------------------------

    def rates(self, t: float, y: Sequence[float]) -> list[float]:
        """y': the rates of the coordinates, then the accelerations."""
        # Where nothing is watched they are asked for at few states, for which code of its own takes too long.
        part = None if self.guards else self.reduced(t, y)
        return self._whole_rates(t, y) if part is None else part.whole_rates(t, part.part(y))

    def _whole_rates(self, t: float, y: Sequence[float]) -> list[float]:
        """The same of a state that may miss its joints, or near a singular position."""
        found = self._rates(t, y)
        # Continued through a singular position, the first half is only nearly this.
        half = self.layout.count
        found[:half] = y[half:]
        return found

    @cached_property
    def _reduced(self) -> Reduced | None:
        kept = [self.constraints[number] for number in self._numbers]
        given = told(self.layout, kept)
        if not given or len(given) == self.layout.count:
            return None
        sizes = [self.parts.scales.length if s.kind in ("x", "y") else 1.0 for s in self.layout.slots]
        scale = [*sizes, *(size / self.parts.scales.time for size in sizes)]
        energies = (self._kinetic(), self.parts.potential) if self.conservative else None
        return Reduced(self.layout, given, len(kept) - len(given), scale, self._part, self._whole_rates, energies)

    def _part(self, view: View, numbers: Sequence[int]) -> Routine:
        """The rates of some coordinates and their accelerations."""
        speeds = [self.layout.speeds[i] for i in numbers]
        return Routine(self._system, lambda u: [*speeds, *(u[0][i] for i in numbers)], view=view)

    def reduced(self, t: float, y: Sequence[float]) -> Reduced | None:
        """The same with the independent coordinates alone; None where that does not serve in this state."""
        found = self._reduced
        return found if found is not None and found.fits(t, y) else None

    def forces(self, t: float, y: Sequence[float]) -> list[float]:
        """The pushes, in the order of `reactions` [N or N m]."""
        return self._forces(t, y)

    def watch(self, t: float, y: Sequence[float]) -> list[float]:
        """The values of the guards: >= 0, or > 0, as long as the regime holds. Forces that redundant constraints share
        are taken as they hold best.
        """
        if any(m.needs_forces for m in self.parts.measured):
            try:
                values = self._watch(t, y)
                return values if self._sharing is None else self._sharing.best(t, y, values)
            except OUTSIDE:
                # Beyond the end of a free part of a rope nothing but that is looked at.
                values = self._lengths(t, y)
                if min(values, default=0.0) >= 0.0:
                    raise
                return values
        if self._still is None:
            self._still = compiled(self._watched([]), self.layout.state, self.layout.time)
        return self._still.function(t, y)

    def _lengths(self, t: float, y: Sequence[float]) -> list[float]:
        """The values of the guards, of those that are no lengths a usual one."""
        graph = self.layout.graph
        terms = [m.state if m.guard.kind == LENGTH else graph.number(m.guard.scale) for m in self.parts.measured]
        return compiled(terms, self.layout.state, self.layout.time).function(t, y)

    def project(self, t: float, y: Sequence[float]) -> list[float]:
        """The nearest state, weighed by masses, that fulfils all constraints of places and velocities."""
        return self.projector.project(t, y)

    def closed(self, t: float, y: Sequence[float]) -> list[float]:
        """A state inside a step on the joints: where some close loops, it is only nearly there."""
        open_chain = self._reduced is not None and not self._reduced.loops
        return list(y) if open_chain or not self.constraints else self.project(t, y)

    def residuals(self, t: float, y: Sequence[float]) -> list[float]:
        """What is left of the constraints: of places, then of velocities, in parts of their scales."""
        return self.projector.residuals(t, y)

    def energy(self, t: float, y: Sequence[float]) -> float:
        """Kinetic energy and potentials [J]."""
        return self._measures(t, y)[0]

    def momentum(self, t: float, y: Sequence[float]) -> list[float]:
        """Linear momentum x, y [N s] and angular momentum about the origin [N m s]."""
        return self._measures(t, y)[1:]

    def power(self, t: float, y: Sequence[float]) -> float:
        """Of loads without potential, of drives and of friction [W]."""
        return self._power(t, y)[0]

    @cached_property
    def conservative(self) -> bool:
        """Does its energy stay the same: is there nothing that feeds or drains it?"""
        power = self._power_of_unknowns
        return power.constant and power.value == 0

    @cached_property
    def _power_of_unknowns(self) -> Term:
        """The power in terms of stand-ins for the unknowns."""
        (power,) = self._powers(self._system.stand_ins())
        return power

    @cached_property
    def _power(self) -> Routine:
        power = self._power_of_unknowns
        if set(ordered([power])).isdisjoint(v for part in self._system.stand_ins() for v in part):
            return self._of_state([power])
        return Routine(self._system, self._powers, self.neighbour)

    def presumed(self, t: float, y: Sequence[float]) -> list[tuple[str, str, float]]:
        """Lengths that joints take for granted and do not keep, in parts of their scale, with the joint and words."""
        found = [(held.joint, words, term) for held in self.parts.held for words, term in held.presumed]
        if self._presumed is None:
            self._presumed = compiled([term for *_, term in found], self.layout.state, self.layout.time)
        lengths = self._presumed.function(t, y) if found else []
        return [
            (joint, words, x / self.parts.scales.length) for (joint, words, _), x in zip(found, lengths, strict=True)
        ]

    @property
    def operations(self) -> int:
        """Of one evaluation while it is followed."""
        return self._rates.operations if self._reduced is None else self._reduced.operations

    @property
    def source(self) -> str:
        """The generated code of the rates of a whole state."""
        return self._rates.code(0).text

    def neighbour(self, t: float, y: Sequence[float], place: int) -> tuple[float, list[float]]:
        """A state some steps before or after this one on the way that its velocities go; raises Singular."""
        half, scales = self.layout.count, self.parts.scales
        sizes = [scales.length if s.kind != "theta" else 1.0 for s in self.layout.slots]
        fastest = max((abs(v) / s for v, s in zip(y[half:], sizes, strict=True)), default=0.0)
        if fastest * scales.time < STILL:
            raise Singular
        step = place * APART / fastest
        moved = [q + step * v for q, v in zip(y[:half], y[half:], strict=True)]
        return t + step, self.projector.regular(t + step, [*moved, *y[half:]])

    @property
    def indeterminate(self) -> frozenset[str]:
        """Pushes of redundant constraints: the motion does not tell them."""
        found, number = set(), 0
        for held in self.parts.held:
            for constraint in held.constraints:
                if number in self.parts.independent.open:
                    found |= {p.name for p in held.pushes if _meet(constraint.row, held.columns[p.name])}
                number += 1
        return frozenset(found)

    @property
    def shared(self) -> frozenset[str]:
        """Joints whose forces are not unique, as redundant constraints share them."""
        return frozenset(p.joint for p in self.reactions if p.name in self.indeterminate)

    @cached_property
    def _sharing(self) -> Sharing | None:
        """How redundant constraints may share their forces; None where these are unique."""
        if not self.parts.independent.open:
            return None
        held, measured = self.parts.held, self.parts.measured
        return sharing(self.layout, held, self._driving(), measured, self.parts.scales.length)

    # --- equations ---------------------------------------------------------------------------------------------------

    def _equations(self) -> System:
        """[M W; J 0] (a, -μ) = (Q, -γ), symmetric where no friction is."""
        layout, graph, count = self.layout, self.layout.graph, self.layout.count
        rows: list[dict[int, Term]] = [{} for _ in range(count + len(self._numbers))]
        zero = graph.number(0.0)
        total: dict[int, Term] = dict(self.parts.loads)
        for held in self.parts.held:
            add(total, held.known(graph), graph.number(1.0), graph)
        for i, slot in enumerate(layout.slots):
            if not (slot.mass.constant and slot.mass.value == 0):
                rows[i][i] = slot.mass
        right = [total.get(i, zero) for i in range(count)]
        columns = self._driving()
        for k, number in enumerate(self._numbers):
            for i, t in columns[number].items():
                rows[i][count + k] = t
            rows[count + k] = dict(self.constraints[number].row)
            right.append(-self.constraints[number].rest)
        return System(layout, rows, [lambda before: right], self.parts.independent.values)

    def _driving(self) -> list[Column]:
        """For every constraint the generalized force of a unit of its multiplier."""
        found: list[Column] = []
        for held in self.parts.held:
            found += held.driving(self.layout.graph)
        return [*found, *(c.row for c in self.parts.drives)]

    def multipliers(self, unknowns: Unknowns) -> list[Term]:
        """Of all constraints; 0 of those that say nothing new."""
        zero = self.layout.graph.number(0.0)
        found = [zero] * len(self.constraints)
        for k, number in enumerate(self._numbers):
            found[number] = -unknowns[0][self.layout.count + k]
        return found

    def exerted(self, unknowns: Unknowns) -> dict[str, Term]:
        """Every push by its name."""
        multipliers = iter(self.multipliers(unknowns))
        found: dict[str, Term] = {}
        for held in self.parts.held:
            own = [next(multipliers) for _ in held.constraints]
            found |= held.exerted(self.layout, own, self.parts.scales.length)
        return found

    def routine(self, outputs: Iterable[Term], unknowns: Sequence[Term]) -> Routine:
        """Terms of the state and of `unknowns` (accelerations, then pushes) as one function."""
        wanted, variables = list(outputs), list(unknowns)
        count, inside = self.layout.count, set(ordered(wanted))
        if inside.isdisjoint(variables):
            return self._of_state(wanted)
        pushed = not inside.isdisjoint(variables[count:])

        def computed(found: Unknowns) -> list[Term]:
            pushes = self.exerted(found) if pushed else {}
            values = [*found[0][:count], *(pushes[p.name] for p in self.reactions if pushed)]
            by = dict(zip(variables, values, strict=pushed))
            return [replaced(t, by) for t in wanted]

        return Routine(self._system, computed, self.neighbour)

    def _of_state(self, outputs: Sequence[Term]) -> Routine:
        """What is known from the state alone: no system has to be solved for it."""
        return Routine(System(self.layout, [], []), lambda found: outputs)

    def _pushes(self, unknowns: Unknowns) -> list[Term]:
        found = self.exerted(unknowns)
        return [found[p.name] for p in self.reactions]

    def _watched(self, unknowns: Unknowns) -> list[Term]:
        needed = any(m.needs_forces for m in self.parts.measured)
        pushes = self.exerted(unknowns) if needed else {}
        return [m.value(pushes) for m in self.parts.measured]

    def _powers(self, unknowns: Unknowns) -> list[Term]:
        """Wasting loads, friction, what drives do, and what energy changes with time alone, or with masses that go
        with places.
        """
        layout, graph = self.layout, self.layout.graph
        total = graph.rate(self._measured()[0], {layout.time: graph.number(1.0)})
        places = {slot.coordinate: slot.rate for slot in layout.slots}
        for slot in layout.slots:
            total = total + graph.rate(slot.mass, places) * slot.rate * slot.rate * 0.5
        force: dict[int, Term] = dict(self.parts.wasting)
        # Forces that do no work on what their joints allow need not be resolved.
        pushes = self.exerted(unknowns) if any(h.followers for h in self.parts.held) else {}
        for held in self.parts.held:
            add(force, held.loads, graph.number(1.0), graph)
            for name in held.followers:
                add(force, held.columns[name], pushes[name], graph)
            if not held.ideal:
                for push in held.free:
                    add(force, held.columns[push.name], pushes[push.name], graph)
        for i, t in force.items():
            total = total + t * layout.slots[i].rate
        multipliers = self.multipliers(unknowns)
        ideal = [h.ideal for h in self.parts.held for _ in h.constraints] + [True] * len(self.parts.drives)
        for constraint, multiplier, without in zip(self.constraints, multipliers, ideal, strict=True):
            if without and (constraint.place is not None or constraint.rate is not None):
                total = total + multiplier * constraint.moving
            elif without:
                for i, t in constraint.row.items():
                    total = total + multiplier * (t * layout.slots[i].rate)
        return [total]

    def _measures(self, t: float, y: Sequence[float]) -> list[float]:
        """Energy, momentum x, y, angular momentum."""
        if self._kinetics is None:
            self._kinetics = compiled(self._measured(), self.layout.state, self.layout.time)
        return self._kinetics.function(t, y)

    def _kinetic(self) -> Term:
        energy = self.layout.graph.number(0.0)
        for slot in self.layout.slots:
            energy = energy + slot.mass * slot.rate * slot.rate * 0.5
        return energy

    def _measured(self) -> list[Term]:
        layout, graph = self.layout, self.layout.graph
        energy = self.parts.potential + self._kinetic()
        px, py, angular = (graph.number(0.0) for _ in range(3))
        for frame in layout.frames.values():
            x, y = layout.slots[frame.x], layout.slots[frame.y]
            px, py = px + x.mass * x.rate, py + y.mass * y.rate
            angular = angular + x.mass * (x.coordinate * y.rate - y.coordinate * x.rate)
            if frame.theta is not None:
                turn = layout.slots[frame.theta]
                angular = angular + turn.mass * turn.rate
        return [energy, px, py, angular]


def _meet(row: Column, column: Column) -> bool:
    """Does a push do anything along a constraint, as drawn?"""
    parts = [t.value * column[i].value for i, t in row.items() if i in column]
    return abs(sum(parts)) > 1e-9 * max(map(abs, parts), default=0.0)
