"""All equations of one instant in one choice of modes: motion along a tree, conditions, pushes, loads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion, Tree, TreeBuilder
from planar_cli.equation.kinematics.quantities import Quantities, quantities_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.scene.swaying import ROPES, sways
from planar_cli.equation.system.conditions import (
    ACCELERATION,
    POSITION,
    VELOCITY,
    Condition,
    coordinate_conditions,
    joint_conditions,
    order,
    stated,
)
from planar_cli.equation.system.driven_rest import relative_rest
from planar_cli.equation.system.held import is_held
from planar_cli.equation.system.natural import natural_pushes
from planar_cli.equation.system.two_force import with_two_force_members
from planar_cli.equation.values.determined import told_by
from planar_cli.problem.language.expression import (
    AtRest,
    Equilibrium,
    Extreme,
    Number,
    Quantity,
    Relation,
    Statement,
    Word,
)
from planar_cli.problem.scene.facts import Law, Mode, Push, Skid, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import changing, record

MOST_FREE = 2
"""Where more accelerations are free the pin forces are x and y: no link tells the way of its pin."""


@record
class Statements:
    """What the file states for one instant.

    `relations`: equations, True when they hold all the time. `rest`: bodies at rest (None among them: everything).
    `equilibrium`: accelerations vanish too. `inequalities`: choose among roots.
    `modes`: (joint, mode) that is assumed. `extremes`: what is largest or smallest.
    """

    relations: tuple[tuple[Relation, bool], ...]
    rest: tuple[str | None, ...]
    equilibrium: tuple[str | None, ...]
    inequalities: tuple[Relation, ...]
    modes: tuple[tuple[str, str], ...] = ()
    extremes: tuple[Extreme, ...] = ()

    @staticmethod
    def of(always: tuple[Statement, ...], now: tuple[Statement, ...]) -> Statements:
        relations = [(s, True) for s in always if isinstance(s, Relation) and s.operator == "=" and mode_of(s) is None]
        relations += [(s, False) for s in now if isinstance(s, Relation) and s.operator == "=" and mode_of(s) is None]
        everything = (*always, *now)
        # A body that is said to go on moves steadily in its equilibrium.
        steady = any(isinstance(s, Relation) and _tells_motion(s) for s in now)
        rests = AtRest if steady else AtRest | Equilibrium
        still = tuple(s.body for s in everything if isinstance(s, rests))
        balanced = tuple(s.body for s in everything if isinstance(s, Equilibrium))
        unequal = tuple(s for s in everything if isinstance(s, Relation) and s.operator != "=")
        modes = tuple(m for s in everything if isinstance(s, Relation) and (m := mode_of(s)) is not None)
        extremes = tuple(s for s in everything if isinstance(s, Extreme))
        return Statements(tuple(relations), still, balanced, unequal, modes, extremes)


def _tells_motion(relation: Relation) -> bool:
    """Does a relation say that something moves: that a velocity is a number other than zero, more or less than one?"""
    for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if isinstance(one, Quantity) and one.word in ("v", "omega", "dot"):
            nothing = isinstance(other, Number) and other.value == 0
            return relation.operator in ("<", ">") or not nothing
    return False


def mode_of(relation: Relation) -> tuple[str, str] | None:
    """(joint, word) of `mode(j) = word`; None for any other relation."""
    for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if isinstance(one, Quantity) and one.word == "mode" and isinstance(other, Word):
            return one.things[0], other.word
    return None


@changing
class System:
    """One choice of modes. `still`: velocity unknowns that are zero. `unknown_loads`: constants that are sought."""

    scene: Scene
    modes: dict[str, Mode]
    statements: Statements
    builder: TreeBuilder
    tree: Tree
    pushes: tuple[Push, ...]
    laws: tuple[Law, ...]
    symbols: dict[str, sp.Symbol]
    first: Motion
    aliases: dict[str, str]
    motion: Motion | None = None
    reactions: Reactions | None = None
    wrenches: tuple[Wrench, ...] = ()
    titles: dict[sp.Symbol, str] = field(default_factory=dict)
    held: bool | None = None
    """Do the joints keep everything where it is? None: that has not been asked."""

    def velocity_conditions(self) -> list[Condition]:
        """Everything that velocities must satisfy (rest is applied afterwards)."""
        quantities = self.quantities_of(self.first, None)
        return [*self._conditions(quantities, VELOCITY), *self._touching()]

    def _touching(self) -> list[Condition]:
        """What is about to part, tip or slacken at this instant still has no velocity apart."""
        if self.scene.displacement is not None:
            return []
        touching = [mode.touching for mode in self.modes.values()]
        closures = tuple(j for t in touching for j in t.joinings)
        rows = [row for t in touching for row in t.rows]
        return joint_conditions(Tree((), closures), rows, self.first, VELOCITY, self.scene.rigid)

    def settle(self, known: dict[sp.Symbol, sp.Expr], wrenches: tuple[Wrench, ...]) -> None:
        """Velocities are settled: `known` are put in; loads now state what they do."""
        self.motion = Motion(self.tree, self.scene.center, self.scene.arms.between, known)
        self.wrenches = wrenches
        self.reactions = self._reactions()

    def hanging(self) -> set[sp.Symbol]:
        """Velocities across ropes of bodies that hang straight down on them alone, where nothing makes them sway; on a
        rope that has been slack for some time nothing hangs.
        """
        now = ROPES if self.scene.displacement is None else ROPES[:1]
        ropes = {name for name, mode in self.modes.items() if mode.name in now}
        found = set()
        for edge in self.tree.edges:
            on_rope = edge.joining is None or edge.joining.joint in ropes
            if on_rope and not sways(self.scene, self.modes.values(), edge.body):
                found |= {s for s in (edge.slide, edge.rise) if s is not None}
        return found if ropes else set()

    def states(self, level: int) -> bool:
        """Does the file state anything of this level: a velocity, or an acceleration or force?"""
        names = {s.name for s in self.scene.ledger.coordinates}
        return any(order(relation, names) == level for relation, _ in self.statements.relations)

    def skids(self) -> tuple[Skid, ...]:
        """Bodies that slide on something flat."""
        return tuple(s for mode in self.modes.values() for s in mode.facts.skids)

    def rates(self) -> dict[sp.Symbol, sp.Symbol]:
        """Every velocity unknown of the tree, and the rates of coordinates, with the acceleration that is its rate."""
        pairs: list[tuple[sp.Expr | None, sp.Expr | None]] = []
        for e in self.tree.edges:
            pairs += [(e.slide, e.slide_rate), (e.rise, e.rise_rate), (e.spin, e.spin_rate)]
        own = {v: a for v, a in pairs if isinstance(v, sp.Symbol) and isinstance(a, sp.Symbol)}
        speeds, motions = set(self.scene.evaluator.speeds), self.scene.evaluator.motions.values()
        return own | {v: a for v, a in motions if v in speeds and isinstance(a, sp.Symbol)}

    def idle(self) -> tuple[str, ...]:
        """Loads that do not act in these modes, by the keys of their modes."""
        return tuple(k for mode in self.modes.values() for k in mode.facts.idle)

    def _reactions(self) -> Reactions:
        followers = {law.push: law for law in self.laws}
        pairs: list[tuple[Push, sp.Expr]] = []
        for push in self.pushes:
            law = followers.get(push.name)
            if law is None:
                pairs.append((push, self.symbols[push.name]))
            else:
                pairs.append((push, law.factor * (self.symbols[law.of] if law.of else sp.S.One)))
        return Reactions(tuple(pairs), self.wrenches, self.aliases, sp.S.Zero)

    def acceleration_conditions(self) -> list[Condition]:
        """Everything that accelerations must satisfy beside the principles of kinetics."""
        return self._conditions(self.quantities(), ACCELERATION)

    def stated_accelerations(self, motion: Motion) -> list[Condition]:
        """What the file itself states of accelerations and forces, in some other motion's unknowns."""
        return self._file_conditions(self.quantities_of(motion, self.reactions), ACCELERATION)

    def quantities(self) -> Quantities:
        assert self.motion is not None
        return self.quantities_of(self.motion, self.reactions)

    def quantities_of(self, motion: Motion, reactions: Reactions | None) -> Quantities:
        """Quantities in some motion, with these reactions."""
        return quantities_of(self.scene, motion, reactions)

    def senses(self) -> list[tuple[str, sp.Expr]]:
        """What must not be negative, where a relation gives the size or the direction of a vector."""
        names = {s.name for s in self.scene.ledger.coordinates}
        quantities = self.quantities()
        relations = list(self.statements.relations)
        levels = (POSITION, VELOCITY, ACCELERATION)
        found = [c for n in levels for c in stated(relations, quantities, quantities.evaluator, names, n)]
        return [(c.text, c.sense) for c in found if c.sense is not None]

    def _conditions(self, quantities: Quantities, level: int) -> list[Condition]:
        motion = quantities.motion
        rows = [row for mode in self.modes.values() for row in mode.facts.rows]
        found = [
            *joint_conditions(self.tree, rows, motion, level, self.scene.rigid),
            *self._file_conditions(quantities, level),
        ]
        if level == ACCELERATION and not self._all_balanced() and self.is_held():
            found += [Condition("held", "equilibrium", a) for a in motion.tree.acceleration_unknowns()]
        return found

    def _file_conditions(self, quantities: Quantities, level: int) -> list[Condition]:
        """The relations of the file, points that follow formulas, and bodies at rest."""
        names = {s.name for s in self.scene.ledger.coordinates}
        found = stated(list(self.statements.relations), quantities, quantities.evaluator, names, level)
        found += coordinate_conditions(quantities, set(self.scene.ledger.coordinates), level, self.tree)
        return found + self._rest(quantities.motion, level)

    def balanced(self, body: str) -> bool:
        """Is a body in equilibrium?"""
        return body in self.statements.equilibrium or self._all_balanced() or self.is_held()

    def is_held(self) -> bool:
        """Do the joints keep everything where it is, so that it is in equilibrium, also where it is about to slip?"""
        if self.held is None:
            driven = any(always for _, always in self.statements.relations)
            self.held = not driven and is_held(self.scene, self.first, self.modes.values())
        return self.held

    def _all_balanced(self) -> bool:
        """Is everything in equilibrium, and not driven by `motion`?"""
        driven = any(always for _, always in self.statements.relations)
        return None in self.statements.equilibrium and not driven

    def _of_coordinates(self, tree: Tree) -> list[sp.Symbol]:
        """The second rates of coordinates that move particles without unknowns of their own."""
        parts = [sp.sympify(a) for e in tree.edges if e.components is not None for a in e.components.accelerations]
        inside = set().union(*(a.free_symbols for a in parts))
        return [a for a in self.scene.evaluator.second_rates if a in inside]

    def _second_rates(self) -> list[sp.Expr]:
        """The second rates of coordinates."""
        return self.scene.evaluator.second_rates

    def driven(self) -> set[sp.Expr]:
        """The accelerations that joints and `motion` tell."""
        motion = self.motion
        assert motion is not None
        names = {s.name for s in self.scene.ledger.coordinates}
        quantities = self.quantities_of(motion, self.reactions)
        always: list[tuple[Relation, bool]] = [(r, True) for r, lasts in self.statements.relations if lasts]
        rows = [row for mode in self.modes.values() for row in mode.facts.rows]
        found = [
            *joint_conditions(self.tree, rows, motion, ACCELERATION, self.scene.rigid),
            *stated(always, quantities, quantities.evaluator, names, ACCELERATION),
            *coordinate_conditions(quantities, set(self.scene.ledger.coordinates), ACCELERATION, self.tree),
        ]
        unknowns = [*motion.tree.acceleration_unknowns(), *self._second_rates()]
        return told_by([e for c in found for e in c.rows()], unknowns, self.scene.valuations[0])

    def _rest(self, motion: Motion, level: int) -> list[Condition]:
        if level == ACCELERATION and self._all_balanced():
            own = [*motion.tree.acceleration_unknowns(), *self._of_coordinates(motion.tree)]
            return [Condition("given", "equilibrium", a) for a in own]
        found: list[Condition] = []
        if level == ACCELERATION and None in self.statements.equilibrium:
            found += relative_rest(motion, self.tree, self._second_rates(), self.driven())
        for name in self.statements.rest if level == VELOCITY else self.statements.equilibrium:
            if name is None:
                continue
            twists = motion.velocities if level == VELOCITY else motion.accelerations
            center = self.scene.center(name)
            linear = motion.velocity(center, name) if level == VELOCITY else motion.acceleration(center, name)
            text = f"{name} at rest" if level == VELOCITY else f"{name} in equilibrium"
            found.append(Condition("given", text, linear, body=name))
            if self.scene.rigid(name):
                found.append(Condition("given", text, twists[name].angular, body=name))
        return found

    # --- how a body is led -------------------------------------------------------------------------------------------

    def straight_ways(self, body: str) -> list[Vec]:
        """The directions of the straight lines along which it is led or rolls."""
        found = []
        for mode in self.modes.values():
            for j in mode.facts.joinings:
                if body in (j.mover, j.base) and j.path is not None and j.path.curvature == 0:
                    found.append(j.path.tangent)
                if body in (j.mover, j.base) and j.rolling is not None:
                    found.append(j.rolling.tangent)
        return found

    def is_pivot(self, body: str, point: Vec) -> bool:
        """Is it held at a fixed point there? A wheel rolls over its point of contact."""
        return any(
            {j.mover, j.base} == {body, GROUND}
            and j.path is None
            and j.rolling is None
            and j.drift is None
            and all(self.scene.is_zero(p) for p in (j.point.x - point.x, j.point.y - point.y))
            for mode in self.modes.values()
            for j in mode.facts.joinings
        )


def _freedom(tree: Tree) -> int:
    """How many accelerations stay free when the closures of vector loops are counted."""
    return len(tree.acceleration_unknowns()) - sum(2 if j.path is None else 1 for j in tree.closures)


def make_system(
    scene: Scene,
    builder: TreeBuilder,
    statements: Statements,
    modes: dict[str, Mode],
    symbols: dict[str, sp.Symbol],
    aliases: dict[str, str],
    plain: frozenset[str],
    drivers: tuple[Push, ...] = (),
    named: Callable[[Push], tuple[str, str]] = lambda push: (push.name, push.unit),
) -> System:
    """The equations for one choice of modes; `symbols` keeps the symbol of each push across choices; `named`: how it is
    called, and its unit.
    """
    facts = [mode.facts for mode in modes.values()]
    tree = builder.build(j for f in facts for j in f.joinings)
    several = {j.joint for f in facts for j in f.joinings} if _freedom(tree) > MOST_FREE else set[str]()
    natural = natural_pushes(scene, facts, plain | several)
    pushes = (*with_two_force_members(scene, facts, natural, drivers), *drivers)
    for push in pushes:
        if push.name not in symbols:
            symbols[push.name] = symbols[push.like] if push.like else scene.ledger.fresh(*named(push))
    laws = tuple(law for f in facts for law in f.laws)
    first = Motion(tree, scene.center, scene.arms.between, {})
    return System(
        scene,
        modes,
        statements,
        builder,
        tree,
        pushes,
        laws,
        symbols,
        first,
        aliases,
        titles=builder.titles,
    )
