"""How many figures the numbers in a formula need, so that who works it out gets the result that stands behind it.

Four figures of each number do not always give four of a product or a square, and of a difference of nearly equal
numbers they may give none: a root of it may even be imaginary, 10² - 2 · 9.81 · 5.097. There more figures are printed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import ONE, PI, Valuation
from planar_cli.records import record
from planar_cli.report.notation.numbers import as_printed

MOST = 8
"""More figures are of use to nobody who works with a pocket calculator."""
HALF = Decimal("0.5000001")
"""What is off by half of the last figure may be rounded to it."""
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


@record
class Figures:
    """How many figures the numbers that stand for symbols have, and those of the formula itself."""

    each: Mapping[sp.Symbol, int]
    own: int


def figures_each(
    expr: sp.Expr,
    rounded: Callable[[sp.Expr, int], sp.Expr],
    numbers: Mapping[sp.Symbol, Decimal],
    degrees: Collection[sp.Symbol],
    figures: int,
) -> Figures | None:
    """As `enough_figures`, but more than `figures` only for those numbers of which they are needed: in 0.4 - 0.39965 of
    both, in 400 · 0.39965 + 3.2 of one.
    """
    most = enough_figures(expr, rounded, numbers, degrees, figures)
    if most is None:
        return None
    alike: dict[Decimal | None, list[sp.Symbol]] = {}
    for s in sorted(numbers, key=str):
        alike.setdefault(abs(numbers[s]), []).append(s)
    if most == figures or (len(alike) == 1 and rounded(expr, most) == rounded(expr, figures)):
        return Figures(dict.fromkeys(numbers, most), most)
    off = _offset(expr, rounded, numbers, degrees, figures)

    def told(found: Mapping[Decimal | None, int]) -> Decimal:
        return off({s: n for x, n in found.items() for s in alike.get(x, ())}, found[None])

    found: dict[Decimal | None, int] = dict.fromkeys([None, *alike], most)
    allowed = told(found)
    for x in sorted(found, key=lambda x: (told({**found, x: figures}), x or 0)):
        found[x] = next(n for n in range(figures, most + 1) if n == most or told({**found, x: n}) <= allowed)
    return Figures({s: n for x, n in found.items() for s in alike.get(x, ())}, found[None])


def _offset(
    expr: sp.Expr,
    rounded: Callable[[sp.Expr, int], sp.Expr],
    numbers: Mapping[sp.Symbol, Decimal],
    degrees: Collection[sp.Symbol],
    figures: int,
) -> Callable[[Mapping[sp.Symbol, int], int], Decimal]:
    """By how much the result of numbers with so many figures each, and of the formula with so many, differs from the
    one that is shown; nothing where it would be shown so.
    """
    shown, half = _shown(Valuation(numbers)(expr), figures)
    unit = {s: DEGREE if s in degrees else ONE for s in numbers}
    forms: dict[int, sp.Expr] = {}

    def off(each: Mapping[sp.Symbol, int], own: int) -> Decimal:
        form = forms[own] = forms[own] if own in forms else rounded(expr, own)
        got = Valuation({s: as_printed(x / unit[s], each[s]) * unit[s] for s, x in numbers.items()}).known(form)
        apart = Decimal("Infinity") if got is None else abs(got - shown)
        return Decimal(0) if apart <= half else apart

    return off


def figures_of(numbers: Sequence[Decimal], worked: Callable[[Sequence[Decimal]], Decimal], figures: int) -> int:
    """The same of numbers that stand in a line by themselves, and of what is `worked` out of them."""
    value = worked(numbers)
    found = _fewest(lambda n: worked([as_printed(x, n) for x in numbers]), value, figures) if value else None
    return figures if found is None else found


def _fewest(printed: Callable[[int], Decimal | None], value: Decimal, figures: int) -> int | None:
    """`printed`: what so many figures of each number give."""
    shown, half = _shown(value, figures)
    last = Decimal(10) ** (shown.adjusted() + 1 - figures)
    near = None
    for n in range(figures, max(MOST, figures) + 1):
        got = printed(n)
        if got is None:
            continue
        off = abs(got - shown)
        if off <= half:
            return n
        near = n if near is None and off <= half + LOST * last else near
    return near


def _shown(value: Decimal, figures: int) -> tuple[Decimal, Decimal]:
    """A result as it is shown, and by how much another may differ that is shown so: half of its last figure. One that
    ends with a 5 behind the last figure is shown with it.
    """
    shown = as_printed(value, figures)
    places = max(figures, len(shown.as_tuple().digits))
    # 0.0999999… of sixty digits is 0.1: its last figure is that of the number shown.
    return shown, Decimal(10) ** (shown.adjusted() + 1 - places) * HALF
