"""Equations carried out once, in plain floats: for one set of numbers arrays would take twenty times as long."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from planar_cli.replay.numbers import CLOSE, FOUND, ROUNDS, TINY, Replay, Solver, compiled

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
        self._calls: dict[int, Callable[..., list[Any]]] = {}
        self._formulas: dict[sp.Expr, tuple[tuple[sp.Symbol, ...], Callable[..., list[Any]]]] = {}

    def run(self, inputs: Mapping[sp.Symbol, float], fixed: Mapping[sp.Symbol, float], start: Values) -> Values:
        """Numbers of inputs and unknowns, some of them fixed, near a start. NoNumber: there are none."""
        values = {**inputs, **fixed}
        for solver in self.replay.solvers(frozenset(fixed)):
            try:
                known = [self.number(s, values) for s in solver.needs]
                values.update(zip(solver.unknowns, self._solved(solver, known, start), strict=True))
            except FAILURES as error:
                raise NoNumber(str(error)) from None
        return values

    def _solved(self, solver: Solver, known: Sequence[float], start: Values) -> list[float]:
        found, size = [start[u] for u in solver.unknowns], len(solver.unknowns)
        if id(solver) not in self._calls:
            self._calls[id(solver)] = compiled(solver.exprs, [*solver.needs, *solver.unknowns], "math")
        call = self._calls[id(solver)]
        for _ in range(1 if solver.linear else ROUNDS):
            numbers = call(*known, *found)
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
