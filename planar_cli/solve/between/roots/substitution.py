"""What one equation gives to be put into the others: an unknown that enters linearly, or by its square alone."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, letters, longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.trace.trace import Result

LONGEST = 120
"""Of a longer equation no square is put into another: no root of what comes of it has a closed form."""


def square(residual: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """What stands without x and with its square, if there is nothing else."""
    if longer(residual, LONGEST) or not residual.is_polynomial(x):
        return None
    found = {m[0]: c for m, c in sp.Poly(residual, x).terms()}
    return (found.get(0, sp.S.Zero), found[2]) if {2} <= found.keys() <= {0, 2} else None


STATE, TIME = "__", "t__"
"""In the name of a letter of one state; what that of its time begins with."""
SQUARE = 2


def linear_step(
    pool: list[sp.Expr], left: list[sp.Symbol], value: Valuation, most: int, used: Collection[sp.Symbol] | None = None
) -> tuple[int, sp.Symbol, sp.Expr] | None:
    """An equation that is linear in an unknown which it really contains; the shortest formula. `used`: what other
    equations of the way need, or is asked; with it also places as functions of the one time that is unknown.
    """
    if used is not None and len(pool) > 1 and (placed := _by_the_time(pool, left, value, used)) is not None:
        return placed
    found: list[tuple[int, int, sp.Symbol, sp.Expr]] = []
    for x in left:
        for index, residual in enumerate(pool):
            rate = derivative(residual, x)
            if rate == 0 or x in letters(rate):
                continue
            if value.known(rate) is None or value.is_zero(rate):
                continue
            formula = simplified(-(residual - rate * x).expand() / rate) if not longer(residual, most) else None
            formula = -expanded(residual - rate * x) / rate if formula is None else formula
            found.append((int(sp.count_ops(formula)), index, x, formula))
    if not found:
        return None
    # A constant that is sought is left for the last: the letters of all states rest on it.
    _, index, x, formula = min(found, key=lambda f: (STATE not in f[2].name, f[0], f[2].name))
    return index, x, formula


def _by_the_time(
    pool: list[sp.Expr], left: list[sp.Symbol], value: Valuation, used: Collection[sp.Symbol]
) -> tuple[int, sp.Symbol, sp.Expr] | None:
    """The first of places and speeds that are put in as functions of the one time that is unknown, where a linear or
    quadratic equation for the time is left: 30 t = 1/2 · 4 (t - 2)². None: it is no such thing, or only the time
    since an earlier state counts, which is the other root, and nothing else needs to know when either is.
    """
    times = [x for x in left if x.name.startswith(TIME)]
    if len(times) != 1 or any(longer(r, LONGEST) for r in pool):
        return None
    rest, waiting, first = list(pool), [x for x in left if x not in times], None
    while waiting:
        plain = [f for f in _explicit(rest, waiting, left) if not value.is_zero(derivative(rest[f[1]], f[2]))]
        if not plain:
            return None
        _, index, x, formula = min(plain, key=lambda f: (f[0], f[2].name))
        first = first or (index, x, formula)
        rest.pop(index)
        rest = [r.xreplace({x: formula}) for r in rest]
        waiting.remove(x)
    last = sp.fraction(together(rest[0]))[0] if len(rest) == 1 else sp.S.Zero
    earlier = [s for s in letters(last) - {*times, *used} if s.name.startswith(TIME) and times[0] not in used]
    if any(expanded(last.xreplace({times[0]: s})) == 0 for s in earlier):
        return None
    return first if last.is_polynomial(*times) and 0 < sp.degree(last, times[0]) <= SQUARE else None


def _explicit(
    pool: Sequence[sp.Expr], waiting: Sequence[sp.Symbol], left: Sequence[sp.Symbol]
) -> list[tuple[int, int, sp.Symbol, sp.Expr]]:
    """What is linear in one of the letters, with a factor that is known: how long its formula is, which equation it is,
    the letter, the formula.
    """
    found = []
    for x, (index, residual) in itertools.product(waiting, enumerate(pool)):
        rate = derivative(residual, x)
        if rate != 0 and not letters(rate) & set(left):
            formula = -expanded(residual - rate * x) / rate
            found.append((int(sp.count_ops(formula)), index, x, formula))
    return found


def same_as(told: Sequence[Result], before: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """Letters of states that are a constant of the file, or the same number as one of an earlier state: a ball that is
    back at its height.
    """
    found: dict[sp.Symbol, sp.Expr] = {}
    for r in told:
        formula, base = r.formula, r.unknown.name.partition(STATE)[0]
        if formula is None or STATE not in r.unknown.name or formula == 0:
            continue
        if formula.is_Symbol and STATE not in formula.name:
            found[r.unknown] = formula
        elif formula.is_number:
            earlier = [s for s, f in before.items() if f == formula and s.name.partition(STATE)[0] == base]
            if earlier and earlier[0] != r.unknown:
                found[r.unknown] = earlier[0]
    return found
