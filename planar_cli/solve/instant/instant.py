"""One instant from its file to the choice of modes that holds: geometry, velocities, every mode tried in numbers."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.components import components_of
from planar_cli.equation.kinematics.motion import Motion, TreeBuilder
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.system.driving import driving_pushes
from planar_cli.equation.system.headings import headings
from planar_cli.equation.system.known_turns import with_known_turns
from planar_cli.equation.system.setup import Setup, is_linear, names_in
from planar_cli.equation.system.system import Statements, System, make_system
from planar_cli.equation.system.turned_pushes import with_turned
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.joints.base import Joint, distinct
from planar_cli.loads.base import Load, mode_key
from planar_cli.principles.base import Family, Principle
from planar_cli.problem.implied.stated_downward import stated_downward
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Mode, Push, Test
from planar_cli.problem.scene.keys import Flow, keys_of
from planar_cli.problem.scene.polar import TOGETHER
from planar_cli.records import record
from planar_cli.solve.instant.asked import (
    alias_of,
    asked_by_axis,
    is_pure_kinematics,
    names_anywhere,
    names_of_directions,
)
from planar_cli.solve.instant.inequalities import Broken, broken
from planar_cli.solve.instant.locked import LOCKED, locked
from planar_cli.solve.instant.study import Outcome, Velocities, accelerate, solve_velocities
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.principled import at_instants, position_of

MOST_MODES = 400
TINY = Decimal("1e-25")
OPPOSED = "would hold only with the opposite direction"
"""How the objection to a vector ends that points against the direction that the file gives it."""
OPEN = "velocities are open"
"""The objection to modes in which nothing tells how fast the parts move."""
NONLINEAR = "accelerations enter nonlinearly"
"""The objection to modes in which only a search finds the accelerations."""


@record
class Trial:
    """One choice of modes: its system, its velocities and outcomes for each valuation, and what speaks against it.

    `objection`: why it is rejected ("" when it holds); `broken`: the inequality of the file that speaks against it.
    """

    choice: tuple[int, ...]
    system: System
    velocities: tuple[Velocities, ...]
    outcomes: tuple[Outcome, ...]
    objection: str
    tests: tuple[tuple[Test, Any], ...] = ()
    broken: Broken | None = None


Lift = Callable[[Principle, System, tuple[int, ...]], tuple[Family, ...]]
"""What a principle that needs a general position offers in one choice of modes, in the unknowns of the instant."""


class Instant:
    """The scene of one instant and its modes. `principle`: what tells accelerations and forces; `lift`: how it gets a
    general position, where it needs one.
    """

    def __init__(self, setup: Setup) -> None:
        self.setup, self.scene, self.statements = setup, setup.scene, setup.statements
        self.joints = distinct(self.scene.problem.joints)
        self.kinematic = is_pure_kinematics(self.scene.problem)
        self.aliases = alias_of(self.scene.problem.joints, self.joints)
        self.modes: list[tuple[Joint | Load, tuple[Mode, ...]]] = [(j, self.modes_of(j)) for j in self.joints]
        for load in self.scene.problem.loads:
            found = load.modes(self.scene)
            if found:
                self.modes.append((replace(load, name=mode_key(load.name)), found))
                self.aliases[mode_key(load.name)] = load.name
        self.scene.forget_valuations()
        names = [b.name for b in self.scene.problem.bodies]
        self.builder = self.tree_builder(names)
        self.symbols: dict[str, sp.Symbol] = {}
        self.turned: frozenset[str] = frozenset()
        """Reactions that count the other way than their joints have them."""
        apart = TreeBuilder(Ledger(), self.scene.rigid, self.scene.own_name, names)
        self.free = Motion(apart.build((), hang=False), self.scene.center, self.scene.arms.between, {})
        self.drivers: tuple[Push, ...] = ()
        self.plain = asked_by_axis(self.scene.problem, self.joints)
        self.principle = at_instants(self.scene.problem.method)
        self.lift: Lift | None = None

    def families(
        self,
        principle: Principle,
        system: System,
        value: Valuation,
        choice: tuple[int, ...],
        coordinates: tuple[Coordinate, ...] = (),
    ) -> tuple[Family, ...]:
        """The equations that a principle offers. `coordinates`: of a general position."""
        if principle.general and self.scene.displacement is None:
            return () if self.lift is None else self.lift(principle, system, choice)
        return tuple(principle.at_instant(position_of(system, value, coordinates)))

    def modes_of(self, joint: Joint) -> tuple[Mode, ...]:
        """The ways in which a joint may act; of one that has parted, as drawn."""
        parted = self.setup.parted.get(joint.name)
        found = joint.modes(self.scene) if parted is None else parted
        return held(found) if self.kinematic else found

    def tree_builder(self, bodies: list[str]) -> TreeBuilder:
        """What makes the unknowns of the motion; the coordinates of a general position keep their own sense."""
        scene, own, heading = self.scene, at_instants(self.scene.problem.method), headings(self.scene, self.statements)
        builder = TreeBuilder(scene.ledger, scene.rigid, scene.own_name, bodies, components_of(scene), heading)
        # Over time the places of a chain are told by the angles of its bodies, from its beginning to its end.
        builder.pivots_first = scene.displacement is None and not scene.problem.states
        builder.going = dict(scene.problem.going) or stated_downward(scene.problem)
        return builder if own.general else with_known_turns(builder, scene, self.statements, self.modes)

    def name_of(self, push: Push) -> tuple[str, str]:
        """How a push is called, and its unit."""
        return push.name, push.unit

    @property
    def at_rest(self) -> bool:
        return None in self.statements.rest

    def add_drivers(self) -> bool:
        """Let every prescribed motion bring the unknown force or torque that keeps it going. False: there is none to
        add.
        """
        if self.drivers:
            return False
        system = self.system(tuple(0 for _ in self.modes))
        self.drivers = driving_pushes(system, self.free)
        return bool(self.drivers)

    @property
    def drives_at_will(self) -> bool:
        """Is an extreme sought of a motion that is prescribed with a constant which no load brings about? Then what
        drives leaves that constant free, also where the bodies could move alone. So it does in the equilibrium beside
        a motion that is known.
        """
        sought = {s.name for s in self.scene.ledger.sought}
        prescribed = [s for r, always in self.statements.relations if always for s in (r.left, r.right)]
        loads = [
            side
            for load in self.scene.problem.loads
            for spec in keys_of(type(load))
            if isinstance(side := getattr(load, spec.name), Side)
        ]
        driven = {n for side in prescribed for n in names_anywhere(side)} & sought
        if None in self.statements.equilibrium and prescribed and not driven:
            return True
        return bool(self.statements.extremes and driven) and not any(names_anywhere(s) & driven for s in loads)

    def must_seek(self) -> bool:
        """Are extremes asked for, or constants sought that enter nonlinearly?"""
        if self.statements.extremes:
            return True
        return bool(self.scene.ledger.sought) and not self._sought_linear()

    def _sought_linear(self) -> bool:
        """Do all sought constants enter as magnitudes of loads, or not at all?"""
        ledger = self.scene.ledger
        if names_of_directions(self.scene.problem) & {s.name for s in ledger.sought}:
            return False
        hidden = [e for p in self.scene.points.values() for e in (p.x, p.y)]
        hidden += [*ledger.definitions.values(), *ledger.values.values()]
        hidden += [e for b in self.scene.bodies.values() for e in (b.mass, b.inertia)]
        hidden += [x for _, found in self.modes for mode in found for law in mode.facts.laws for x in (law.factor,)]
        hidden += [f for _, found in self.modes for mode in found for t in mode.tests for _, f in t.pushes]
        for expr in hidden:
            if set(ledger.sought) & sp.sympify(expr).free_symbols:
                return False
        for relation, _ in self.statements.relations:
            for side in (relation.left, relation.right):
                if any(ledger.symbols.get(n) in ledger.sought for n in names_anywhere(side)):
                    return False
        return self._loads_linear()

    def _loads_linear(self) -> bool:
        """Directions and stiffnesses are known; only magnitudes are sought."""
        sought = {s.name for s in self.scene.ledger.sought}
        for load in self.scene.problem.loads:
            for spec in keys_of(type(load)):
                value = getattr(load, spec.name)
                if isinstance(value, (str, tuple, type(None))):
                    continue
                if spec.name in ("magnitude", "moment"):
                    if not is_linear(value, sought):
                        return False
                    continue
                sides = (value.speed, value.angle) if isinstance(value, Flow) else (value,)
                if any(names_in(side) & sought for side in sides):
                    return False
        return True

    def system(self, choice: tuple[int, ...]) -> System:
        """The equations of one choice of modes."""
        modes = {j.name: with_turned(found[i], self.turned) for (j, found), i in zip(self.modes, choice, strict=True)}
        rest = (self.symbols, self.aliases, self.plain, self.drivers, self.name_of)
        return make_system(self.scene, self.builder, self.statements, modes, *rest)

    def choices(self) -> Iterator[tuple[int, ...]]:
        """All choices, the natural assumptions first: by how many joints depart from their first mode."""
        allowed = [self._allowed(joint, found) for joint, found in self.modes]
        every = itertools.product(*allowed)
        return iter(sorted(itertools.islice(every, MOST_MODES * 10), key=lambda c: (sum(i > 0 for i in c), sum(c))))

    def _allowed(self, joint: Joint | Load, found: tuple[Mode, ...]) -> list[int]:
        """The modes that the file leaves open."""
        name = self.aliases[joint.name]
        # Several joints may be called by one point: a contact that sticks and a rope that may be slack.
        alike = [m for j, modes in self.modes if self.aliases[j.name] == name for m in modes]
        own, known = {m.name for m in found}, {m.name for m in alike}
        wanted = {
            word for stated, word in self.statements.modes if stated == name and (word in own or word not in known)
        }
        return [i for i, mode in enumerate(found) if not wanted or mode.name in wanted or not mode.name]

    def try_choice(
        self, choice: tuple[int, ...], valuations: tuple[Valuation, ...], given: dict[sp.Symbol, Decimal] | None = None
    ) -> Trial:
        """Solve one choice in numbers and test its assumptions. `given`: velocities and constants that are settled."""
        system = self.system(choice)
        if self.at_rest and any(
            m.sliding is not None and m.direction == 0 and self._runs(m, valuations) for m in system.modes.values()
        ):
            return Trial(choice, system, (), (), "it slides already")
        velocities = tuple(
            solve_velocities(system, v, self.at_rest, given is None, self._speeds(system, given)) for v in valuations
        )
        if any(v.conflict for v in velocities):
            return Trial(choice, system, velocities, (), "velocities")
        if any(v.free for v in velocities):
            return Trial(choice, system, velocities, (), OPEN)
        outcomes = tuple(
            accelerate(system, vel, v, self.free, given or {}) for vel, v in zip(velocities, valuations, strict=True)
        )
        if any(o.nonlinear for o in outcomes):
            return Trial(choice, system, velocities, (), NONLINEAR)
        for outcome in outcomes:
            moving = self._moves_otherwise(system, outcome)
            if moving:
                return Trial(choice, system, velocities, outcomes, moving)
            if outcome.solved.conflict is not None:
                return Trial(choice, system, velocities, outcomes, "contradiction")
            if locked(system, outcome.assembly, {name for name, _ in self.statements.modes}):
                return Trial(choice, system, velocities, outcomes, LOCKED)
            failed = outcome.failed
            if failed:
                return Trial(choice, system, velocities, outcomes, failed[0][0].words, failed)
            against = self._against(system, outcome)
            if against:
                return Trial(choice, system, velocities, outcomes, against)
            false = self._false(system, outcome)
            if false is not None:
                return Trial(choice, system, velocities, outcomes, false.words, broken=false)
        return Trial(choice, system, velocities, outcomes, "")

    def holds_at(self, choice: tuple[int, ...], value: Valuation) -> bool:
        """Does a choice hold with these numbers?"""
        return not self.try_choice(choice, (value,)).objection

    @staticmethod
    def _speeds(system: System, given: dict[sp.Symbol, Decimal] | None) -> dict[sp.Symbol, Decimal] | None:
        if given is None:
            return None
        rates = system.scene.evaluator.speeds
        names = {s.name for s in (*system.tree.velocity_unknowns(), *rates)}
        return {s: v for s, v in given.items() if s.name in names}

    @staticmethod
    def _runs(mode: Mode, valuations: tuple[Valuation, ...]) -> bool:
        """Does the surface under a body at rest run?"""
        return mode.sliding is not None and mode.sliding.rate != 0 and not valuations[0].is_zero(mode.sliding.rate)

    def _moves_otherwise(self, system: System, outcome: Outcome) -> str:
        """A joint assumed to stick slides already, or slides the other way."""
        for mode in system.modes.values():
            if mode.sliding is None:
                continue
            speed = outcome.assembly.row_speed(mode.sliding)
            if abs(speed) < TINY:
                continue
            if mode.direction == 0 or speed * mode.direction < 0:
                return "it slides already" if mode.direction == 0 else "it slides the other way"
        return ""

    @staticmethod
    def _against(system: System, outcome: Outcome) -> str:
        """A vector that points against the direction that the file gives it, or has a negative size."""
        senses = system.senses()
        if not senses:
            return ""
        numbers = outcome.value.extended(unknowns_of(system, outcome))
        for text, sense in senses:
            number = numbers.known(sense)
            if number is not None and number < -TINY:
                parts = " and ".join(f"`{t}`" for t in text.split(TOGETHER))
                return f"{parts} {OPPOSED}"
        return ""

    def _false(self, system: System, outcome: Outcome) -> Broken | None:
        """An inequality of the file that does not hold; in a general position it is about some state, not about all."""
        if not self.statements.inequalities or self.scene.displacement is not None:
            return None
        numbers = outcome.value.extended(unknowns_of(system, outcome))
        return broken(self.statements.inequalities, system.quantities(), numbers)


def held(modes: tuple[Mode, ...]) -> tuple[Mode, ...]:
    """The modes in which a joint holds: where nothing is said of forces, nothing parts or slackens."""
    found = tuple(m for m in modes if not m.parted) or modes
    return (replace(found[0], words="", tests=()),) if len(found) == 1 else found


def make_instant(
    problem: Any, always: tuple[Any, ...], now: tuple[Any, ...], earlier: dict[str, Any], open_form: bool
) -> Instant:
    """The instant of a problem with what holds always and what holds now."""
    return Instant(Setup(problem, Statements.of(always, now), earlier, open_form))
