"""From the chosen modes to the finds: targets, stages, values, closed formulas."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from decimal import Decimal
from functools import partial
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import by_name, in_factors, letters, longer, replaced, rounded_inside
from planar_cli.equation.system.conditions import vector_or_jet
from planar_cli.equation.system.system import System, mode_of
from planar_cli.equation.system.tipping import tipping
from planar_cli.equation.values.exact import Sample, Valuation
from planar_cli.errors import Diagnostic, NoSolution, refuse
from planar_cli.problem.language.dimensions import Kind, dimension_of
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.language.outermost import is_energy
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.diagnosis.words import listed, names_of
from planar_cli.solve.instant.asked import asks_mode
from planar_cli.solve.instant.conditions import conditions, conditions_beside
from planar_cli.solve.instant.drawn_senses import as_one_letter
from planar_cli.solve.instant.stages import Stage, StageMaker, acceleration_unknowns, needed
from planar_cli.solve.instant.translating import translating
from planar_cli.solve.instant.truth import holds
from planar_cli.solve.instant.unreached import not_reached, unreached
from planar_cli.solve.instant.verify import Disagreement, verify
from planar_cli.solve.instant.written import each_once
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.units import Unit, parse_unit

if TYPE_CHECKING:
    from planar_cli.equation.kinematics.quantities import Quantities
    from planar_cli.equation.scene.displacement import Coordinate
    from planar_cli.problem.scene.scene import Find
    from planar_cli.solve.instant.instant import Instant, Trial
    from planar_cli.solve.instant.seeker import Sought

SAME = Decimal("1e-20")
"""Two branches whose constants differ by less, as a part of them, are one."""
CLOSED_OPS, MOST_OPS = 90, 600
"""A formula of more operations is not printed; one of more than the second number is left as it comes."""


class Finisher:
    """Works out one instant for its finds. `answer_units`: the units in which the file states its answers."""

    def __init__(
        self,
        instant: Instant,
        trial: Trial,
        rejected: tuple[Trial, ...],
        answer_units: Mapping[str, str],
        state: str = "",
    ) -> None:
        self.instant, self.trial, self.rejected, self.state = instant, trial, rejected, state
        self.system: System = trial.system
        self.scene = instant.scene
        self.ledger = self.scene.ledger
        self.answer_units = answer_units
        self.symbolic = self.ledger.symbolic
        self.letters: frozenset[sp.Symbol] = frozenset()
        self.coordinates: tuple[Coordinate, ...] = ()
        self.places: Callable[[], Sequence[Valuation]] = tuple
        self.principle = instant.principle
        self.most = MOST_OPS

    def solve(self, finds: tuple[Find, ...]) -> tuple[InstantSolution, list[Found]]:
        """The stages, and the answers of these finds."""
        quantities = self.system.quantities()
        sides = {f.name: self._expressions(f, quantities) for f in finds}
        exprs = [e for es in sides.values() for e in es]
        solution, stages, value = self.work(exprs, finds)
        self._demand_reached(unreached(stages, exprs), finds)
        solution.conditions = conditions(self.trial, self._formulas)
        return solution, [self._found(f, sides[f.name], value, stages, quantities) for f in finds]

    def _formulas(self, exprs: list[sp.Expr]) -> list[sp.Expr]:
        """Expressions of the unknowns in names of the file."""
        _, stages, _ = self.work(exprs, ())
        return [self.closed(e, stages) for e in exprs]

    def work(self, exprs: list[sp.Expr], finds: tuple[Find, ...]) -> tuple[InstantSolution, list[Stage], Valuation]:
        """The stages that expressions need, carried out and checked."""
        base = self.trial.outcomes[0].value
        unknowns = set(acceleration_unknowns(self.system))
        maker = StageMaker(self.system, base, self.symbolic, places=self.places)
        if self._has_forces():
            maker.families = self.instant.families(
                self.principle, self.system, base, self.trial.choice, self.coordinates
            )
        # Where the first assumption fails, that is the answer to which one holds.
        decides = (
            any(map(asks_mode, finds))
            and self._has_forces()
            and (not any(self.trial.choice) or bool(tipping(self.system)))
        )
        tested = decides or self._asks_forces(exprs)
        targets = needed(exprs, unknowns) | (self._test_targets(unknowns) if tested else set())
        targets |= tipping(self.system) if decides else set()
        self.demand_unique(needed(exprs, unknowns), finds)
        maker.value = self._drop(base, unknowns)
        acceleration = maker.accelerations(targets) if targets else None
        stages = self._with_velocities(maker, exprs, acceleration)
        value = self._values(stages)
        lines = tuple(line for s in stages for line in s.lines)
        solution = InstantSolution(self.state, self.instant, self.trial, self.rejected, tuple(stages), lines, value)
        solution.checks = verify(self.trial, value.values).report()
        return solution, stages, value

    def _demand_reached(self, missing: list[sp.Symbol], finds: tuple[Find, ...]) -> None:
        """FileProblem: the principle that was named has no equations that lead to these. NoSolution: none was named, so
        that no equation has them at all.
        """
        problem = self.scene.problem
        if missing and problem.method is None:
            pairs = self.scene.evaluator.motions.items()
            rates = {s: f"{word}({q})" for q, pair in pairs for word, s in zip(("dot", "ddot"), pair, strict=True)}
            names = [rates.get(s, s.name) for s in missing]
            declared = (*problem.unknowns, *problem.coordinates)
            mark = next(
                (u.mark for u in declared if u.name in (names[0], names[0].partition("(")[2][:-1])), finds[0].mark
            )
            stand = "they stand" if missing[1:] else "it stands"
            text = f"nothing tells {listed(names)}: {stand} in no equation"
            hint = f"let a load have it, such as `magnitude: {names[0]}`, a place, or a relation; else state it"
            if missing[0] in rates:
                hint = "let a body have its place there, tell it under `motion`, or state it"
            raise NoSolution([Diagnostic(mark, "PL606", text, hint)])
        if missing:
            raise not_reached(problem.method, [s.name for s in missing], finds[0].mark)

    def asked(self, finds: tuple[Find, ...]) -> list[sp.Expr]:
        """What the finds ask, in the unknowns of the system."""
        quantities = self.system.quantities()
        return [sp.sympify(e) for f in finds for e in self._expressions(f, quantities)]

    def solve_sought(self, sought: Sought, finds: tuple[Find, ...]) -> tuple[InstantSolution, list[Found]]:
        """As `solve`, where constants, angles, speeds or extremes were sought."""
        quantities = self.system.quantities()
        sides = {f.name: self._expressions(f, quantities) for f in finds}
        stage = self._stage_of(sought)
        value = self._values([stage])
        solution = InstantSolution(self.state, self.instant, self.trial, (), (stage,), stage.lines, value)
        solution.sought = sought
        solution.conditions = conditions_beside(sought, partial(self._formulas_beside, sought))
        if self.trial.outcomes:
            solution.checks = verify(self.trial, value.values).report()
        return solution, [self._found(f, sides[f.name], value, [stage], quantities) for f in finds]

    def _stage_of(self, sought: Sought) -> Stage:
        """A branch as the only stage."""
        branch, writer, offer = sought.branch, sought.writer, sought.offer
        nils = offer.first if offer is not None else ()
        if offer is not None:
            # Equations of what is sought are not linear, and hold what is zero as a letter.
            held = {s for b in branch.blocks for w in b.equations for s in w.residual.free_symbols}
            nils += tuple(n for n in offer.idle if n.symbol in held and n.candidate.condition is not None)
        return Stage(
            "acceleration",
            sought.plan,
            (*(nil.told(self.system, writer.next_number + i) for i, nil in enumerate(nils)), *branch.blocks),
            each_once(writer.lines),
            dict(writer.centres),
            offer.zero if offer is not None else (),
            (),
            branch.algebra,
            writer.named,
        )

    def _formulas_beside(self, sought: Sought, exprs: list[sp.Expr]) -> list[sp.Expr]:
        """Expressions of the unknowns in names of the file, by the plan of a branch that leads to them too; what none
        leads to stays as it is.
        """
        seeker, solved = sought.seeker, sought.branch.algebra.value.values
        if seeker is None:
            return exprs
        wanted = {s for e in exprs for s in e.free_symbols & set(seeker.unknowns)}
        constants = {s: solved[s] for s in self.ledger.sought if s in solved}
        for other in seeker.branches(wanted | constants.keys(), sought.limits):
            there = other.branch.algebra.value.values
            apart = max((abs(there[s] - v) / max(abs(v), Decimal(1)) for s, v in constants.items()), default=Decimal(0))
            if not other.objection and apart <= SAME:
                return [self.closed(e, [self._stage_of(other)]) for e in exprs]
        return exprs if len(exprs) == 1 else [f for e in exprs for f in self._formulas_beside(sought, [e])]

    def _drop(self, base: Valuation, unknowns: set[sp.Symbol]) -> Valuation:
        """The numbers of everything but the unknowns."""
        return base.without(unknowns)

    def _has_forces(self) -> bool:
        return any(b.mass != 0 for b in self.scene.bodies.values()) or bool(self.system.wrenches)

    def _asks_forces(self, exprs: list[sp.Expr]) -> bool:
        return (
            bool(self.system.pushes)
            and self._has_forces()
            and bool(needed(exprs, set(acceleration_unknowns(self.system))))
        )

    def _test_targets(self, unknowns: set[sp.Symbol]) -> set[sp.Symbol]:
        """Pushes that the tests of the assumed modes need."""
        found: set[sp.Symbol] = set()
        for mode in self.system.modes.values():
            for test in mode.tests:
                symbols = {self.system.symbols[n] for n, _ in test.pushes if n in self.system.symbols}
                found |= {s for s in symbols & unknowns if self._unique(s)}
        return found

    def _unique(self, symbol: sp.Symbol) -> bool:
        """Is a push determined at all?"""
        outcome = self.trial.outcomes[0]
        name = next((n for n, s in self.system.symbols.items() if s == symbol), None)
        if name is None or name not in outcome.assembly.columns:
            return True
        return outcome.solved.unique(outcome.assembly.columns[name])

    def demand_unique(self, targets: set[sp.Symbol], finds: tuple[Find, ...]) -> None:
        """NoSolution: some of these pushes are not determined."""
        loose = {s for s in targets if not self._unique(s)}
        if loose:
            mark = finds[0].mark
            text = f"not unique: {names_of(self.system, loose)}; the scene has more supports than equations"
            raise NoSolution([Diagnostic(mark, "PL603", text, "ask for what is unique, or leave a support out")])

    # --- velocities --------------------------------------------------------------------------------------------------

    def _with_velocities(self, maker: StageMaker, exprs: list[sp.Expr], acceleration: Stage | None) -> list[Stage]:
        """The velocity stage that the acceleration stage and the finds rest on comes first."""
        velocities = self.trial.velocities[0]
        moving = {s for s, v in velocities.values.items() if v} - self.letters
        used = list(exprs)
        if acceleration is not None:
            used += [w.residual for b in acceleration.blocks for w in b.equations] + [
                x.expression for x in acceleration.lines
            ]
        still = translating(self.trial, used) - self.letters if moving else set()
        targets = needed([*used, *self._named_in(used)], moving) | still
        stages: list[Stage] = []
        if targets:
            known = {s: v for s, v in velocities.values.items() if not v and s not in still}
            plain = maker.value.without(moving | still)
            maker_of_velocities = StageMaker(self.system, plain, self.symbolic, letters=self.letters)
            stages.append(maker_of_velocities.velocities(targets, known))
        if acceleration is not None:
            stages.append(acceleration)
        return stages

    def _named_in(self, exprs: list[sp.Expr]) -> list[sp.Expr]:
        """The named intermediates on which expressions rest, all the way down."""
        found: dict[sp.Symbol, sp.Expr] = {}
        left = list(exprs)
        while left:
            for s in by_name(left.pop().free_symbols):
                if s in self.ledger.definitions and s not in found:
                    found[s] = self.ledger.definitions[s]
                    left.append(found[s])
        return list(found.values())

    def _values(self, stages: list[Stage]) -> Valuation:
        outcome = self.trial.outcomes[0]
        columns = {s: outcome.assembly.columns.get(s.name) for s in self.ledger.sought}
        found = {s: outcome.solved.values[column] for s, column in columns.items() if column is not None}
        value = outcome.value.knowing(found)
        for stage in stages:
            value = value.updated(stage.algebra.value)
        return value

    # --- finds -------------------------------------------------------------------------------------------------------

    def _expressions(self, find: Find, quantities: Quantities) -> tuple[sp.Expr, ...]:
        """A find as one or two expressions; a relation as left and right."""
        what = find.found.what
        if isinstance(what, Relation):
            if mode_of(what) is not None:
                return ()
            sides = [vector_or_jet(s, quantities, quantities.evaluator) for s in (what.left, what.right)]
            return tuple(s.value for s in sides)
        if isinstance(what, Quantity) and what.word == "mode":
            return ()
        found = vector_or_jet(what, quantities, quantities.evaluator)
        parts = (found.x, found.y) if isinstance(found, Vec) else (found,)
        pushes = self.system.symbols.values()
        return tuple(as_one_letter(self._known(p.value, find), pushes) for p in parts)

    @staticmethod
    def _known(value: sp.Expr | None, find: Find) -> sp.Expr:
        if value is None:
            raise refuse(find.mark, "PL552", f"{find.name}: one instant does not tell this rate")
        return value

    def _mode_name(self, joint: str) -> str:
        ours = next(our for our, name in self.system.aliases.items() if name == joint and self.system.modes[our].name)
        return self.system.modes[ours].name

    def _found(
        self, find: Find, exprs: tuple[sp.Expr, ...], value: Valuation, stages: list[Stage], quantities: Quantities
    ) -> Found:
        what = find.found.what
        pure = parse_unit("1")
        if isinstance(what, Relation):
            mode = mode_of(what)
            if mode is not None:
                truth = self._mode_name(mode[0]) == mode[1]
            else:
                apart = (exprs[0] - exprs[1],)
                closed = (self.closed(apart[0], stages),) if isinstance(value, Sample) else apart
                truth = holds(find, what.operator, apart, closed, value, self.scene.everywhere())
            return Found(find.name, "truth", pure, None, None, "true" if truth else "false", find)
        if isinstance(what, Quantity) and what.word == "mode":
            return Found(find.name, "word", pure, None, None, self._mode_name(what.things[0]), find)
        unit = self.unit_of(find, what)
        closed = tuple(self.closed(e, stages) for e in exprs)
        symbolic = any(set(self.ledger.letters) & c.free_symbols for c in closed)
        if any(e.has(sp.nan, sp.zoo) for e in (*exprs, *closed)):
            hint = "ask for it where that is not zero: a point at rest has no path with a radius"
            text = f"{find.name} has no value here: what it divides by is zero"
            raise NoSolution([Diagnostic(find.mark, "PL637", text, hint)])
        values = None if symbolic else tuple(value.settled(e, c) for e, c in zip(exprs, closed, strict=True))
        if symbolic and any(_differ(value.known(e), value.known(c)) for e, c in zip(exprs, closed, strict=True)):
            raise Disagreement(f"{find.name}: its formula in letters is not the number that it was worked out from")
        short = all(not longer(c, CLOSED_OPS) and not rounded_inside(c) for c in closed)
        kind = "vector" if len(exprs) == 2 else "number"
        energy = is_energy(what)
        return Found(find.name, kind, unit, values, closed if symbolic or short else None, "", find, energy, exprs)

    def unit_of(self, find: Find, what: Side) -> Unit:
        """As asked, else as the file states the answer, else SI (US customary in such a file)."""
        if find.found.unit is not None:
            return parse_unit(find.found.unit)
        if find.name in self.answer_units:
            return parse_unit(self.answer_units[find.name])
        kind: Kind = dimension_of(what, self.instant.setup.lookup)
        return self.instant.setup.unit_asked(what, kind)

    def closed(
        self,
        expr: sp.Expr,
        stages: list[Stage],
        plainer: bool = True,
        kept: frozenset[sp.Symbol] = frozenset(),
    ) -> sp.Expr:
        """The formula of a find down to the names of the file. `plainer`: to be read, and not only for its numbers?
        `kept`: unknowns that stay as they are.
        """
        formulas: dict[sp.Symbol, sp.Expr] = {}
        for stage in stages:
            formulas.update(stage.algebra.explicit)
            formulas.update(stage.algebra.formulas)
        formulas.update({s: sp.S.Zero for s, v in self.trial.velocities[0].values.items() if not v})
        for stage in stages:
            formulas.update(dict.fromkeys(stage.zero, sp.S.Zero))
        for _ in range(80):
            inside = {s: formulas[s] for s in letters(expr) if s in formulas and s not in kept}
            inside |= {s: self.ledger.definitions[s] for s in letters(expr) if s in self.ledger.definitions}
            running = {s for f in expr.atoms(sp.Function) for s in f.free_symbols}
            inside |= {s: v for s in letters(expr) if (v := self._given_by_formula(s, running)) is not None}
            if not inside:
                break
            expr = replaced(expr, inside)
            # A long formula of one instant is not printed. Over a motion it must say all of it by its letters.
            if not self.coordinates and longer(expr, 4000 if self.symbolic else 4 * CLOSED_OPS):
                return expr
        return self._simple(expr) if plainer else expr

    def _given_by_formula(self, symbol: sp.Symbol, running: Collection[sp.Symbol]) -> sp.Expr | None:
        """The formula of a name that is given by one; None: it has none, or it has one number and stands in a function,
        in a motion. There it stays: sin(w t) in a place and cos(2 pi f t) in a velocity would be of two frequencies.
        `running`: what stands in functions.
        """
        value = self.ledger.values.get(symbol)
        if value is None or not value.free_symbols:
            return None
        return None if self.coordinates and symbol in running and self._is_number(symbol) else value

    def _is_number(self, symbol: sp.Symbol) -> bool:
        """Does the file give a number for it, or for all of which it is made?"""
        value = self.ledger.values.get(symbol)
        return value is not None and all(map(self._is_number, value.free_symbols))

    def _simple(self, expr: sp.Expr) -> sp.Expr:
        if expr.is_number or expr.is_Symbol or longer(expr, self.most):
            return expr
        if not self.symbolic:
            return expr if longer(expr, 199) else factor_terms(expr)
        return in_factors(expr)


def _differ(one: Decimal | None, other: Decimal | None) -> bool:
    """Are they two numbers, beyond the rounding of sixty digits?"""
    return one is not None and other is not None and abs(one - other) > SAME * max(abs(one), abs(other), SAME)
