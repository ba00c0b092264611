"""A blow as an instant of its own: the same modes and plan of equations, with impulses and velocities after it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.components import Components, component
from planar_cli.equation.kinematics.motion import Edge, Tree, TreeBuilder, Twist
from planar_cli.equation.kinematics.struck import StruckScene
from planar_cli.equation.system.conditions import ACCELERATION, VELOCITY, order
from planar_cli.equation.system.headings import headings
from planar_cli.equation.system.setup import Course as Position
from planar_cli.equation.system.setup import Setup
from planar_cli.equation.system.system import Statements, mode_of
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.jets import Jet
from planar_cli.equation.values.ledger import Kind, Role
from planar_cli.errors import refuse
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import AtRest, Binary, Grouped, Name, Quantity, Relation, Side, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import Joining, Mode, Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.impulse_letters import of_reaction
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.impulsive.oblique import oblique_strikes
from planar_cli.solve.instant.asked import FORCES
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.units import parse_unit

LIFTED = {"v": "a", "omega": "alpha", "dot": "ddot"}
LOWERED = {lifted: word for word, lifted in LIFTED.items()}
BEFORE = "before"
"""Where a velocity is told that is not changed by the blow."""
OF_IMPULSE = {"N": "N*s", "N*m": "N*m*s"}


class AfterTree(TreeBuilder):
    """Makes velocities just after a blow where accelerations would stand. `known`: those that have a letter already, by
    what the velocity is; `mark`: what is put behind the names of the others.
    """

    known: Mapping[str, sp.Symbol]
    mark: str

    def build(self, joinings: Iterable[Joining], hang: bool = True) -> Tree:
        """The tree; velocities of particles that strike something oblique count along the tangent and the normal."""
        tree = super().build(joinings, hang)
        return replace(tree, edges=tuple(self._resolved(e) for e in tree.edges)) if hang else tree

    def _resolved(self, edge: Edge) -> Edge:
        axis = self.oblique.get(edge.body)
        if axis is None or edge.joining is not None or edge.components is not None:
            return edge
        name = self.center_name(edge.body) or edge.body
        # The letters have their state, as those of the motion have; the mark of one of several blows is it already.
        state = next((s.name.partition("__")[2] for s in self.known.values()), "")
        ending, kinds = "" if self.mark or not state else f"__{state}", ("velocity", "acceleration")
        index = {way: way if len(self.bodies) == 1 else component(name, way) for way in ("t", "n")}
        (u_t, v_t), (u_n, v_n) = (
            self._pair(f"{i}{ending}", *(f"{kind} of {name} along {way}" for kind in kinds)) for way, i in index.items()
        )
        own = Components(axis, (u_t, u_n), (v_t, v_n))
        return replace(edge, slide=u_t, slide_rate=v_t, rise=u_n, rise_rate=v_n, components=own, upward=1, rightward=1)

    def _pair(
        self, index: str, speed: str, rate: str, *, turns: bool = False, bent: bool = False
    ) -> tuple[sp.Symbol, sp.Symbol]:
        stem, unit = ("omega", "rad/s") if turns else ("v", "m/s")
        name = f"{stem}_{index}" if index else stem
        before = self._symbol(f"rest_{name}", unit, speed, Kind.SPEED)
        words = f"{rate.replace('acceleration', 'velocity')} just after"
        found = self.known.get(speed)
        if found is None:
            return before, self._symbol(name + self.mark, unit, words, Kind.SPEED)
        self.titles[found] = words
        self.ledger.know(found, parse_unit(unit), Role(Kind.SPEED))
        return before, found


class StruckSetup(Setup):
    """Names and scene of a blow. `arriving`: the letters of the velocities before it, with their units; `rates`: what
    stands for the rates of the file's coordinates after it, by these rates; `mark`: ends the names of its own.
    """

    def __init__(
        self,
        problem: Problem,
        statements: Statements,
        earlier: Mapping[str, Any],
        position: Position,
        arriving: Mapping[sp.Symbol, str],
        rates: Mapping[sp.Symbol, sp.Symbol],
        mark: str,
    ) -> None:
        self._arriving, self._rates, self._mark = arriving, rates, mark
        super().__init__(problem, statements, earlier, True, position, StruckScene)

    def _open_course(self, course: Position) -> None:
        """Velocities after the blow stand for accelerations from here on, so also in formulas of places."""
        super()._open_course(course)
        ledger = self.ledger
        for symbol, unit in self._arriving.items():
            ledger.letters.append(symbol)
            ledger.adopt(symbol, parse_unit(unit), Role(Kind.STATE))
        for q in ledger.coordinates:
            rate, _ = self.motions[q]
            if isinstance(rate, sp.Symbol):
                role = Role(Kind.SPEED, q)
                after = self._rates.get(rate) or ledger.fresh(
                    f"{rate.name}{self._mark}", ledger.units[rate].text, role=role
                )
                self.motions[q] = (rate, after)
            else:
                self.motions[q] = (sp.S.Zero, rate)


class Struck(Instant):
    """The scene in a blow. `known`: letters of the velocities after it by what they are; `mark`: ends the names of its
    own.
    """

    def __init__(self, setup: Setup, known: Mapping[str, sp.Symbol], mark: str) -> None:
        self.known, self.mark = known, mark
        super().__init__(setup)

    def modes_of(self, joint: Joint) -> tuple[Mode, ...]:
        assert isinstance(self.scene, StruckScene)
        return joint.blows(self.scene)

    def try_choice(
        self, choice: tuple[int, ...], valuations: tuple[Valuation, ...], given: dict[sp.Symbol, Decimal] | None = None
    ) -> Trial:
        """In numbers; what `motion` drives gets the impulse that this takes."""
        found = super().try_choice(choice, valuations, given)
        if any(o.solved.conflict is not None for o in found.outcomes) and self.add_drivers():
            return super().try_choice(choice, valuations, given)
        return found

    def tree_builder(self, bodies: list[str]) -> TreeBuilder:
        heading = headings(self.scene, self.statements)
        made = AfterTree(self.scene.ledger, self.scene.rigid, self.scene.own_name, bodies, heading=heading)
        made.known, made.mark = self.known, self.mark
        made.clockwise = frozenset(self.scene.problem.turning)
        made.going = dict(self.scene.problem.going)
        made.oblique = oblique_strikes(self.scene)
        return made

    def name_of(self, push: Push) -> tuple[str, str]:
        return f"{of_reaction(push.name)}{self.mark}", OF_IMPULSE[push.unit]


def struck_instant(
    problem: Problem,
    always: tuple[Statement, ...],
    laws: tuple[Statement, ...],
    earlier: Mapping[str, Any],
    position: Position,
    before: Mapping[str, tuple[Vec, sp.Expr]],
    speed: Callable[[Side], Jet],
    arriving: Mapping[sp.Symbol, str],
    known: Mapping[str, sp.Symbol],
    rates: Mapping[sp.Symbol, sp.Symbol],
    mark: str,
) -> Struck:
    """The scene of one blow. `problem`: the joints that hold after it, and what strikes; `laws`: those of `always` that
    hold before it too; `before`: velocity of the mass centre and angular velocity with which each body arrives, in the
    letters `arriving` (with their units); `speed`: any velocity before it, in the same letters. `known`: letters of
    velocities after it by what they are; `rates`: those of the rates of the file's coordinates.
    """
    coordinates = {c.name for c in problem.coordinates}
    demanded = [d for s in always for d in _after(s, coordinates)]
    demanded += [d for s in laws for d in _unchanged(s)]
    level = replace(problem, plane="horizontal")
    statements = Statements.of(tuple(demanded), (AtRest(None, "", problem.bodies[0].mark),))
    setup = StruckSetup(level, statements, earlier, position, arriving, rates, mark)
    scene = setup.scene
    assert isinstance(scene, StruckScene)
    scene.before = {b: Twist(scene.center(b), v, spin) for b, (v, spin) in before.items()}
    scene.open_names = {}
    scene.evaluator = replace(scene.evaluator, at_state=lambda _: speed)
    return Struck(setup, known, mark)


def _after(statement: Statement, coordinates: set[str]) -> tuple[Statement, ...]:
    """What `motion` demands of the velocities after a blow, where accelerations stand for them."""
    if not isinstance(statement, Relation) or statement.operator != "=" or mode_of(statement) is not None:
        return ()
    level = order(statement, coordinates)
    if level == VELOCITY:
        return (_lifted(statement),)
    if level >= ACCELERATION:
        return ()
    if any(isinstance(n, Name) and n.name == "t" for n in walk(statement)):
        hint = "give its velocity: `omega(crank) = 2 rad/s`"
        raise refuse(statement.mark, "PL590", f"`{statement.text}` places something by the time, in a blow", hint)
    left, right = (Quantity("ddot", (), side, (), None, statement.mark) for side in (statement.left, statement.right))
    return (replace(statement, left=left, right=right),)


def _unchanged(statement: Statement) -> tuple[Relation, ...]:
    """What a law of accelerations demands: the velocities that it drives are those before the blow. It is linear in its
    accelerations, and so are both sides of it the same for velocities just after the blow and just before it.
    """
    if not isinstance(statement, Relation) or statement.operator != "=":
        return ()
    inside = [n for n in walk(statement) if isinstance(n, Quantity)]
    driven = [q for q in inside if q.word in LOWERED]
    bent = any(p.kind in ("mag", "angle", "t", "n") for q in driven for p in q.parts)
    if not driven or bent or any(q.word in FORCES for q in inside):
        return ()
    left, right = (Binary("-", s, _before(s), statement.mark) for s in (statement.left, statement.right))
    text = f"what {statement.text} drives keeps its velocity"
    return (replace(statement, left=left, right=right, text=text),)


def _before(tree: Any) -> Any:
    """The same formula with velocities before the blow instead of accelerations."""
    if isinstance(tree, Quantity) and tree.word in LOWERED:
        return Grouped(replace(tree, word=LOWERED[tree.word]), BEFORE, tree.mark)
    return _changed(tree, _before)


def _lifted(tree: Any) -> Any:
    """The same formula of accelerations instead of velocities."""
    found = _changed(tree, _lifted)
    if isinstance(found, Quantity) and found.word in LIFTED:
        return replace(found, word=LIFTED[found.word])
    return found


def _changed(tree: Any, change: Callable[[Any], Any]) -> Any:
    """The same formula with its parts changed."""
    if isinstance(tree, tuple):
        return tuple(change(t) for t in tree)
    if not is_dataclass(tree) or isinstance(tree, type):
        return tree
    return replace(tree, **{f.name: change(getattr(tree, f.name)) for f in fields(tree) if f.init})
