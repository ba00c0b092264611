"""The equations of a solution, taken from what it wrote: blocks of an instant, or the route through a motion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

import numpy as np
import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.ledger import Ledger
from planar_cli.equation.motion import Motion
from planar_cli.problem.facts import Mode, Row
from planar_cli.problem.facts import Test as Assumption
from planar_cli.replay.at_states import AtState, StateNumbers, at_state, constant_steps, renamed
from planar_cli.replay.equations import Asked, Equations, Step, Test
from planar_cli.replay.opened import NotWritten, of_block
from planar_cli.replay.two_places import squares_of_places
from planar_cli.solve.between.trace import MotionTrace, RegimeTrace, RouteStep
from planar_cli.solve.instant.instant import TINY
from planar_cli.solve.instant.parting import parting
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution

Told = TypeVar("Told")
FAILURES = (NotWritten, ArithmeticError, TypeError, np.linalg.LinAlgError)
"""What has no number, or not one."""
SAME = 1e-6
"""Relative: equations at a state give what was found there."""


def equations_of(part: PartSolution) -> Equations:
    """The equations of a part. NotWritten: its answers do not follow from them alone."""
    if part.followed is not None:
        raise NotWritten("the answers are read off a motion that is followed in numbers")
    if part.motion is not None:
        return _Motion(part, part.motion).equations()
    if not part.instants:
        raise NotWritten("no instant is worked out")
    return _Instants(part).equations()


def is_number(found: Found) -> bool:
    """Is it a number, or a vector of two?"""
    return found.kind in ("number", "vector") and not found.word


def is_mode(found: Found) -> bool:
    """Is it a mode, such as slip, which stays what it is while the tests hold?"""
    return bool(found.word) and found.kind != "truth"


class _Writer:
    """Gathers equations. `ledgers`, `values`: of all that is worked out."""

    def __init__(self, part: PartSolution) -> None:
        self.part = part
        self.inputs: dict[str, sp.Symbol] = {}
        self.defined: dict[sp.Symbol, sp.Expr] = {}
        self.steps: list[Step] = []
        self.asked: dict[str, Asked] = {}
        self.tests: list[Test] = []
        self.valuations: list[Valuation] = []
        self.ledgers: list[Ledger] = []
        self.numbers: dict[sp.Symbol, float] = {}
        """Of symbols that no valuation knows."""
        self.general: dict[sp.Symbol, sp.Symbol] = {}
        """By a symbol that was made for a state, that of the general position."""
        self.squares: dict[str, sp.Expr] = {}

    def know(self, ledger: Ledger, value: Valuation) -> None:
        """What a ledger knows: numbers are inputs, formulas definitions."""
        self.valuations.append(value)
        self.ledgers.append(ledger)
        for symbol, expr in ledger.values.items():
            if sp.sympify(expr).free_symbols:
                self.defined[symbol] = expr
            else:
                self.inputs[symbol.name] = symbol
        for symbol, expr in (*ledger.definitions.items(), *value.definitions.items()):
            if symbol not in ledger.values:
                self.defined.setdefault(symbol, sp.sympify(expr))

    def made(self) -> Equations:
        """All that was gathered, with those finds that follow from it. NotWritten: none does."""
        made = self.gathered()
        complete = {name: one for name, one in self.asked.items() if not self.loose(made, one)}
        if not complete:
            raise NotWritten("; ".join(self._told_loose(made)) or "no answer is a number of an instant or a state")
        return replace(made, asked=complete)

    def gathered(self) -> Equations:
        """All that was gathered. NotWritten: an unknown has no number."""
        numbers: dict[sp.Symbol, float] = {}
        for symbol in (*self.inputs.values(), *(u for step in self.steps for u in step.unknowns)):
            numbers[symbol] = self._number(symbol)
        gathered = Equations(
            self.part.case,
            self.inputs,
            self.defined,
            tuple(self.steps),
            self.asked,
            tuple(self.tests),
            numbers,
            self._also_made({s: role.kind for ledger in self.ledgers for s, role in ledger.roles.items()}),
            self._also_made({s: unit for ledger in self.ledgers for s, unit in ledger.units.items()}),
            self._also_made({s: title for ledger in self.ledgers for s, title in ledger.titles.items()}),
            self.squares,
        )
        return gathered.without_loose().in_order()

    def _also_made(self, known: dict[sp.Symbol, Told]) -> dict[sp.Symbol, Told]:
        """What is known of symbols, also of those that were made for a state."""
        return known | {own: known[general] for own, general in self.general.items() if general in known}

    def loose(self, made: Equations, asked: Asked) -> frozenset[sp.Symbol]:
        """That on which a find rests and which is known by its number alone."""
        return made.loose(asked.parts)

    def _told_loose(self, made: Equations) -> Iterable[str]:
        for name, one in self.asked.items():
            yield f"{name} rests on {', '.join(sorted(s.name for s in self.loose(made, one)))}, known by a number alone"

    def _number(self, symbol: sp.Symbol) -> float:
        number = self._known(symbol)
        if number is None:
            raise NotWritten(f"{symbol.name} has no number")
        return number

    def _known(self, symbol: sp.Symbol) -> float | None:
        """The number that a symbol has."""
        if symbol in self.numbers:
            return self.numbers[symbol]
        return next((float(n) for v in self.valuations if (n := v.known(symbol)) is not None), None)


class _Instants(_Writer):
    """Instants that are each complete in themselves."""

    def equations(self) -> Equations:
        for instant in self.part.instants:
            self._take(instant)
        for found in self.part.found:
            if not is_number(found):
                continue
            if found.asked:
                self.asked[found.name] = Asked(tuple(map(sp.sympify, found.asked)), found.turn)
        return self.made()

    def _take(self, solution: InstantSolution) -> None:
        ledger = solution.instant.scene.ledger
        if solution.instant.scene.problem.symbols:
            raise NotWritten("letters without numbers remain")
        self.know(ledger, solution.value)
        self.squares |= squares_of_places(solution.instant.scene)
        for letter in ledger.letters:
            # A mass that may be any: the answers are the same with the one that was drawn.
            self.inputs[letter.name] = letter
            self.valuations.append(solution.instant.scene.valuations[0])
        for line in solution.lines:
            self.defined[line.symbol] = line.expression
        for stage in solution.stages:
            self.defined.update({line.symbol: line.expression for line in stage.lines})
            self.defined.update(dict.fromkeys(stage.zero, sp.S.Zero))
            self.steps += [of_block(block, self.defined) for block in stage.blocks if block.equations]
        told = {u for step in self.steps for u in step.unknowns} | self.defined.keys() | set(self.inputs.values())
        for mode in solution.trial.system.modes.values():
            for test in mode.tests:
                expr = _assumed(solution, mode, test)
                if expr is not None and expr.free_symbols and expr.free_symbols <= told:
                    self.tests.append(Test(expr, test.words))


def _assumed(solution: InstantSolution, mode: Mode, test: Assumption) -> sp.Expr | None:
    """What a test demands to be positive; None: it is no sum of forces, and no slip or parting that is positive."""
    symbols = solution.trial.system.symbols
    if test.pushes and not test.within and all(n in symbols for n, _ in test.pushes):
        return sp.Add(*(c * symbols[n] for n, c in test.pushes), sp.sympify(test.constant))
    motion = solution.trial.system.motion
    if motion is None:
        return None
    expr = parting(motion, test) if test.row is None else _slip(solution, motion, mode, test.row)
    number = None if expr is None else solution.value.known(expr)
    return expr if number is not None and number > TINY else None


def _slip(solution: InstantSolution, motion: Motion, mode: Mode, row: Row) -> sp.Expr:
    """The slip in the sense that is assumed: its speed where it is under way, else how fast it begins."""
    speed = mode.direction * motion.row_velocity(row)
    under_way = (solution.value.known(speed) or 0) > TINY
    return speed if under_way else mode.direction * motion.row_acceleration(row)


class _Motion(_Writer):
    """A motion from state to state."""

    def __init__(self, part: PartSolution, motion: MotionTrace) -> None:
        super().__init__(part)
        self.motion = motion
        self.constant: list[Step] = []
        self.called: dict[sp.Expr, sp.Symbol] = {}
        """Formulas of what is constant on a stretch, with the unknown of its equations."""

    def equations(self) -> Equations:
        motion, route = self.motion, self.motion.route
        if motion.problem.symbols or motion.passing:
            raise NotWritten("letters without numbers remain")
        self.know(motion.ledger, motion.value)
        self.inputs.update({letter.name: letter for letter in motion.ledger.letters if letter in motion.value.values})
        for named in (route.plain, route.formulas, motion.named):
            for symbol, expr in named.items():
                self.defined.setdefault(symbol, sp.sympify(expr))
        # What an integral without a closed form gives is known by its number.
        self.steps = [made for step in route.steps if (made := _of_route(step)) is not None]
        for unknown in (u for step in route.steps for u in step.unknowns):
            self.defined.pop(unknown, None)
        for span in motion.spans:
            if span.formula is not None:
                self.defined[span.symbol] = span.formula
        self._take_constants()
        self._ask()
        return self.made()

    def _take_constants(self) -> None:
        """Forces and accelerations that are constant, by the equations of which formulas of them were made; on each
        stretch by its own, where they are others there.
        """
        sought = {u for step in self.motion.route.steps for u in step.unknowns}
        taken = set[sp.Symbol]()
        for k, regime in enumerate(self.motion.regimes):
            here = dict[sp.Symbol, sp.Symbol]()
            numbers = StateNumbers(self._known, self.defined)
            for general in constant_steps(regime.solution, self.motion, sought):
                own = {u: sp.Symbol(f"{u.name}__{k + 1}c", real=True) for u in general.unknowns if u in taken}
                step = renamed(general, {**here, **own})
                if sought.isdisjoint(step.unknowns) and self._gives_what_is_known(step, numbers):
                    here |= own
                    taken.update(general.unknowns)
                    self.constant.append(step)
                    self.general |= {n: u for u, n in own.items()}
                    self.numbers |= {u: numbers.found[u] for u in step.unknowns}
                    self._name_at_states(regime, {u: here.get(u, u) for u in general.unknowns})
        for unknown in (u for step in self.constant for u in step.unknowns):
            self.defined.pop(unknown, None)
        self.steps = [*self.constant, *self.steps]

    def _name_at_states(self, regime: RegimeTrace, constant: Mapping[sp.Symbol, sp.Symbol]) -> None:
        """What is constant on a stretch is so at its states, if it has that number there. `constant`: by the symbol of
        the general position.
        """
        states = {s for stretch in regime.stretches for s in stretch}
        for general, symbol in constant.items():
            for own, formula in list(self.defined.items()):
                name, _, state = own.name.rpartition("__")
                if name == general.name and state in states and formula not in constant.values():
                    due = self._known(own)
                    if due is not None and abs(self.numbers[symbol] - due) <= SAME * abs(due):
                        self.called[formula] = self.defined[own] = symbol

    def _gives_what_is_known(self, step: Step, numbers: StateNumbers) -> bool:
        """Does a constant step rest on data and other constants alone, and give the numbers of the solution?"""
        told = {*self.inputs.values(), *(u for s in self.constant for u in s.unknowns), *step.unknowns}
        waiting, seen = [r.free_symbols for r in step.residuals], set[sp.Symbol]()
        while waiting:
            for symbol in waiting.pop() - told - seen:
                seen.add(symbol)
                if symbol not in self.defined:
                    return False
                waiting.append(self.defined[symbol].free_symbols)
        known = {u: self._known(u) for u in step.unknowns}
        try:
            numbers.solve(step)
            pairs = [(numbers.of(u), due) for u, due in known.items() if due is not None]
        except FAILURES:
            return False
        return all(abs(number - due) <= SAME * abs(due) for number, due in pairs)

    def _ask(self) -> None:
        """The finds in the symbols of states; one that is a force or an acceleration there, by the equations there."""
        by_name = {f.name: f for f in self.part.found}
        for request in self.motion.requests:
            found = by_name.get(request.find.name)
            if found is None or not is_number(found):
                continue
            parts = tuple(self.called.get(e, e) for e in map(sp.sympify, request.parts))
            self.asked[found.name] = Asked(parts, found.turn)
            if self.loose(self.gathered(), self.asked[found.name]):
                self._ask_at_state(found)

    def _ask_at_state(self, found: Found) -> None:
        """By the equations of the general position at its state, where they give what was found."""
        constant = {u for step in self.constant for u in step.unknowns}
        for regime in self.motion.regimes:
            for state, finds in regime.asked.items():
                if found.name in finds:
                    at = at_state(regime.solution, self.motion, state, finds[found.name], constant)
                    if self._takes(at, found):
                        self.asked[found.name] = Asked(at.parts, found.turn)
                        return

    def _takes(self, at: AtState, found: Found) -> bool:
        """Are these equations taken? They are where they give what was found."""
        told = {*self.defined, *(u for step in self.steps for u in step.unknowns)}
        steps = [step for step in at.steps if told.isdisjoint(step.unknowns)]
        defined = {**at.defined, **self.defined}
        numbers = StateNumbers(self._known, defined)
        try:
            for step in steps:
                numbers.solve(step)
            values = [numbers.of(e) for e in at.parts]
        except FAILURES:
            return False
        due = [float(v) for v in found.values or ()]
        size = max(map(abs, due), default=0.0)
        if len(due) != len(values) or any(abs(v - d) > SAME * size for v, d in zip(values, due, strict=True)):
            return False
        self.steps += steps
        self.defined = defined
        self.numbers |= {u: numbers.found[u] for step in steps for u in step.unknowns}
        self.general |= at.general
        return True

    def loose(self, made: Equations, asked: Asked) -> frozenset[sp.Symbol]:
        """Also what following the motion in numbers alone has given."""
        return super().loose(made, asked) | (made.rests_on(asked.parts) & self.motion.guessed)


def _of_route(step: RouteStep) -> Step | None:
    residuals = tuple(sp.sympify(r.residual) for r in step.relations)
    if len(residuals) != len(step.unknowns) or any(r.has(sp.Integral, sp.Derivative) for r in residuals):
        return None
    others: dict[sp.Symbol, tuple[float, ...]] = {}
    for result in step.results:
        apart = [float(r.value) for r in result.roots]
        others[result.unknown] = tuple(v for v in apart if abs(v - float(result.value)) > 1e-9 * (abs(v) or 1))
    kinds = tuple(r.kind for r in step.relations)
    return Step(tuple(step.unknowns), residuals, kinds, ((),) * len(kinds), others)
