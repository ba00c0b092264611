"""The reader of printed equations: a side of several formulas counts as a whole, a vector by its components."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

import pytest
import sympy as sp
from printed import Page

from planar_cli.report.document.blocks import Equation, Math, Value, line

x, y = sp.symbols("x y")
NUMBERS = {x: 0.5, y: 2.0}
SUM = line(Math(x), " - ", Math(y))
VECTOR = line("[1, ", Math(x), "]/", Math(sp.sqrt(1 + x**2)))


class _Known:
    def known(self, symbol: sp.Symbol) -> float | None:
        return NUMBERS.get(symbol)


def _vector(*numbers: str) -> Any:
    first, second = (Value(number=Decimal(n), unit="1", figures=4) for n in numbers)
    return line("[", first, ", ", second, "]")


@pytest.mark.parametrize(("left", "right", "holds"), [
    (SUM, Math(x - y), True),
    (SUM, Math(-y), False),
    (SUM, Math(x + y), False),
    (VECTOR, _vector("0.8944", "0.4472"), True),
    (VECTOR, _vector("0.8944", "0.5"), False),
    (VECTOR, _vector("0.5", "0.4472"), False),
])  # fmt: skip
def test_a_side_is_read_whole(left: Any, right: Any, holds: bool) -> None:
    numbers: Any = _Known()
    assert bool(Page(numbers).wrong(Equation((left, right)), 1e-3)) != holds
