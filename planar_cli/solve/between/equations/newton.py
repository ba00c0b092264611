"""Equations of a motion solved together by Newton's method from values that are known to twelve digits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

import mpmath
import sympy as sp

from planar_cli.equation.algebra.plain import derivative, letters
from planar_cli.equation.values.exact import DIGITS, ZERO, Valuation
from planar_cli.errors import NotReached, NoValue
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch

STEPS = 12
SMALL = Decimal("1e-42")
LEAST = Decimal("1e-3")
"""A value is measured by itself, or by this part of an ordinary one."""


def refined_left(
    course: MotionEquations, branch: Branch, unknowns: Sequence[sp.Symbol], truth: Mapping[sp.Symbol, float]
) -> dict[sp.Symbol, Decimal]:
    """What no block of a branch gives alone, from all equations that it leaves, together."""
    if not unknowns:
        return {}
    known = course.base().extended(branch.values)
    dark = course.chain().unknowns - set(branch.values) - set(unknowns)
    residuals = [e.residual for e in branch.left if not e.residual.free_symbols & dark]
    try:
        return refined(residuals, unknowns, truth, known, course.natural(unknowns))
    except NoValue:
        return {}


def refined(
    residuals: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    truth: Mapping[sp.Symbol, float],
    value: Valuation,
    natural: Mapping[sp.Symbol, Decimal],
) -> dict[sp.Symbol, Decimal]:
    """The unknowns that the equations determine, to all digits; those that they leave open are left out. `natural`: an
    ordinary size of each.

    NotReached: Newton's method goes elsewhere than to the values it starts from.
    """
    exprs = [e for e in residuals if not e.has(sp.Integral)]
    used = [x for x in unknowns if any(x in letters(e) for e in exprs)]
    if not exprs or not used:
        return {}
    slopes = [[derivative(e, x) for x in used] for e in exprs]
    at = {x: Decimal(repr(truth[x])) for x in used}
    sizes = {x: max(abs(at[x]), LEAST * natural[x]) for x in used}
    with mpmath.workdps(DIGITS):
        for _ in range(STEPS):
            here = value.extended(at)
            rest = mpmath.matrix([_number(here(e)) for e in exprs])
            jacobian = mpmath.matrix(
                [[_number(here(d) * sizes[x]) for d, x in zip(row, used, strict=True)] for row in slopes]
            )
            step, loose = _least_squares(jacobian, rest)
            at = {x: at[x] - Decimal(mpmath.nstr(step[i], DIGITS)) * sizes[x] for i, x in enumerate(used)}
            if max(abs(s) for s in step) < _number(SMALL):
                break
    for x in used:
        if abs(at[x] - Decimal(repr(truth[x]))) > Decimal("1e-5") * sizes[x]:
            raise NotReached("Newton's method does not stay where the motion was")
    # What is left of a zero where the steps end is the rounding of the last one.
    return {x: at[x] if abs(at[x]) > SMALL * sizes[x] else ZERO for i, x in enumerate(used) if i not in loose}


def _number(value: Decimal) -> Any:
    if not value.is_finite():
        raise NotReached("infinite")
    return mpmath.mpf(str(value))


def _least_squares(jacobian: Any, rest: Any) -> tuple[Any, set[int]]:
    """The step of least squares, and the unknowns that the equations leave open: columns without a pivot."""
    square, right = jacobian.T * jacobian, jacobian.T * rest
    n = square.rows
    loose: set[int] = set()
    size = max(abs(square[i, i]) for i in range(n)) or mpmath.mpf(1)
    order: list[int] = []
    rows = [[square[i, j] for j in range(n)] + [right[i]] for i in range(n)]
    left = set(range(n))
    for _ in range(n):
        pivot = max(left, key=lambda i: abs(rows[i][i]))
        if abs(rows[pivot][pivot]) <= size * mpmath.mpf(10) ** -22:
            loose |= left
            break
        left.discard(pivot)
        order.append(pivot)
        for i in range(n):
            if i != pivot and rows[i][pivot]:
                factor = rows[i][pivot] / rows[pivot][pivot]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[pivot], strict=True)]
    step = [mpmath.mpf(0)] * n
    for i in order:
        step[i] = rows[i][n] / rows[i][i]
        if any(abs(rows[i][j]) > abs(rows[i][i]) * mpmath.mpf(10) ** -15 for j in loose):
            loose.add(i)
    return step, loose
