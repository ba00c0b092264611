"""Roots of what no closed form is known of: by changes of its sign over a wide range."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal
from functools import cache, lru_cache

import sympy as sp

from planar_cli.calculus.polish import polish
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.errors import NoValue

JUMP = Decimal("1e-12")
"""A function that is still so much of what it was at the ends of the interval has no root where its sign changes."""
CERTAIN = 45
"""So many digits of a root are told."""
KEPT = 2_000
"""So many functions are remembered with their roots."""
EDGE_STEPS = 40
"""The end of where a function is real is halved down to so often."""


def scanned(expr: sp.Expr, x: sp.Symbol, value: Valuation, angle: bool) -> list[Decimal]:
    """Changes of sign over a wide range, each refined by bisection and secants."""
    letters = {s: value.known(s) for s in expr.free_symbols - {x}}
    known = {s: number for s, number in letters.items() if number is not None}
    if len(known) < len(letters):
        return _scanned(expr, x, value, angle)
    return list(_scanned_before(expr, x, frozenset(known.items()), angle))


@lru_cache(maxsize=KEPT)
def _scanned_before(
    expr: sp.Expr, x: sp.Symbol, letters: frozenset[tuple[sp.Symbol, Decimal]], angle: bool
) -> tuple[Decimal, ...]:
    """The same, remembered: what many branches of a motion come to is looked through once."""
    return tuple(_scanned(expr, x, Valuation(dict(letters)), angle))


def _scanned(expr: sp.Expr, x: sp.Symbol, value: Valuation, angle: bool) -> list[Decimal]:
    """What changes its sign is told by few digits of an integral; where it does, by all of them."""

    @cache
    def rough(v: Decimal) -> Decimal | None:
        return value.extended({x: v}).roughly().known(expr)

    @cache
    def f(v: Decimal) -> Decimal | None:
        return value.extended({x: v}).known(expr)

    if angle:
        grid = [PI * Decimal(i) / 180 - PI for i in range(0, 361, 2)]
    else:
        powers = [Decimal(10) ** (Decimal(i) / 8) for i in range(-40, 49)]
        grid = [*(-p for p in reversed(powers)), *powers]
    found = []
    last: tuple[Decimal, Decimal] | None = None
    looked = rough if expr.has(sp.Integral) else f
    for v in _with_edges(looked, grid):
        y = looked(v)
        if y is None:
            last = None
            continue
        if y == 0:
            found.append(v)
        elif last is not None and (last[1] > 0) != (y > 0):
            root = _refine(f, last[0], v)
            if root is not None:
                found.append(root)
        last = (v, y)
    return found


def _with_edges(f: Callable[[Decimal], Decimal | None], grid: list[Decimal]) -> Iterator[Decimal]:
    """The grid, closer and closer to where the function ceases to be real, as before a logarithm's end."""
    before: Decimal | None = None
    for v in grid:
        if before is not None and (f(before) is None) != (f(v) is None):
            inside, outside = (before, v) if f(v) is None else (v, before)
            for _ in range(EDGE_STEPS):
                middle = (inside + outside) / 2
                inside, outside = (inside, middle) if f(middle) is None else (middle, outside)
            start = before if f(v) is None else v
            steps = [start + (inside - start) * (1 - Decimal(2) ** -k) for k in range(1, EDGE_STEPS, 2)]
            yield from steps if f(v) is None else reversed(steps)
        yield v
        before = v


def _refine(f: Callable[[Decimal], Decimal | None], a: Decimal, b: Decimal) -> Decimal | None:
    """The root between two numbers; None where the sign changes at a pole or a jump, as of atan2 at half a turn."""
    fa, fb = f(a), f(b)
    if fa is None or fb is None:
        return None

    def real(v: Decimal) -> Decimal:
        y = f(v)
        if y is None:
            raise NoValue("a function is not real between two places where it is")
        return y

    try:
        root = polish(real, a, b, CERTAIN)
        return None if abs(real(root)) > JUMP * max(abs(fa), abs(fb)) else root
    except NoValue:
        return None
