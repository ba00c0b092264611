"""Equations carried out once, in plain floats: for one set of numbers arrays would take twenty times as long."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from planar_cli.replay.numbers import Replay
from planar_cli.replay.solver import CLOSE, FOUND, ROUNDS, STRIDES, TINY, Solver, compiled, second_root

Values = dict[sp.Symbol, float]
FAILURES = (ArithmeticError, ValueError, TypeError)
"""What plain floats raise where a formula has no value; a power of a negative number is complex, and compared with
nothing.
"""


class NoNumber(ArithmeticError):
    """The equations have no solution that is found from the start."""


class Single:
    """The same equations as those of a replay, for one set of numbers at a time."""

    def __init__(self, replay: Replay) -> None:
        self.replay = replay
        self._calls: dict[tuple[int, bool], Callable[..., list[Any]]] = {}
        self._formulas: dict[sp.Expr, tuple[tuple[sp.Symbol, ...], Callable[..., list[Any]]]] = {}

    def run(
        self, inputs: Mapping[sp.Symbol, float], fixed: Mapping[sp.Symbol, float], start: Values, way: int = 0
    ) -> Values:
        """Numbers of inputs and unknowns, some of them fixed, from a start; by the equations that fix the others best,
        or another `way`. NoNumber: there are none.
        """
        values, before = {**inputs, **fixed}, dict(start)
        for solver in self.replay.solvers(frozenset(fixed), way):
            try:
                known = [self.number(s, values) for s in solver.needs]
                values.update(zip(solver.unknowns, self._solved(solver, known, before), strict=True))
            except FAILURES as error:
                raise NoNumber(str(error)) from None
        return values

    def _solved(self, solver: Solver, known: Sequence[float], before: Values) -> list[float]:
        """The unknowns of a step, on the branch on which they were before."""
        there = [before[u] for u in solver.unknowns]
        if solver.linear:
            return self._newton(solver, known, there, 1)
        first = [self.number(s, before) for s in solver.needs]
        sense = solver.sense(first, there)
        if solver.second is not None and sense:
            found = [float(second_root(self._called(solver, solver.second, known), sense, math.sqrt))]
            if not math.isfinite(found[0]):
                raise NoNumber("no finite solution")
            return found
        for strides in STRIDES:
            try:
                found = self._followed(solver, first, known, there, strides)
            except FAILURES:
                continue
            if not sense or solver.sense(known, found) == sense:
                return found
        raise NoNumber("no solution is found")

    def _followed(
        self, solver: Solver, first: Sequence[float], last: Sequence[float], there: list[float], strides: int
    ) -> list[float]:
        found = previous = there
        for k in range(1, strides + 1):
            at = [a + k / strides * (b - a) for a, b in zip(first, last, strict=True)]
            ahead = [2 * x - y for x, y in zip(found, previous, strict=True)]
            previous, found = found, self._newton(solver, last if k == strides else at, ahead, ROUNDS)
        return found

    def _called(self, solver: Solver, exprs: list[sp.Expr], numbers: Sequence[float]) -> list[Any]:
        key = id(solver), exprs is solver.second
        if key not in self._calls:
            names = solver.needs if exprs is solver.second else (*solver.needs, *solver.unknowns)
            self._calls[key] = compiled(exprs, names, "math")
        return self._calls[key](*numbers)

    def _newton(self, solver: Solver, known: Sequence[float], start: list[float], rounds: int) -> list[float]:
        found, size = start, len(solver.unknowns)
        for _ in range(rounds):
            numbers = self._called(solver, solver.exprs, (*known, *found))
            if size == 1:
                step = [numbers[0] / numbers[1]]
            else:
                slopes = np.array(numbers[size:], dtype=float).reshape(size, size)
                step = [float(x) for x in np.linalg.solve(slopes, np.array(numbers[:size], dtype=float))]
            found = [x - d for x, d in zip(found, step, strict=True)]
            if all(abs(d) <= CLOSE * max(abs(x), 1e-30) for x, d in zip(found, step, strict=True)):
                break
        else:
            if not solver.linear and any(abs(d) > FOUND * max(abs(x), TINY) for x, d in zip(found, step, strict=True)):
                raise NoNumber("no solution is found")
        if not all(map(math.isfinite, found)):
            raise NoNumber("no finite solution")
        return found

    def number(self, symbol: sp.Symbol, values: Values) -> float:
        """Of a symbol that is known by now."""
        if symbol not in values:
            values[symbol] = self.of(self.replay.equations.defined[symbol], values)
        return values[symbol]

    def of(self, expr: sp.Expr, values: Values) -> float:
        """Of an expression. NoNumber: it has none."""
        if expr not in self._formulas:
            names = tuple(sorted(expr.free_symbols, key=lambda s: s.name))
            self._formulas[expr] = names, compiled([expr], names, "math")
        names, call = self._formulas[expr]
        try:
            return float(call(*(self.number(s, values) for s in names))[0])
        except FAILURES as error:
            raise NoNumber(str(error)) from None
