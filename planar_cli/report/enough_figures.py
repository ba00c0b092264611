"""How many figures the numbers in a formula need, so that who works it out gets the result that stands behind it.

Four figures of each number give four of a product. Of a difference of nearly equal numbers they may give none, and a
root of it may even be imaginary: 10² - 2 · 9.81 · 5.097. There more figures are printed.
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
"""So many of the figures shown may differ: what rounding to four of them does to a product of several numbers."""
DEGREE = PI / 180


def enough_figures(
    expr: sp.Expr,
    rounded: Callable[[sp.Expr, int], sp.Expr],
    numbers: Mapping[sp.Symbol, Decimal],
    degrees: Collection[sp.Symbol],
    figures: int,
) -> int | None:
    """The fewest figures from `figures` on with which the printed numbers give the value of the formula; None where
    `MOST` of them do not. Where more have to be printed, all that is shown of the value comes out.

    `rounded`: the formula as printed. `numbers`: of each symbol, as it counts in the formula; those of `degrees` are
    printed in degrees.
    """
    if not expr.has(sp.Add) or expr.has(sp.Integral):
        return figures
    value = Valuation(numbers).known(expr)
    if not value:
        return figures
    unit = {s: DEGREE if s in degrees else ONE for s in numbers}
    for n in range(figures, max(MOST, figures) + 1):
        printed = {s: as_printed(x / unit[s], n) * unit[s] for s, x in numbers.items()}
        got = Valuation(printed).known(rounded(expr, n))
        margin = Decimal(10) ** (LOST - figures if n == figures else -figures)
        if got is not None and abs(got / value - 1) <= margin:
            return n
    return None
