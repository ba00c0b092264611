"""The equations of a solution, taken from what it wrote: blocks of an instant, or the route through a motion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.ledger import Ledger
from planar_cli.problem.facts import Test as Assumption
from planar_cli.replay.equations import Asked, Equations, Step, Test
from planar_cli.solve.between.trace import MotionTrace, RouteStep
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution


class NotWritten(LookupError):
    """The answers of a part do not all follow from equations on its page: a motion that is followed in numbers, a
    curve, a formula that holds throughout.
    """


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
        """All that was gathered. NotWritten: something is known by its number alone."""
        numbers: dict[sp.Symbol, float] = {}
        for symbol in (*self.inputs.values(), *(u for step in self.steps for u in step.unknowns)):
            numbers[symbol] = self._number(symbol)
        made = Equations(
            self.part.case,
            self.inputs,
            self.defined,
            tuple(self.steps),
            self.asked,
            tuple(self.tests),
            numbers,
            {s: role.kind for ledger in self.ledgers for s, role in ledger.roles.items()},
            {s: unit for ledger in self.ledgers for s, unit in ledger.units.items()},
            {s: title for ledger in self.ledgers for s, title in ledger.titles.items()},
        )
        loose = made.rests_on(e for a in self.asked.values() for e in a.parts) - numbers.keys() - made.defined.keys()
        if loose:
            raise NotWritten(f"{', '.join(sorted(s.name for s in loose))}: known by a number alone")
        return made

    def _number(self, symbol: sp.Symbol) -> float:
        for value in self.valuations:
            if (number := value.known(symbol)) is not None:
                return float(number)
        raise NotWritten(f"{symbol.name} has no number")


class _Instants(_Writer):
    """Instants that are each complete in themselves."""

    def equations(self) -> Equations:
        for instant in self.part.instants:
            self._take(instant)
        for found in self.part.found:
            if not is_number(found):
                continue
            if not found.asked:
                raise NotWritten(f"{found.name} is not told by the unknowns of an instant")
            self.asked[found.name] = Asked(tuple(map(sp.sympify, found.asked)), found.turn)
        return self.made()

    def _take(self, solution: InstantSolution) -> None:
        ledger = solution.instant.scene.ledger
        if solution.instant.scene.problem.symbols:
            raise NotWritten("letters without numbers remain")
        self.know(ledger, solution.value)
        for letter in ledger.letters:
            # A mass that may be any: the answers are the same with the one that was drawn.
            self.inputs[letter.name] = letter
            self.valuations.append(solution.instant.scene.valuations[0])
        for line in solution.lines:
            self.defined[line.symbol] = line.expression
        for stage in solution.stages:
            self.defined.update({line.symbol: line.expression for line in stage.lines})
            self.defined.update(dict.fromkeys(stage.zero, sp.S.Zero))
            self.steps += [_of_block(block, self.defined) for block in stage.blocks if block.equations]
        told = {u for step in self.steps for u in step.unknowns} | self.defined.keys() | set(self.inputs.values())
        for mode in solution.trial.system.modes.values():
            for test in mode.tests:
                expr = _assumed(solution, test)
                if expr is not None and expr.free_symbols and expr.free_symbols <= told:
                    self.tests.append(Test(expr, test.words))


def _assumed(solution: InstantSolution, test: Assumption) -> sp.Expr | None:
    """What a test of forces demands to be positive; None: it is about a motion."""
    symbols = solution.trial.system.symbols
    if not test.pushes or any(n not in symbols for n, _ in test.pushes) or test.within:
        return None
    return sp.Add(*(c * symbols[n] for n, c in test.pushes), sp.sympify(test.constant))


def _of_block(block: SolvedBlock, defined: Mapping[sp.Symbol, sp.Expr]) -> Step:
    unknowns = tuple(block.unknowns)
    residuals = tuple(opened(w.residual, unknowns, defined) for w in block.equations)
    if len(residuals) != len(unknowns):
        raise NotWritten("a block has not as many equations as unknowns")
    return Step(unknowns, residuals, tuple(w.law for w in block.equations), tuple(w.bodies for w in block.equations))


def opened(expr: sp.Expr, unknowns: Iterable[sp.Symbol], defined: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """An expression with those names put in that hold one of the unknowns."""
    wanted = set(unknowns)
    for _ in range(40):
        inside = {s: defined[s] for s in expr.free_symbols if s not in wanted and _holds(s, wanted, defined)}
        if not inside:
            return expr
        expr = sp.sympify(expr.xreplace(inside))
    raise NotWritten("names define each other")


def _holds(symbol: sp.Symbol, wanted: set[sp.Symbol], defined: Mapping[sp.Symbol, sp.Expr]) -> bool:
    seen: set[sp.Symbol] = set()
    waiting = [symbol]
    while waiting:
        expr = defined.get(waiting.pop())
        for inner in (expr.free_symbols if expr is not None else set()) - seen:
            if inner in wanted:
                return True
            seen.add(inner)
            waiting.append(inner)
    return False


class _Motion(_Writer):
    """A motion from state to state."""

    def __init__(self, part: PartSolution, motion: MotionTrace) -> None:
        super().__init__(part)
        self.motion = motion

    def equations(self) -> Equations:
        motion, route = self.motion, self.motion.route
        if motion.problem.symbols or motion.passing:
            raise NotWritten("letters without numbers remain")
        self.know(motion.ledger, motion.value)
        self.inputs.update({letter.name: letter for letter in motion.ledger.letters if letter in motion.value.values})
        for named in (route.plain, route.formulas, motion.named):
            for symbol, expr in named.items():
                self.defined.setdefault(symbol, sp.sympify(expr))
        self.steps = [self._step(step) for step in route.steps]
        for unknown in (u for step in self.steps for u in step.unknowns):
            self.defined.pop(unknown, None)
        for span in motion.spans:
            if span.formula is not None:
                self.defined[span.symbol] = span.formula
        by_name = {f.name: f for f in self.part.found}
        for request in motion.requests:
            found = by_name.get(request.find.name)
            if found is not None and is_number(found):
                self.asked[found.name] = Asked(tuple(map(sp.sympify, request.parts)), found.turn)
        _demand_all(self.part.found, self.asked)
        made = self.made()
        if made.rests_on(e for a in self.asked.values() for e in a.parts) & motion.guessed:
            raise NotWritten("an answer is read off a motion that is followed in numbers")
        return made

    def _step(self, step: RouteStep) -> Step:
        residuals = tuple(sp.sympify(r.residual) for r in step.relations)
        if len(residuals) != len(step.unknowns):
            raise NotWritten("a step has not as many relations as unknowns")
        if any(r.has(sp.Integral, sp.Derivative) for r in residuals):
            raise NotWritten("an integral has no closed form")
        others: dict[sp.Symbol, tuple[float, ...]] = {}
        for result in step.results:
            apart = [float(r.value) for r in result.roots]
            others[result.unknown] = tuple(v for v in apart if abs(v - float(result.value)) > 1e-9 * (abs(v) or 1))
        kinds = tuple(r.kind for r in step.relations)
        return Step(tuple(step.unknowns), residuals, kinds, ((),) * len(kinds), others)


def _demand_all(found: Iterable[Found], asked: Mapping[str, Any]) -> None:
    for one in found:
        if one.name not in asked and is_number(one):
            raise NotWritten(f"{one.name} is not asked of a state")
