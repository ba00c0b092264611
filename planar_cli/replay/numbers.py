"""Equations carried out in machine numbers, for many sets of inputs at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from planar_cli.replay.equations import Equations, Step
from planar_cli.replay.opened import opened
from planar_cli.replay.solver import Numbers, Solver, compiled, real

Rounding = Callable[[Numbers], Numbers]


class Replay:
    """The equations of one part, ready to be carried out. `like`: a replay from which steps that are the same are
    taken.
    """

    def __init__(self, equations: Equations, like: Replay | None = None) -> None:
        self.equations = equations
        same = like is not None and like.equations.defined == equations.defined
        known = {(s.unknowns, s.residuals): solver for s, solver in like.solvers_of_steps} if like and same else {}
        self._solvers = [known.get((s.unknowns, s.residuals)) or Solver(s, equations) for s in equations.steps]
        self._formulas: dict[sp.Expr, tuple[tuple[sp.Symbol, ...], Callable[..., list[Any]]]] = {}
        self._reduced: dict[tuple[int, tuple[sp.Symbol, ...]], Solver] = {}
        self._for_fixed: dict[frozenset[sp.Symbol], list[Solver]] = {}
        self._unchanged: Replay = self if like is None else like._unchanged
        self._senses: dict[tuple[Solver, tuple[float, ...]], float] = {}

    @property
    def solvers_of_steps(self) -> Iterable[tuple[Step, Solver]]:
        """Each step with what solves it."""
        return zip(self.equations.steps, self._solvers, strict=True)

    def run(
        self,
        inputs: Mapping[sp.Symbol, Numbers],
        fixed: Mapping[sp.Symbol, Numbers] | None = None,
        start: Mapping[sp.Symbol, float] | None = None,
        rounding: Rounding | None = None,
        exact: frozenset[sp.Symbol] = frozenset(),
    ) -> Run:
        """All unknowns for inputs that differ from those of the solution. `fixed`: unknowns that are not solved for;
        `start`: where the search for others begins, if not at the values of the solution; `rounding`: what is done to
        every number that comes out on the way, but for those that are `exact`.
        """
        count = max((np.size(v) for v in (*inputs.values(), *(fixed or {}).values())), default=1)
        base = self.equations.value
        at = {s: np.full(count, base[s]) for s in self.equations.inputs.values()}
        at |= {s: np.broadcast_to(n, count) for s, n in (*inputs.items(), *(fixed or {}).items())}
        run, before = Run(self, at, count, rounding, exact), self._at({**base, **(start or {})})
        for solver in self.solvers(frozenset(fixed or {})):
            first = [float(before.number(s)[0]) for s in solver.needs]
            there = [float(before.number(u)[0]) for u in solver.unknowns]
            sense = 0.0 if solver.linear else self._sense(solver, first, there, start or {})
            known = [run.number(s) for s in solver.needs]
            found = solver(known, np.array([np.full(count, x) for x in there]), first, sense)
            for unknown, numbers in zip(solver.unknowns, found, strict=True):
                run.values.setdefault(unknown, run.rounded(unknown, numbers))
        return run

    def _at(self, values: Mapping[sp.Symbol, float]) -> Run:
        return Run(self, {s: np.array([v]) for s, v in values.items()}, 1)

    def _sense(
        self, solver: Solver, first: Sequence[float], there: Sequence[float], start: Mapping[sp.Symbol, float]
    ) -> float:
        """The branch of a step. One that was changed has its larger root where the unchanged one has; where that cannot
        be told, any root.
        """
        key = solver, (*first, *there)
        if key not in self._senses:
            right = next((s for s in self._unchanged._solvers if s.unknowns == solver.unknowns), None)
            if right is None or right is solver:
                found = solver.sense(first, there)
            elif solver.second is None or right.second is None:
                found = 0.0
            else:
                base = self._unchanged._at({**self._unchanged.equations.value, **start})
                known = [float(base.number(s)[0]) for s in right.needs]
                found = right.sense(known, there) * right.leading(known) * solver.leading(first)
            self._senses[key] = found
        return self._senses[key]

    def solvers(self, fixed: frozenset[sp.Symbol]) -> list[Solver]:
        """What solves the steps where some unknowns are fixed."""
        if fixed not in self._for_fixed:
            found = []
            for k, whole in enumerate(self._solvers):
                left = [u for u in whole.unknowns if u not in fixed]
                if left:
                    found.append(whole if len(left) == len(whole.unknowns) else self._without(k, fixed))
            self._for_fixed[fixed] = found
        return self._for_fixed[fixed]

    def _without(self, k: int, fixed: frozenset[sp.Symbol]) -> Solver:
        """A step in which some unknowns are fixed: with as many of its equations as unknowns are left, those that fix
        them best where the solution lies.
        """
        step = self.equations.steps[k]
        left = tuple(u for u in step.unknowns if u not in fixed)
        key = (k, left)
        if key not in self._reduced:
            self._reduced[key] = Solver(self._best(step, left), self.equations)
        return self._reduced[key]

    def _best(self, step: Step, left: tuple[sp.Symbol, ...]) -> Step:
        best, most = tuple(step.residuals[: len(left)]), -1.0
        run = Run(self, {s: np.array([v]) for s, v in self.equations.value.items()}, 1)
        for some in combinations(step.residuals, len(left)):
            opened_ones = [opened(r, step.unknowns, self.equations.defined) for r in some]
            slopes = np.array([[float(run.of(sp.diff(r, u))[0]) for u in left] for r in opened_ones])
            rows = np.abs(slopes).max(1, keepdims=True)
            size = abs(float(np.linalg.det(slopes / np.where(rows > 0, rows, 1.0))))
            if size > most:
                best, most = tuple(some), size
        return Step(left, best)

    def formula(self, expr: sp.Expr) -> tuple[tuple[sp.Symbol, ...], Callable[..., list[Any]]]:
        """An expression as a function, with the symbols that it takes."""
        if expr not in self._formulas:
            names = tuple(sorted(expr.free_symbols, key=lambda s: s.name))
            self._formulas[expr] = names, compiled([expr], names)
        return self._formulas[expr]


class Run:
    """Numbers of one carrying out: of inputs and unknowns, and through them of any expression."""

    def __init__(
        self,
        replay: Replay,
        values: dict[sp.Symbol, Numbers],
        count: int,
        rounding: Rounding | None = None,
        exact: frozenset[sp.Symbol] = frozenset(),
    ) -> None:
        self.replay, self.values, self.count = replay, values, count
        self.rounding, self.exact = rounding, exact

    def rounded(self, symbol: sp.Symbol, numbers: Numbers) -> Numbers:
        """A result as it is carried on."""
        return numbers if self.rounding is None or symbol in self.exact else self.rounding(numbers)

    def number(self, symbol: sp.Symbol) -> Numbers:
        """Of a symbol that is known by now."""
        if symbol not in self.values:
            found = self.of(self.replay.equations.defined[symbol])
            self.values[symbol] = self.rounded(symbol, found)
        return self.values[symbol]

    def of(self, expr: sp.Expr) -> Numbers:
        """Of an expression; NaN where it has no value."""
        names, call = self.replay.formula(sp.sympify(expr))
        with np.errstate(all="ignore"):
            (found,) = call(*(self.number(s) for s in names))
        return np.broadcast_to(np.asarray(real(found), dtype=float), self.count)

    def asked(self, find: str) -> tuple[Numbers, ...]:
        """The parts of a find."""
        return tuple(self.of(e) for e in self.replay.equations.asked[find].parts)

    def holds(self) -> NDArray[np.bool_]:
        """Where every test is passed."""
        passed = np.ones(self.count, dtype=bool)
        for test in self.replay.equations.tests:
            passed &= self.of(test.positive) > -1e-12
        return passed
