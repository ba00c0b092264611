"""How many figures the numbers in a formula need, so that who works it out gets the result that stands behind it.

Four figures of each number do not always give four of a product or a square, and of a difference of nearly equal
numbers they may give none: a root of it may even be imaginary, 10² - 2 · 9.81 · 5.097. There more figures are printed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import ONE, PI, Valuation
from planar_cli.report.numbers import as_printed

MOST = 8
"""More figures are of use to nobody who works with a pocket calculator."""
LOST = 1
"""By so much the last figure may differ from what `MOST` figures give."""
DEGREE = PI / 180


def enough_figures(
    expr: sp.Expr,
    rounded: Callable[[sp.Expr, int], sp.Expr],
    numbers: Mapping[sp.Symbol, Decimal],
    degrees: Collection[sp.Symbol],
    figures: int,
) -> int | None:
    """The fewest figures from `figures` on with which the printed numbers give the value of the formula as it is shown;
    where `MOST` of them do not, those with which it is one in the last figure off, and None where there are none.

    `rounded`: the formula as printed. `numbers`: of each symbol, as it counts in the formula; those of `degrees` are
    printed in degrees.
    """
    if expr.has(sp.Integral):
        return figures
    value = Valuation(numbers).known(expr)
    if not value:
        return figures
    unit = {s: DEGREE if s in degrees else ONE for s in numbers}

    def printed(n: int) -> Decimal | None:
        shown = {s: as_printed(x / unit[s], n) * unit[s] for s, x in numbers.items()}
        return Valuation(shown).known(rounded(expr, n))

    return _fewest(printed, value, figures)


def figures_of(numbers: Sequence[Decimal], worked: Callable[[Sequence[Decimal]], Decimal], figures: int) -> int:
    """The same of numbers that stand in a line by themselves, and of what is `worked` out of them."""
    value = worked(numbers)
    found = _fewest(lambda n: worked([as_printed(x, n) for x in numbers]), value, figures) if value else None
    return figures if found is None else found


def _fewest(printed: Callable[[int], Decimal | None], value: Decimal, figures: int) -> int | None:
    """`printed`: what so many figures of each number give."""
    shown = as_printed(value, figures)
    last = Decimal(10) ** (value.copy_abs().adjusted() + 1 - figures)
    # One that ends with a 5 behind the last figure is shown with it.
    places = max(figures, len(shown.as_tuple().digits))
    near = None
    for n in range(figures, max(MOST, figures) + 1):
        got = printed(n)
        if got is None:
            continue
        off = abs(as_printed(got, places) - shown)
        if off < last / 20:
            return n
        near = n if near is None and off <= LOST * last else near
    return near
