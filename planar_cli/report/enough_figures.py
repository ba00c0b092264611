"""How many figures the numbers in a formula need, so that who works it out gets the result that stands behind it.

Four figures of each number do not always give four of a product or a square, and of a difference of nearly equal
numbers they may give none: a root of it may even be imaginary, 10² - 2 · 9.81 · 5.097. There more figures are printed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import ONE, PI, Valuation
from planar_cli.report.numbers import as_printed

MOST = 8
"""More figures are of use to nobody who works with a pocket calculator."""
LOST = 1
"""By so much the last figure shown may differ from what the printed numbers give."""
DEGREE = PI / 180


def enough_figures(
    expr: sp.Expr,
    rounded: Callable[[sp.Expr, int], sp.Expr],
    numbers: Mapping[sp.Symbol, Decimal],
    degrees: Collection[sp.Symbol],
    figures: int,
) -> int | None:
    """The fewest figures from `figures` on with which the printed numbers give the value of the formula as it is shown,
    but for one in its last figure; None where `MOST` of them do not.

    `rounded`: the formula as printed. `numbers`: of each symbol, as it counts in the formula; those of `degrees` are
    printed in degrees.
    """
    if expr.has(sp.Integral):
        return figures
    value = Valuation(numbers).known(expr)
    if not value:
        return figures
    unit = {s: DEGREE if s in degrees else ONE for s in numbers}
    for n in range(figures, max(MOST, figures) + 1):
        printed = {s: as_printed(x / unit[s], n) * unit[s] for s, x in numbers.items()}
        got = Valuation(printed).known(rounded(expr, n))
        last = Decimal(10) ** (value.copy_abs().adjusted() + 1 - figures)
        if got is not None and abs(as_printed(got, figures) - as_printed(value, figures)) <= LOST * last:
            return n
    return None
