"""The unknowns of all levels, in one choice of modes, as one system: the branches of its plan, and their tests.

Every unknown (a sought constant, a velocity that nothing fixes yet, accelerations, reactions) gets a generic number; an
equation contains an unknown when its residual moves with it. Blocks that are nonlinear are reduced to one equation in
one unknown, whose real roots are all followed. Each branch is tested: the assumptions of the modes, the inequalities of
the file, signs that a mass or a coefficient must have.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.kinematics.moving import all_wrenches
from planar_cli.equation.system.conditions import POSITION, Condition, stated
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.sample import anywhere, fraction, generator
from planar_cli.problem.implied.not_negative import not_negative
from planar_cli.records import changing
from planar_cli.solve.diagnosis.words import listed
from planar_cli.solve.instant.algebra import Algebra
from planar_cli.solve.instant.at_sight import Offered, offered
from planar_cli.solve.instant.branches import Branch, Brancher
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.limit_conditions import least_sizes, limit_of, only_just_apart, stated_limits, tipping
from planar_cli.solve.instant.numbers import Numbers
from planar_cli.solve.instant.offers import Offers
from planar_cli.solve.instant.one_way import along_paths
from planar_cli.solve.instant.parting import parting
from planar_cli.solve.instant.plan import Block, Plan, Planner
from planar_cli.solve.instant.stages import MOST, acceleration_unknowns, with_zeros
from planar_cli.solve.instant.study import solve_velocities, with_pushes
from planar_cli.solve.instant.verify import AGREE, residuals
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.instant.write import Writer
from planar_cli.solve.instant.written import Written
from planar_cli.units import MASS, PURE

MOST_LEFT_OUT = 4
"""So many plans are made, each without what came out as a repetition in the one before."""
LOOSE = "is open"
"""How the objection reads that a constant is not determined on which an assumption rests."""


@changing
class Sought:
    """One branch with its trial: the values of all unknowns, and why it is rejected ("" when it holds).

    `limits`: what is added to the equations of its `seeker`, as what is sought is extreme there.
    """

    branch: Branch
    plan: Plan
    writer: Writer
    trial: Trial
    unknowns: tuple[sp.Symbol, ...]
    objection: str
    objective: Decimal | None = None
    others: list[Sought] = field(default_factory=list)
    offer: Offered | None = None
    limits: tuple[Condition, ...] = ()
    seeker: Seeker | None = None


class Seeker:
    """Solves one choice of modes with unknowns of every level. `way`: the sign of speeds that are open, where the
    direction of a load rests on it; a branch in which they go the other way contradicts its own equations.
    """

    def __init__(self, instant: Instant, choice: tuple[int, ...], way: int = 1) -> None:
        self.instant, self.choice = instant, choice
        self.scene = instant.scene
        self.ledger = self.scene.ledger
        self.system: System = instant.system(choice)
        base = self.scene.valuations[0]
        second = self.scene.valuations[-1]
        found = [solve_velocities(self.system, v, instant.at_rest, seek=False) for v in (base, second)]
        tried = [solve_velocities(self.system, v, instant.at_rest).conflict for v in (base, second)]
        self.conflict = any(c is not None and not self._settles(c[0]) for c in tried)
        still = [s for s in found[0].values if all(not v.values.get(s, Decimal(1)) for v in found)]
        self.still = dict.fromkeys(still, sp.S.Zero)
        self.system.settle(self.still, ())
        settled = {**{s: Decimal(0) for s in still}, **found[0].values}
        speeds = [s for s in self._speeds() if s not in settled]
        numbers = base.extended({**{s: way * anywhere(i) for i, s in enumerate(speeds)}, **settled})
        assert self.system.motion is not None
        skids, idle = self.system.skids(), self.system.idle()
        wrenches = all_wrenches(self.scene, self.system.motion, numbers, skids, idle)
        self.system.settle(self.still, wrenches)
        inside = {x for w in wrenches if w.force is not None for e in (w.force.x, w.force.y) for x in e.free_symbols}
        self.has_ways = not inside.isdisjoint(speeds)
        self.unknowns = self._unknowns(still)
        self.conditions = self._conditions()
        self.linear = self._linear()
        self.value = self._generic(base)

    def _settles(self, blamed: list[tuple[Condition, Decimal]]) -> bool:
        """Is what is sought part of a velocity that is stated, and may be the number that lets it fit the others?"""
        unknowns = set(self.system.tree.velocity_unknowns())
        rows = [e for c, _ in blamed if c.kind == "given" for e in c.rows()]
        known = [linear_form(e, unknowns).constant for e in rows]
        return any(self.scene.rests_on_sought(e) for e in known)

    def _speeds(self) -> list[sp.Symbol]:
        rates = self.scene.evaluator.speeds
        return [*self.system.tree.velocity_unknowns(), *rates]

    def _unknowns(self, still: list[sp.Symbol]) -> tuple[sp.Symbol, ...]:
        moving = [s for s in self._speeds() if s not in still]
        return tuple(dict.fromkeys([*moving, *acceleration_unknowns(self.system)]))

    def _conditions(self) -> list[Condition]:
        quantities = self.system.quantities()
        names = {s.name for s in self.ledger.coordinates}
        places = stated(list(self.instant.statements.relations), quantities, quantities.evaluator, names, POSITION)
        velocities = [with_zeros(c, self.still) for c in self.system.velocity_conditions()]
        accelerations = self.system.acceleration_conditions()
        if set(self.ledger.coordinates) & set(self.ledger.sought):
            velocities, accelerations = along_paths(velocities, accelerations, frozenset(self._speeds()))
        return [*places, *velocities, *accelerations]

    def _linear(self) -> frozenset[sp.Symbol]:
        """The unknowns in which every equation is linear, whatever the others are."""
        exprs = [e for c in self.conditions for e in c.rows()]
        exprs += [e for c in self.limit_conditions() for e in c.rows()]
        exprs += [e for b in self.scene.bodies for e in body_residuals(self.system, b)]
        sure = set(acceleration_unknowns(self.system)) - set(self.ledger.sought)
        hidden = self._hidden()
        for e in exprs:
            sure -= {s for s in e.free_symbols & sure if not self._enters_linearly(s, [e], set())}
        for s in self.ledger.sought:
            if s not in hidden and self._enters_linearly(s, exprs, sure):
                sure.add(s)
        return frozenset(sure)

    def _hidden(self) -> set[sp.Symbol]:
        """Symbols on which geometry or named intermediates depend."""
        exprs = [e for p in self.scene.points.values() for e in (p.x, p.y)]
        exprs += list(self.ledger.definitions.values()) + list(self.ledger.values.values())
        return set().union(*(sp.sympify(e).free_symbols for e in exprs)) if exprs else set()

    @staticmethod
    def _enters_linearly(s: sp.Symbol, exprs: list[sp.Expr], others: set[sp.Symbol]) -> bool:
        for e in exprs:
            if s in e.free_symbols:
                try:
                    linear_form(e, others | {s})
                except Nonlinear:
                    return False
        return True

    def _generic(self, base: Valuation) -> Valuation:
        rng = generator(5)
        numbers = {}
        for s in self.unknowns:
            if s not in self.ledger.sought:
                numbers[s] = fraction(rng) + Decimal("0.3")
        return base.extended({**numbers, **{s: Decimal(0) for s in self.still}})

    # --- plan and branches -------------------------------------------------------------------------------------------

    def candidates(self, limits: tuple[Condition, ...], targets: set[sp.Symbol], most: int = 1) -> Offered:
        """All candidates, `most` in the same unknowns of one group; what vanishes at sight leaves first."""
        kinetics = any(b.mass != 0 for b in self.scene.bodies.values()) or bool(self.system.wrenches)
        families = (
            self.instant.families(self.instant.principle, self.system, self.value, self.choice) if kinetics else ()
        )

        def make(columns: Numbers) -> Offers:
            offers = Offers(self.system, columns, [*self.conditions, *limits], families)
            offers.most = most
            return offers

        return offered(make, Numbers(self.unknowns, self.linear, self.value), targets)

    def branches(self, targets: set[sp.Symbol], limits: tuple[Condition, ...]) -> Iterator[Sought]:
        """All branches of the plan for these targets; nothing when they are not determined.

        Away from a solution an equation may look like one of its own that follows from the others wherever they hold
        (forces along a direction that turns with a position that is sought): when that comes out, the plan is made
        without it.
        """
        left_out: tuple[Candidate, ...] = ()
        for _ in range(MOST_LEFT_OUT):
            plan, offer = self._plan(limits, targets, 1, left_out)
            if plan is None:
                plan, offer = self._plan(limits, targets, MOST, left_out)
            if plan is None:
                return
            numbers = offer.columns
            writer = Writer(self.system, numbers)
            work = [(b, tuple(writer.write(e) for e in b.equations)) for b in plan.blocks]
            brancher = Brancher(numbers.unknowns, self._angles(numbers), self.ledger.symbolic, self.ledger.natural)
            followed = self._followed(brancher, work, plan, writer, numbers)
            found = [replace(s, offer=offer, limits=limits, seeker=self) for s in followed]
            yield from found
            told = [(w.number, e) for b, written in work for w, e in zip(written, b.equations, strict=True)]
            repeated = tuple(e for number, e in told if number in brancher.repeated)
            if found or not repeated:
                return
            left_out += repeated

    def _angles(self, numbers: Numbers) -> frozenset[sp.Symbol]:
        units = self.ledger.units
        return frozenset(s for s in numbers.unknowns if units[s].angle and units[s].dimension == PURE)

    def _followed(
        self,
        brancher: Brancher,
        work: list[tuple[Block, tuple[Written, ...]]],
        plan: Plan,
        writer: Writer,
        numbers: Numbers,
    ) -> Iterator[Sought]:
        explicit = {line.symbol: line.expression for line in writer.lines}
        unknowns = frozenset(numbers.unknowns)
        algebra = Algebra(numbers.value.without(unknowns), explicit, self.ledger.symbolic, unknowns)
        places = [s for s in self.ledger.coordinates if s in self.ledger.sought]
        for branch in brancher.run(algebra, work):
            # Where the position is not told, nothing can be tested; what divides by zero on the way tells nothing.
            solved = branch.algebra.value.values
            if all(s in solved for s in places) and all(v.is_finite() for v in solved.values()):
                yield self._judge(branch, plan, writer, numbers.unknowns)

    def _plan(
        self, limits: tuple[Condition, ...], targets: set[sp.Symbol], most: int, left_out: tuple[Candidate, ...] = ()
    ) -> tuple[Plan | None, Offered]:
        offer = self.candidates(limits, targets, most)
        numbers = offer.columns
        candidates = [c for c in offer.candidates if not any(_same(c, other) for other in left_out)]
        index = {x: j for j, x in enumerate(numbers.unknowns)}
        wanted = sum(1 << index[t] for t in targets if t in index)
        nonlinear = sum(1 << j for x, j in index.items() if x not in self.linear)
        return Planner(candidates, nonlinear).plan(wanted), offer

    # --- tests -------------------------------------------------------------------------------------------------------

    def _judge(self, branch: Branch, plan: Plan, writer: Writer, unknowns: tuple[sp.Symbol, ...]) -> Sought:
        """Solve the instant again with the constants known, and test everything."""
        solved = branch.algebra.value.values
        constants = {s: solved[s] for s in self.ledger.sought if s in solved}
        base = self.scene.valuations[0].knowing(constants)
        trial = self.instant.try_choice(
            self.choice, (base,), given={s: v for s, v in solved.items() if s in self.unknowns}
        )
        trial = replace(trial, outcomes=tuple(with_pushes(trial.system, o, solved) for o in trial.outcomes))
        objection = self._wrong_sign(constants) or trial.objection
        objection = objection or self._behind(base, constants)
        objection = objection or loose_limit(self.instant, trial, constants) or self._singular(constants)
        objection = objection or _unfulfilled(trial, solved)
        return Sought(branch, plan, writer, trial, unknowns, objection)

    def _singular(self, constants: dict[sp.Symbol, Decimal]) -> str:
        """Is it an isolated position in which the joints let something move that they hold everywhere near by?

        A limit that is sought bounds positions that stay; such a position is no bound.
        """
        if not self.instant.statements.extremes:
            return ""
        base = self.scene.valuations[0]
        near, here = (self._mobility(v) for v in (base, base.extended(constants)))
        return "the joints do not hold it in this position" if here > near else ""

    def _mobility(self, value: Valuation) -> int:
        """How many velocities the joints leave open in a position."""
        return len(solve_velocities(self.system, value, False, seek=False).free)

    def _wrong_sign(self, constants: dict[sp.Symbol, Decimal]) -> str:
        named = not_negative(self.scene.problem)
        for s, v in constants.items():
            unit = self.ledger.units[s]
            if v < 0 and (s.name in named or unit.dimension == MASS or self._is_friction(s) or self._is_size(s)):
                return f"{s.name} can not be negative"
        return ""

    def _is_friction(self, s: sp.Symbol) -> bool:
        """Does the constant stand in a law or limit of friction?"""
        factors = [law.factor for _, found in self.instant.modes for mode in found for law in mode.facts.laws]
        factors += [f for _, found in self.instant.modes for mode in found for t in mode.tests for _, f in t.pushes]
        return any(s in sp.sympify(f).free_symbols for f in factors)

    def _is_size(self, s: sp.Symbol) -> bool:
        """Does the constant stand for a radius of gyration or a radius?"""
        exprs = [b.inertia for b in self.scene.bodies.values()]
        return any(s in sp.sympify(self.ledger.definitions.get(e, e)).free_symbols for e in exprs)

    def _behind(self, base: Valuation, constants: dict[sp.Symbol, Decimal]) -> str:
        """A contact whose body would lie on the other side of what it touches; so it was not drawn."""
        if not set(self.ledger.coordinates) & set(constants):
            return ""
        with self.scene.supposing(base):
            there = {joint.name: self.instant.modes_of(joint) for joint in self.instant.joints if joint.unilateral}
        for joint, drawn in self.instant.modes:
            if joint.name in there and any(
                a.facts.pushes != b.facts.pushes for a, b in zip(drawn, there[joint.name], strict=True)
            ):
                return f"what touches at {joint.name} would lie on the other side"
        return ""

    # --- extremes ----------------------------------------------------------------------------------------------------

    def compared(self) -> set[sp.Symbol]:
        """Unknowns that the inequalities of the file need."""
        evaluator = self.system.quantities().evaluator
        sides = [s for r in self.instant.statements.inequalities for s in (r.left, r.right)]
        return {x for s in sides for x in evaluator.value(s).free_symbols if x in self.unknowns}

    def limit_conditions(self) -> list[Condition]:
        """Every assumption, and every inequality of the file, that could be at its limit, as an equation."""
        assert self.system.reactions is not None
        values = {p.name: e for p, e in self.system.reactions.pushes}
        tests = [test for mode in self.system.modes.values() for test in mode.tests]
        open_ = [test for test in tests if (test.pushes or test.within) and not test.strict]
        found = [tipping(limit_of(test, values), test, self.system) for test in open_]
        found += self.departures()
        evaluator = self.system.quantities().evaluator
        found += stated_limits(self.instant.statements, lambda side: sp.sympify(evaluator.value(side)))
        return [*found, *least_sizes(self.instant.statements.extremes, self.scene.problem, self.ledger.sought)]

    def departures(self) -> list[Condition]:
        """What the file lets lift off, where it only just does so."""
        apart = {joint for joint, mode in self.instant.statements.modes if mode == "apart"}
        if not apart or not self.instant.statements.extremes or self.system.motion is None:
            return []
        tests = [test for name, mode in self.system.modes.items() if name in apart for test in mode.tests]
        leaving = [(t, parting(self.system.motion, t)) for t in tests if not t.strict]
        return [only_just_apart(t, expr) for t, expr in leaving if expr is not None and expr.free_symbols]

    def told_limits(self, targets: set[sp.Symbol]) -> list[Condition]:
        """Those of forces that the equations at hand speak of: from others, such as ideal reactions in Lagrange's
        equations, nothing follows.
        """
        found = self.candidates((), targets)
        unknowns = found.columns.unknowns
        told = {x for j, x in enumerate(unknowns) if any(c.mask >> j & 1 for c in found.candidates)}
        forces = set(unknowns) - set(self.ledger.sought)
        return [c for c in self.limit_conditions() if all(e.free_symbols & forces <= told for e in c.rows())]


def seekers(instant: Instant, choice: tuple[int, ...]) -> Iterator[Seeker]:
    """For either sign of open speeds, where the direction of a load rests on it."""
    yield (first := Seeker(instant, choice))
    if first.has_ways and not first.conflict:
        yield Seeker(instant, choice, -1)


def _unfulfilled(trial: Trial, solved: dict[sp.Symbol, Decimal]) -> str:
    """Equations that the plan left out as idle, such as those of a body that only a driving force keeps going, and that
    the branch does not fulfil.
    """
    if not trial.outcomes:
        return ""
    outcome = trial.outcomes[0]
    numbers = outcome.value.extended({**unknowns_of(trial.system, outcome), **solved})
    return "contradiction" if residuals(trial.system, numbers, outcome)[1] > AGREE else ""


def _same(one: Candidate, other: Candidate) -> bool:
    """Candidates are made anew for each plan: of the same bodies, with the same numbers."""
    return (one.bodies, one.row) == (other.bodies, other.row)


def loose_limit(instant: Instant, trial: Trial, known: Iterable[sp.Symbol]) -> str:
    """A constant that stayed open and on which an assumption rests that the file does not state; "" for none."""
    loose = set(instant.scene.ledger.sought) - set(known)
    if not loose or not trial.outcomes:
        return ""
    stated = {joint for joint, _ in instant.statements.modes}
    outcome = trial.outcomes[0]
    for joint, mode in trial.system.modes.items():
        if instant.aliases[joint] in stated:
            continue
        for test in mode.tests:
            hanging = {s for _, f in test.pushes for s in sp.sympify(f).free_symbols & loose}
            sure = [(n, f) for n, f in test.pushes if not sp.sympify(f).free_symbols & loose]
            rest = sum((outcome.value(f) * (outcome.push(n) or Decimal(0)) for n, f in sure), Decimal(0))
            if hanging and rest < Decimal("-1e-25"):
                names = listed(sorted(s.name for s in hanging))
                return f"{names} {LOOSE}: whether {mode.words} depends on it"
    return ""
