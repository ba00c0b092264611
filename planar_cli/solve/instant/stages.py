"""Stages of a worked solution: which unknowns there are, what is zero at sight, the plan, and the plan carried out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from decimal import Decimal
from functools import partial

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form, mentions
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import undecided_at
from planar_cli.principles.base import Family
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import changing, record
from planar_cli.solve.instant.adjoint import adjoint_candidates, power_candidates, sum_masks
from planar_cli.solve.instant.algebra import Algebra, SolvedBlock
from planar_cli.solve.instant.at_sight import Offered, offered
from planar_cli.solve.instant.by_axes import bodies_by_axes
from planar_cli.solve.instant.numbers import Numbers
from planar_cli.solve.instant.offers import Offers
from planar_cli.solve.instant.partners import with_partners
from planar_cli.solve.instant.plainer import Kinds, with_plainer_equations
from planar_cli.solve.instant.plan import Plan, Planner
from planar_cli.solve.instant.symmetric_pulls import with_symmetric_pulls
from planar_cli.solve.instant.through_given import through_given
from planar_cli.solve.instant.unplanned import unplanned
from planar_cli.solve.instant.write import Writer
from planar_cli.solve.instant.written import Explicit, each_once
from planar_cli.solve.multibody.linear import rank, scaled

MOST = 3
"""So many equations of one body or group can tell different things."""


@record
class Stage:
    """One stage, solved: the plan, its blocks, the explicit lines, the constructed centres.

    `zero`: unknowns that vanish at sight (nothing acts on them). `undetermined`: targets that nothing fixes.
    """

    level: str
    plan: Plan
    blocks: tuple[SolvedBlock, ...]
    lines: tuple[Explicit, ...]
    centres: dict[str, tuple[Vec, tuple[sp.Symbol, ...]]]
    zero: tuple[sp.Symbol, ...]
    undetermined: tuple[sp.Symbol, ...]
    algebra: Algebra
    accelerations: dict[str, list[tuple[Vec, sp.Expr]]]


@changing
class StageMaker:
    """Makes a stage of one system. `value`: numbers of everything that is known before it. `letters`: velocities that
    stay letters, as in a position that is left general. `constructed`: may moment centres be intersections of lines?
    `whole`: inertia of every body in an equation is put on paper, also where its moment needs no centre of mass.
    `families`: what a principle offers of accelerations and forces. `places`: where states are, in a general position.
    """

    system: System
    value: Valuation
    symbolic: bool
    next_number: int = 1
    letters: frozenset[sp.Symbol] = frozenset()
    constructed: bool = True
    whole: bool = False
    families: tuple[Family, ...] = ()
    places: Callable[[], Sequence[Valuation]] = tuple

    def velocities(self, targets: set[sp.Symbol], known: dict[sp.Symbol, Decimal]) -> Stage:
        """The velocities that are needed; `known`: those that are zero."""
        rates = self.system.scene.evaluator.speeds
        unknowns = [
            s
            for s in (*self.system.tree.velocity_unknowns(), *rates, *self._sought_speeds())
            if s not in known and s not in self.letters
        ]
        conditions = self.system.velocity_conditions()
        zero = dict.fromkeys(known, sp.S.Zero)
        conditions = [with_zeros(c, zero) for c in conditions]
        _demand_linear(conditions, frozenset(unknowns))
        return self._make("velocity", unknowns, conditions, targets, ())

    def _sought_speeds(self) -> list[sp.Symbol]:
        return [s for s in self.system.scene.ledger.sought if s not in self.value.values]

    def accelerations(self, targets: set[sp.Symbol]) -> Stage:
        """Accelerations and pushes."""
        unknowns, conditions = acceleration_unknowns(self.system), self.system.acceleration_conditions()
        return self._make("acceleration", unknowns, conditions, targets, self.families)

    def _make(
        self,
        level: str,
        unknowns: list[sp.Symbol],
        conditions: list[Condition],
        targets: set[sp.Symbol],
        families: tuple[Family, ...],
    ) -> Stage:
        found = self._offers(unknowns, conditions, targets, families)
        offers, candidates, columns = found.offers, found.candidates, found.columns
        index = {x: j for j, x in enumerate(columns.unknowns)}
        wanted = sum(1 << index[t] for t in targets if t in index)
        most = rank([scaled(row) for row in offers.base_rows()], len(columns.unknowns))
        fixed = Planner(candidates).determined(most)
        missing = _left_out(fixed, targets, index)
        if missing and offers.families:
            # One equation in the same unknowns is offered, the nicest; these need more of them.
            offers.most = MOST
            candidates = offers.all()
            fixed = Planner(candidates).determined(most)
            missing = _left_out(fixed, targets, index)
        planner = Planner(candidates)
        wanted &= ~sum(1 << index[t] for t in missing)
        planner.fixed = fixed
        if offers.families and self.constructed:
            wanted_columns = sorted(index[t] for t in targets if t in index and t not in missing)
            extra, seed = adjoint_candidates(offers, wanted_columns)
            candidates += extra
            planner = Planner(candidates, 0, (seed, self._motion_bits(index)), fixed)
        elif offers.singles:
            inside = sum_masks(c.mask for c in candidates)
            planner = Planner(candidates, 0, (inside, self._motion_bits(index)), fixed)
        planner.turning, planner.motion = self._turning(), self._motion_bits(index)
        plan = planner.plan(wanted)
        if plan is None and offers.families and self.constructed:
            candidates += power_candidates(offers, wanted_columns)
            plan = Planner(candidates, 0, (), fixed).plan(wanted)
        if plan is None:
            raise unplanned(self.system, (t for t in targets if t in index))
        first = tuple(nil.told(self.system, self.next_number + i) for i, nil in enumerate(found.first))
        plan = self._in_plain_form(with_partners(plan, candidates, columns.unknowns, self.system), offers, index)
        writer = Writer(self.system, columns, self.next_number + len(first), by_axes=bodies_by_axes(plan))
        numbered = through_given([tuple(map(writer.write, b.equations)) for b in plan.blocks], columns.unknowns)
        for body in dict.fromkeys(b for ws in numbered for w in ws for b in w.bodies) if self.whole else ():
            writer.acceleration(body)
        algebra = self._algebra(writer, columns)
        blocks = tuple(algebra.solve(b, w, columns.unknowns) for b, w in zip(plan.blocks, numbered, strict=True))
        self.next_number = writer.next_number
        return Stage(
            level,
            plan,
            (*first, *blocks),
            each_once(writer.lines),
            dict(writer.centres),
            found.zero,
            tuple(missing),
            algebra,
            writer.named,
        )

    def _algebra(self, writer: Writer, columns: Numbers) -> Algebra:
        """What solves the equations that were written."""
        explicit = {line.symbol: line.expression for line in writer.lines}
        fresh = partial(self.system.scene.ledger.fresh, unit="1")
        return Algebra(self.value, explicit, self.symbolic, frozenset(columns.unknowns), fresh, self.places)

    def _turning(self) -> frozenset[str]:
        """Bodies that turn and have mass."""
        edges, bodies = self.system.tree.edges, self.system.scene.bodies
        return frozenset(e.body for e in edges if e.spin is not None and bodies[e.body].mass != 0)

    def _motion_bits(self, index: dict[sp.Symbol, int]) -> int:
        """All accelerations: the equations without any reaction often determine them on their own."""
        return sum(1 << index[s] for s in self.system.tree.acceleration_unknowns() if s in index)

    def _in_plain_form(self, plan: Plan, offers: Offers, index: dict[sp.Symbol, int]) -> Plan:
        """The plan with equations of one body in which as many unknowns stand, as a teacher would write them."""
        plan = with_symmetric_pulls(plan, offers.along_axes)
        if not offers.families:
            return plan
        return with_plainer_equations(plan, self.system, offers.about, offers.along_axes, self._kinds(index))

    def _kinds(self, index: dict[sp.Symbol, int]) -> Kinds:
        """The unknowns by what they are."""
        along = {s for e in self.system.tree.edges for s in (e.slide_rate, e.rise_rate)}
        rubbing = {self.system.symbols[p.name] for p in self.system.pushes if p.kind == "friction" and p.unit == "N"}
        moving, friction = (sum(1 << j for s, j in index.items() if s in found) for found in (along, rubbing))
        return Kinds(self._motion_bits(index), moving, friction)

    def _offers(
        self,
        unknowns: list[sp.Symbol],
        conditions: list[Condition],
        targets: set[sp.Symbol],
        families: tuple[Family, ...],
    ) -> Offered:
        """All candidates; what an equation of its own says is zero leaves first."""

        def make(columns: Numbers) -> Offers:
            offers = Offers(self.system, columns, conditions, families)
            offers.constructed = self.constructed
            return offers

        found = offered(make, Numbers(tuple(unknowns), frozenset(unknowns), self.value), targets)
        self.value = found.columns.value
        return found


def _left_out(fixed: int, targets: set[sp.Symbol], index: dict[sp.Symbol, int]) -> list[sp.Symbol]:
    """The targets that are not among the unknowns that are fixed, given as bits."""
    return sorted((t for t in targets if t in index and not fixed & (1 << index[t])), key=index.__getitem__)


def _demand_linear(conditions: Iterable[Condition], unknowns: frozenset[sp.Symbol]) -> None:
    """Undecided: a statement holds squares of velocities, of which no plan solves more than one direction."""
    for condition in conditions:
        try:
            for row in condition.rows():
                linear_form(row, unknowns)
        except Nonlinear:
            text = (
                f"`{condition.text}` is not linear in the velocities, and two directions satisfy it in a general "
                "position; a component says which: `v(P).along(Q/P) = u` for a size and the direction from P to Q"
            )
            raise undecided_at(condition.mark, text) from None


def with_zeros(condition: Condition, known: dict[sp.Symbol, sp.Expr]) -> Condition:
    """A condition with known zeros put in."""
    if not known:
        return condition
    residual = condition.residual
    if isinstance(residual, Vec):
        return replace(condition, residual=Vec(residual.x.xreplace(known), residual.y.xreplace(known)))
    return replace(condition, residual=sp.sympify(residual).xreplace(known))


def acceleration_unknowns(system: System) -> list[sp.Symbol]:
    """Accelerations along the tree, second rates of coordinates, pushes that follow no law, sought loads."""
    ledger = system.scene.ledger
    followers = {law.push for law in system.laws}
    seconds = system.scene.evaluator.second_rates
    pushes = [system.symbols[p.name] for p in system.pushes if p.name not in followers and not p.like]
    found = [*system.tree.acceleration_unknowns(), *seconds, *pushes]
    return [*found, *(s for s in ledger.sought if s not in found)]


def needed(exprs: list[sp.Expr], symbols: set[sp.Symbol]) -> set[sp.Symbol]:
    """Which of the symbols occur."""
    return {s for e in exprs if mentions(e, symbols) for s in e.free_symbols if s in symbols}
