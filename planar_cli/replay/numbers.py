"""Equations carried out in machine numbers, for many sets of inputs at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from planar_cli.replay.equations import Equations, Step
from planar_cli.replay.opened import opened
from planar_cli.replay.solver import Numbers, Solver, compiled, real

SINGULAR, MOST_WAYS = 1e-6, 6
"""Equations fix what is left where their determinant is no smaller part of the largest; so many choices at most."""
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
        self._reduced: dict[tuple[int, tuple[sp.Symbol, ...]], list[Solver]] = {}
        self._for_fixed: dict[tuple[frozenset[sp.Symbol], int], list[Solver]] = {}
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
            sense = self._sense(solver, first, there, start or {})
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
        """The branch of a step. One that was changed has its larger root where the unchanged one has, and no root where
        that is beyond all bounds, as the way of a block without the spring that stops it; where that cannot be told,
        any root.
        """
        key = solver, (*first, *there)
        if key not in self._senses:
            right = next((s for s in self._unchanged._solvers if s.unknowns == solver.unknowns), None)
            if right is None or right is solver:
                found = 0.0 if solver.linear else solver.sense(first, there)
            elif right.second is None or (solver.second is None and not solver.linear):
                found = 0.0
            else:
                base = self._unchanged._at({**self._unchanged.equations.value, **start})
                known = [float(base.number(s)[0]) for s in right.needs]
                of_larger = right.sense(known, there) * right.leading(known)
                found = of_larger * (solver.leading(first) or right.leading(known))
            self._senses[key] = found
        return self._senses[key]

    def solvers(self, fixed: frozenset[sp.Symbol], way: int = 0) -> list[Solver]:
        """What solves the steps where some unknowns are fixed: by the equations that fix the others best, or another
        `way`.
        """
        if (fixed, way) not in self._for_fixed:
            found = []
            left_of_way = way
            for k, whole in enumerate(self._solvers):
                left = tuple(u for u in whole.unknowns if u not in fixed)
                if len(left) == len(whole.unknowns):
                    found.append(whole)
                elif left:
                    some = self._without(k, left)
                    left_of_way, place = divmod(left_of_way, len(some))
                    found.append(some[place])
            self._for_fixed[fixed, way] = found
        return self._for_fixed[fixed, way]

    def ways(self, fixed: frozenset[sp.Symbol]) -> int:
        """In how many ways the others follow where some unknowns are fixed: a block has more equations then than it
        needs, and which are used makes a difference where what is fixed is wrong.
        """
        lefts = ((k, tuple(u for u in s.unknowns if u not in fixed)) for k, s in enumerate(self._solvers))
        reduced = [(k, left) for k, left in lefts if 0 < len(left) < len(self._solvers[k].unknowns)]
        return math.prod(len(self._without(k, left)) for k, left in reduced)

    def _without(self, k: int, left: tuple[sp.Symbol, ...]) -> list[Solver]:
        """A step of which only some unknowns are left: each choice of as many equations that fixes them, first the one
        that fixes them best where the solution lies.
        """
        if (k, left) not in self._reduced:
            made = [Solver(Step(left, some), self.equations) for some in self._choices(self.equations.steps[k], left)]
            self._reduced[k, left] = made
        return self._reduced[k, left]

    def _choices(self, step: Step, left: tuple[sp.Symbol, ...]) -> list[tuple[sp.Expr, ...]]:
        run = Run(self, {s: np.array([v]) for s, v in self.equations.value.items()}, 1)
        opened_ones = {r: opened(r, step.unknowns, self.equations.defined) for r in step.residuals}
        slopes = {r: [float(run.of(sp.diff(e, u))[0]) for u in left] for r, e in opened_ones.items()}
        found = []
        for some in combinations(step.residuals, len(left)):
            matrix = np.array([slopes[r] for r in some])
            rows = np.abs(matrix).max(1, keepdims=True)
            found.append((abs(float(np.linalg.det(matrix / np.where(rows > 0, rows, 1.0)))), some))
        found.sort(key=lambda one: -one[0])
        return [some for size, some in found if size > SINGULAR * found[0][0]][:MOST_WAYS] or [found[0][1]]

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
