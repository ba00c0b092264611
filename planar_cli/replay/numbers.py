"""Equations carried out in machine numbers, for many sets of inputs at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import combinations
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from planar_cli.replay.equations import Equations, Step
from planar_cli.replay.opened import NotWritten, opened

Numbers = NDArray[np.float64]
Rounding = Callable[[Numbers], Numbers]
ROUNDS, STRIDES = 60, 6
"""Steps of Newton's method; stretches in which inputs go from those of the solution to others."""
CLOSE = 1e-13
"""A change by less, in parts of an unknown, is the last."""
FOUND, TINY = 1e-6, 1e-9
"""A search whose last change was more than this part of an unknown (and of a tiny number) has found nothing."""


def compiled(exprs: Sequence[sp.Expr], names: Sequence[sp.Symbol], numbers: str = "numpy") -> Callable[..., list[Any]]:
    """A function of the numbers of `names` that gives those of all expressions; `numbers`: numpy's, or those of math.

    Only symbols of ours get into the text that is compiled: no name of a file does.
    """
    if any(e.has(sp.zoo, sp.nan, sp.oo) for e in exprs):
        raise NotWritten("a formula has no value")
    loose = set().union(*(e.free_symbols for e in exprs), set()) - set(names)
    assert not loose, f"{loose} have no numbers"
    ours = {s: sp.Symbol(f"q{i}", real=True) for i, s in enumerate(names)}
    made: Callable[..., list[Any]] = sp.lambdify(
        [ours[s] for s in names], [e.xreplace(ours) for e in exprs], modules=numbers, cse=True, docstring_limit=0
    )
    return made


class Solver:
    """One step: its residuals and their slopes. `needs`: what they rest on beside its unknowns."""

    def __init__(self, step: Step, equations: Equations) -> None:
        self.unknowns = step.unknowns
        residuals = [opened(r, step.unknowns, equations.defined) for r in step.residuals]
        inside = set().union(*(r.free_symbols for r in residuals), set())
        self.needs = tuple(sorted(inside - set(step.unknowns), key=lambda s: s.name))
        slopes = [sp.diff(r, u) for r in residuals for u in step.unknowns]
        self.linear = all(not s.free_symbols & set(step.unknowns) for s in slopes)
        self.exprs = [*residuals, *slopes]
        self._call = compiled(self.exprs, [*self.needs, *step.unknowns])

    def __call__(self, known: Sequence[Numbers], start: Numbers) -> Numbers:
        """The unknowns, one row each, from a start; NaN where none are found."""
        found, size, count = start.astype(float), len(self.unknowns), start.shape[1]
        for _ in range(1 if self.linear else ROUNDS):
            with np.errstate(all="ignore"):
                called = self._call(*known, *found)
            numbers = np.array([np.broadcast_to(_real(x), count) for x in called], dtype=float)
            slopes = numbers[size:].reshape(size, size, count).transpose(2, 0, 1)
            step = _solved(slopes, numbers[:size].T).T
            found = found - step
            if np.all(~np.isfinite(step) | (np.abs(step) <= CLOSE * np.maximum(np.abs(found), 1e-30))):
                break
        lost = False if self.linear else np.abs(step) > FOUND * np.maximum(np.abs(found), TINY)
        return np.where(lost, np.nan, found)


def _real(numbers: Any) -> Any:
    """NaN in place of what is not real."""
    return np.where(np.imag(numbers) == 0, np.real(numbers), np.nan) if np.iscomplexobj(numbers) else numbers


def _solved(slopes: Numbers, residuals: Numbers) -> Numbers:
    """Solutions of linear systems, NaN where a system has none."""
    fit = np.isfinite(slopes).all((1, 2)) & np.isfinite(residuals).all(1)
    out = np.full(residuals.shape, np.nan)
    if fit.any():
        # Rows of unit size, so that what counts as singular does not depend on units.
        rows = np.abs(slopes[fit]).max(2, keepdims=True)
        fine = (rows > 0).all((1, 2))
        index = np.flatnonzero(fit)[fine]
        if index.size:
            scaled = slopes[index] / rows[fine]
            right = residuals[index] / rows[fine][:, :, 0]
            regular = np.abs(np.linalg.det(scaled)) > 1e-14
            if regular.any():
                out[index[regular]] = np.linalg.solve(scaled[regular], right[regular][:, :, None])[:, :, 0]
    return out


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
        strides = 1 if self._all_linear() or not inputs else STRIDES
        from_here = {u: np.full(count, (start or {}).get(u, base[u])) for u in self.equations.unknowns}
        run = Run(self, {}, count)
        for k in range(1, strides + 1):
            part = k / strides
            at = {
                s: np.full(count, base[s]) + part * (np.broadcast_to(inputs[s], count) - base[s])
                if s in inputs
                else np.full(count, base[s])
                for s in self.equations.inputs.values()
            }
            run = self._once(at, fixed or {}, from_here, count, (rounding, exact))
            from_here = {u: run.values[u] for u in self.equations.unknowns}
        return run

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

    def _all_linear(self) -> bool:
        return all(s.linear for s in self._solvers)

    def _once(
        self,
        at: dict[sp.Symbol, Numbers],
        fixed: Mapping[sp.Symbol, Numbers],
        start: dict[sp.Symbol, Numbers],
        count: int,
        rounded: tuple[Rounding | None, frozenset[sp.Symbol]],
    ) -> Run:
        run = Run(self, {**at, **{s: np.broadcast_to(v, count) for s, v in fixed.items()}}, count, *rounded)
        for solver in self.solvers(frozenset(fixed)):
            known = [run.number(s) for s in solver.needs]
            found = solver(known, np.array([start[u] for u in solver.unknowns]))
            for unknown, numbers in zip(solver.unknowns, found, strict=True):
                run.values.setdefault(unknown, run.rounded(unknown, numbers))
        return run

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
        return np.broadcast_to(np.asarray(_real(found), dtype=float), self.count)

    def asked(self, find: str) -> tuple[Numbers, ...]:
        """The parts of a find."""
        return tuple(self.of(e) for e in self.replay.equations.asked[find].parts)

    def holds(self) -> NDArray[np.bool_]:
        """Where every test is passed."""
        passed = np.ones(self.count, dtype=bool)
        for test in self.replay.equations.tests:
            passed &= self.of(test.positive) > -1e-12
        return passed
