"""Reactions that are not unique: one distribution of them with which every assumption holds.

Whether all can hold is decided by elimination (`study.feasible`); going back through it gives values. Of those that one
unknown may have, given the others, zero is taken where it is allowed, else the middle.
"""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal

from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import ONE, ZERO
from planar_cli.solve.instant.study import Outcome, measure, under_way

Bound = tuple[Decimal, dict[int, Decimal]]
"""value + Σ slope · free ≥ 0: the value, and the slopes by the columns of what is free."""


def possible(system: System, outcome: Outcome) -> Outcome | None:
    """The same outcome with every reaction told; None: they are unique, or no such values are found."""
    null = outcome.solved.null
    bounds: list[Bound] = []
    for mode in system.modes.values():
        tests = (test for test in mode.tests if not under_way(test, mode, outcome.assembly))
        bounds += [measure(test, outcome.assembly, outcome.solved) for test in tests]
    free = sorted({column for _, slopes in bounds for column in slopes})
    if not free or len(free) != len(null):
        return None
    found = point_within(bounds, free)
    if found is None:
        return None
    values = [
        v + sum((found[column] * vector[j] for column, vector in null.items()), ZERO)
        for j, v in enumerate(outcome.solved.values)
    ]
    return replace(outcome, solved=replace(outcome.solved, values=values, null={}))


def point_within(bounds: list[Bound], free: list[int]) -> dict[int, Decimal] | None:
    """Values of what is free with which all bounds hold; None: there are none."""
    if not free:
        return {} if all(value >= 0 for value, _ in bounds) else None
    column, *others = free
    lower = [b for b in bounds if b[1].get(column, ZERO) > 0]
    upper = [b for b in bounds if b[1].get(column, ZERO) < 0]
    rest = [b for b in bounds if not b[1].get(column)]
    rest += [_without(column, low, up) for low in lower for up in upper]
    found = point_within(rest, others)
    if found is None:
        return None
    least = [-_at(b, found) / b[1][column] for b in lower]
    most = [-_at(b, found) / b[1][column] for b in upper]
    return found | {column: _between(max(least, default=None), min(most, default=None))}


def _without(column: int, low: Bound, up: Bound) -> Bound:
    """What two bounds say together, without one unknown."""
    a, b = low[1][column], -up[1][column]
    slopes = {k: b * low[1].get(k, ZERO) + a * up[1].get(k, ZERO) for k in sorted({*low[1], *up[1]}) if k != column}
    return b * low[0] + a * up[0], {k: s for k, s in slopes.items() if s}


def _at(bound: Bound, found: dict[int, Decimal]) -> Decimal:
    """The value of a bound with what is known, without the unknown at hand."""
    value, slopes = bound
    return value + sum((slopes[k] * v for k, v in found.items() if k in slopes), ZERO)


def _between(least: Decimal | None, most: Decimal | None) -> Decimal:
    if (least is None or least < 0) and (most is None or most > 0):
        return ZERO
    if least is not None and most is not None:
        return (least + most) / 2
    return least + abs(least) + ONE if least is not None else (most or ZERO) - abs(most or ZERO) - ONE
