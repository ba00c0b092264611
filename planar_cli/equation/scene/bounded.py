"""Where coordinates that are sought are drawn: where the inequalities of the instant put them.

Which way a spring pulls, or on which side something lies, is decided at drawn numbers: `y < 0` says where.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk

NEAR, FAR = Decimal("0.5"), Decimal(2)
"""So far from a single bound, in ordinary sizes."""
INSIDE = Decimal("0.3")
"""So far from both ends, in parts of an interval."""
TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}

Range = tuple[Decimal, Decimal]


def ranges(ledger: Ledger, evaluator: Evaluator, inequalities: Iterable[Relation]) -> dict[str, Range]:
    """From where to where coordinates are drawn, by name, as far as inequalities between them and numbers tell. One
    below another that is bounded is drawn below it.
    """
    found: dict[str, Range] = {}
    told = [(r.operator, r.left, r.right) for r in inequalities]
    told += [(TURNED[operator], right, left) for operator, left, right in told]
    lengths = [s for s in ledger.coordinates if s in ledger.sought and not ledger.units[s].angle]
    for _ in lengths:
        for symbol in lengths:
            low, high = _bounds(symbol, told, ledger, evaluator, found)
            if low is not None or high is not None:
                found[symbol.name] = _between(low, high, ledger.natural(symbol))
    return found


def _bounds(
    symbol: sp.Symbol,
    told: list[tuple[str, Side, Side]],
    ledger: Ledger,
    evaluator: Evaluator,
    known: dict[str, Range],
) -> tuple[Decimal | None, Decimal | None]:
    """The largest lower and the smallest upper bound of a coordinate."""
    below: list[Decimal] = []
    above: list[Decimal] = []
    for operator, one, other in told:
        if isinstance(one, Name) and one.name == symbol.name:
            rises = operator.startswith(">")
            (below if rises else above).extend(_number(other, rises, ledger, evaluator, known))
    return max(below, default=None), min(above, default=None)


def _number(
    side: Side, rises: bool, ledger: Ledger, evaluator: Evaluator, known: dict[str, Range]
) -> Iterator[Decimal]:
    """The value of a side of numbers, or the nearer end of another coordinate's range."""
    if isinstance(side, Name) and side.name in known:
        yield known[side.name][1 if rises else 0]
    elif not any(isinstance(n, Quantity) or (isinstance(n, Name) and n.name == "t") for n in walk(side)):
        expr = sp.sympify(evaluator.value(side))
        while inside := {s: ledger.values[s] for s in expr.free_symbols if s in ledger.values}:
            expr = expr.xreplace(inside)
        value = None if expr.free_symbols else Valuation({}).known(expr)
        if value is not None:
            yield value


def _between(low: Decimal | None, high: Decimal | None, size: Decimal) -> Range:
    """Inside an interval, or beside the one bound that there is."""
    if low is not None and high is not None:
        return low + (high - low) * INSIDE, high - (high - low) * INSIDE
    if low is not None:
        return low + NEAR * size, low + FAR * size
    assert high is not None
    return high - FAR * size, high - NEAR * size
