"""One step of equations solved in machine numbers, on the branch on which the solution itself lies.

An equation of the second degree has its roots in closed form, and the slope of the residual tells them apart: it keeps
its sign as long as the branch is the same. Others are followed from the values of the solution to the others, in
strides; a branch on which the determinant of the slopes changes its sign is another one, and no solution is told there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from planar_cli.replay.equations import Equations, Step
from planar_cli.replay.opened import NotWritten, opened

Numbers = NDArray[np.float64]
ROUNDS, STRIDES = 60, (6, 30)
"""Steps of Newton's method; stretches in which what is known goes from the values of the solution to others, and in how
many where these are too few.
"""
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
    """One step: its residuals and their slopes. `needs`: what they rest on beside its unknowns; `exprs`: the residuals
    and their slopes; `second`: of one unknown in an equation of the second degree, its coefficients from the highest.
    """

    def __init__(self, step: Step, equations: Equations) -> None:
        self.unknowns = step.unknowns
        residuals = [opened(r, step.unknowns, equations.defined) for r in step.residuals]
        inside = set().union(*(r.free_symbols for r in residuals), set())
        self.needs = tuple(sorted(inside - set(step.unknowns), key=lambda s: s.name))
        slopes = [sp.diff(r, u) for r in residuals for u in step.unknowns]
        self.linear = all(not s.free_symbols & set(step.unknowns) for s in slopes)
        self.exprs = [*residuals, *slopes]
        self._call = compiled(self.exprs, [*self.needs, *step.unknowns])
        self.second = None if self.linear or len(step.unknowns) > 1 else _second(residuals[0], step.unknowns[0])
        self._second = None if self.second is None else compiled(self.second, self.needs)

    def sense(self, known: Sequence[float], at: Sequence[float]) -> float:
        """Which branch the unknowns are on: the sign of the determinant of the slopes there, 0 for none."""
        size = len(self.unknowns)
        with np.errstate(all="ignore"):
            slopes = np.array([_number(x) for x in self._call(*known, *at)[size:]]).reshape(size, size)
            found = np.sign(np.linalg.det(slopes)) if np.isfinite(slopes).all() else 0.0
        return float(found)

    def leading(self, known: Sequence[float]) -> float:
        """The sign of the highest coefficient of an equation of the second degree."""
        return 0.0 if self._second is None else float(np.sign(_number(self._second(*known)[0])))

    def __call__(self, known: Sequence[Numbers], start: Numbers, before: Sequence[float], sense: float) -> Numbers:
        """The unknowns, one row each; NaN where none are found. `start`: where they are with what was known `before`,
        on the branch of that `sense`; 0: on any.
        """
        count = start.shape[1]
        if self.linear:
            return self._newton(known, start, np.zeros_like(start), sense, 1)
        if self._second is not None and sense:
            with np.errstate(all="ignore"):
                a, b, c = (np.broadcast_to(real(x), count) for x in self._second(*known))
                return np.array([second_root((a, b, c), sense, np.sqrt)])
        first = np.array([np.full(count, x) for x in before]).reshape(len(before), count)
        if not np.isfinite(first).all():
            first = np.array([np.broadcast_to(k, count) for k in known])
        last = np.array([np.broadcast_to(k, count) for k in known], dtype=float).reshape(first.shape)
        found = self._followed(first, last, start, sense, STRIDES[0])
        lost = ~np.isfinite(found).all(0)
        if lost.any():
            found[:, lost] = self._followed(first[:, lost], last[:, lost], start[:, lost], sense, STRIDES[1])
        return found

    def _followed(self, first: Numbers, last: Numbers, start: Numbers, sense: float, strides: int) -> Numbers:
        """Along the straight way of what is known. What the residuals are at its beginning, where a step was changed,
        goes to zero meanwhile.
        """
        size, count = start.shape
        with np.errstate(all="ignore"):
            there = [np.broadcast_to(real(x), count) for x in self._call(*first, *start)[:size]]
        rest = np.where(np.isfinite(there), there, 0.0)
        found = previous = start.astype(float)
        for k in range(1, strides + 1):
            part = k / strides
            at = last if k == strides else first + part * (last - first)
            ahead = 2 * found - previous
            previous, found = found, self._newton(list(at), ahead, (1 - part) * rest, sense, ROUNDS)
        return found

    def _newton(self, known: Sequence[Numbers], start: Numbers, rest: Numbers, sense: float, rounds: int) -> Numbers:
        found, (size, count) = start.astype(float), start.shape
        for _ in range(rounds):
            with np.errstate(all="ignore"):
                called = self._call(*known, *found)
            numbers = np.array([np.broadcast_to(real(x), count) for x in called], dtype=float)
            slopes = numbers[size:].reshape(size, size, count).transpose(2, 0, 1)
            step = _solved(slopes, (numbers[:size] - rest).T).T
            found = found - step
            if np.all(~np.isfinite(step) | (np.abs(step) <= CLOSE * np.maximum(np.abs(found), 1e-30))):
                break
        lost = (np.abs(step) > FOUND * np.maximum(np.abs(found), TINY)) & (rounds > 1)
        if sense:
            with np.errstate(all="ignore"):
                lost |= np.sign(np.linalg.det(np.where(np.isfinite(slopes), slopes, 0.0))) == -sense
        return np.where(lost, np.nan, found)


def second_root(coefficients: Sequence[Any], sense: float, root: Callable[[Any], Any]) -> Any:
    """The root of a x² + b x + c at which the slope has the sign of `sense`; without a loss of digits."""
    a, b, c = coefficients
    whole = sense * root(b * b - 4 * a * c)
    if isinstance(whole, float):
        return (whole - b) / (2 * a) if b * whole < 0 else -2 * c / (whole + b)
    return np.where(b * whole < 0, (whole - b) / (2 * a), -2 * c / (whole + b))


def _second(residual: sp.Expr, unknown: sp.Symbol) -> list[sp.Expr] | None:
    """The coefficients of an equation of the second degree, from the highest; None: it is of no such degree."""
    slope = sp.diff(residual, unknown)
    twice = sp.diff(slope, unknown)
    if unknown in twice.free_symbols:
        return None
    found = [twice / 2, slope.xreplace({unknown: sp.S.Zero}), residual.xreplace({unknown: sp.S.Zero})]
    return None if any(e.has(sp.zoo, sp.nan, sp.oo) for e in found) else found


def _number(value: Any) -> float:
    return float(np.real(value)) if np.imag(value) == 0 else float("nan")


def real(numbers: Any) -> Any:
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
