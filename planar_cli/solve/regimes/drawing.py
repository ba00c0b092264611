"""Where coordinates are drawn: near the drawn position, and where the states of the file put them.

A general position is decided at drawn numbers (which way a spring pulls, on which side a wall is), so they must lie
where the motion goes: beside a value that a state gives, else between the bounds that states give.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from itertools import pairwise

import sympy as sp

from planar_cli.equation.scene.displacement import Displacement
from planar_cli.equation.system.setup import has_quantity
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import PlanarError
from planar_cli.problem.language.expression import Name, Relation, Side
from planar_cli.problem.scene.keys import Table, keys_of
from planar_cli.solve.instant.instant import Instant
from planar_cli.units import LENGTH

NEAR, FAR = Decimal("0.02"), Decimal("0.07")
"""So far from a value, in parts of the size of the scene or of a radian, coordinates are drawn."""
INSIDE = Decimal("0.3")
"""So far from both ends, in parts of an interval."""

Range = tuple[Decimal, Decimal]


def ranges(drawn: Instant, displacement: Displacement) -> dict[str, Range]:
    """Where coordinates are drawn, by name."""
    value = drawn.scene.valuations[0]
    sizes = [abs(value(e)) for p in drawn.scene.points.values() for e in (p.x, p.y)]
    size = max(sizes, default=Decimal(0)) or drawn.scene.ledger.scales.exact(LENGTH)
    found = {}
    for c in displacement.coordinates:
        if c.drawn is None or set(c.drawn.free_symbols) & set(drawn.scene.ledger.letters):
            continue
        found[c.symbol.name] = _beside(value(c.drawn), size if c.unit == "m" else Decimal(1))
    for symbol in drawn.scene.ledger.coordinates:
        own = _stated(drawn, symbol, value, size)
        if own is not None:
            found[symbol.name] = own
    acting = _while_tables_act(drawn, value)
    return found if acting is None else {**found, "t": acting}


def beside(drawn: Instant, displacement: Displacement) -> dict[str, tuple[sp.Expr, Decimal, Decimal]]:
    """Beside which formulas of letters coordinates are drawn, by name, and how far in parts of their size."""
    ledger = drawn.scene.ledger
    letters, known = set(ledger.letters), {*ledger.letters, *ledger.values}
    return {
        c.symbol.name: (c.drawn, NEAR, FAR)
        for c in displacement.coordinates
        if c.drawn is not None and c.drawn.free_symbols & letters and c.drawn.free_symbols <= known
    }


def _while_tables_act(drawn: Instant, value: Valuation) -> Range | None:
    """A span of time in which no table over time is zero all along, if there is one: what is zero at the time that is
    drawn would be left out.
    """
    tables = [getattr(load, s.name) for load in drawn.scene.problem.loads for s in keys_of(type(load))]
    found: Range | None = None
    for table in (t for t in tables if isinstance(t, Table)):
        times = [_number(drawn, when, value) for when, _ in table.rows]
        sizes = [_number(drawn, size, value) for _, size in table.rows]
        for (t0, v0), (t1, v1) in pairwise(zip(times, sizes, strict=True)):
            if t0 is None or t1 is None or (v0 == 0 and v1 == 0):
                continue
            low, high = (t0, t1) if found is None else (max(t0, found[0]), min(t1, found[1]))
            if low < high:
                found = low, high
                break
    return None if found is None else (found[0] + (found[1] - found[0]) * NEAR, found[1] - (found[1] - found[0]) * NEAR)


def _beside(at: Decimal, reach: Decimal, above: bool = True) -> Range:
    return (at + reach * NEAR, at + reach * FAR) if above else (at - reach * FAR, at - reach * NEAR)


def _stated(drawn: Instant, symbol: sp.Symbol, value: Valuation, size: Decimal) -> Range | None:
    """Beside the first value that a state gives, a zero last, on the side of the others; else between its bounds; None:
    states say nothing in numbers. `size`: of the scene [m], for what lies beside the origin of a length.
    """
    low: Decimal | None = None
    high: Decimal | None = None
    bounds = list(_bounds(drawn, symbol, value))
    given = [number for operator, number in bounds if operator == "="]
    angle = drawn.scene.ledger.units[symbol].text in ("rad", "deg", "rev")
    if first := next((number for number in given if number), None):
        return _beside(first, Decimal(1) if angle else abs(first), max(given) > first or min(given) == first)
    for operator, number in bounds:
        if operator == "=":
            continue
        if operator in (">", ">="):
            low = number if low is None else max(low, number)
        else:
            high = number if high is None else min(high, number)
    if low is not None and high is not None:
        return low + (high - low) * INSIDE, high - (high - low) * INSIDE
    if low is not None:
        return low + max(abs(low), Decimal(1)) * NEAR, low + max(abs(low), Decimal(1))
    if high is not None:
        return high - max(abs(high), Decimal(1)), high - max(abs(high), Decimal(1)) * NEAR
    length = drawn.scene.ledger.units[symbol].dimension == LENGTH
    return _beside(Decimal(0), size if length else Decimal(1)) if given and (angle or length) else None


def _bounds(drawn: Instant, symbol: sp.Symbol, value: Valuation) -> Iterator[tuple[str, Decimal]]:
    """Relations of states between a coordinate and a number, `x > 0`, from the side of the coordinate."""
    turned = {"=": "=", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
    for state in drawn.scene.problem.states:
        for r in state.relations:
            if not isinstance(r, Relation):
                continue
            for one, other, operator in ((r.left, r.right, r.operator), (r.right, r.left, turned[r.operator])):
                if isinstance(one, Name) and one.name == symbol.name and one.at is None:
                    number = _number(drawn, other, value)
                    if number is not None:
                        yield operator, number


def _number(drawn: Instant, side: Side, value: Valuation) -> Decimal | None:
    """A side that holds only names with numbers."""
    if has_quantity(side):
        return None
    ledger = drawn.scene.ledger
    try:
        expr = drawn.scene.value(side)
    except PlanarError:
        return None
    return None if expr.free_symbols & {*ledger.letters, *ledger.sought} else value.known(expr)
