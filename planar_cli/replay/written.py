"""The equations of a solution, taken from what it wrote: blocks of an instant, or the route through a motion."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp

from planar_cli.replay.at_states import AtState, StateNumbers, at_state, constant_steps, renamed
from planar_cli.replay.equations import Asked, Equations, Step
from planar_cli.replay.instants import Instants
from planar_cli.replay.opened import NotWritten
from planar_cli.replay.writer import Writer, is_number
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace, RouteStep
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

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
    return Instants(part).equations()


class _Motion(Writer):
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
