"""Equations of several unknowns brought to one: by resultants, and where one holds on a whole stretch."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.solve.instant.branches import holds_between
from planar_cli.solve.instant.elimination import Pending, combined

x, y, a, b = sp.symbols("x y a b", real=True)
NUMBERS = Valuation({}, {})


def test_what_holds_on_one_side_of_a_place() -> None:
    one_side = sp.Abs(x - 1) + x - 1
    assert holds_between(one_side, x, [Decimal(-2), Decimal(-1), Decimal(1)], NUMBERS)
    assert not holds_between(x**2 - 1, x, [Decimal(-1), Decimal(1)], NUMBERS)
    assert not holds_between(one_side, x, [Decimal(1)], NUMBERS)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (a * x**2 + b * y - 1, x**2 - y**2),
        (x**2 + x * y - a, b * x - y - 1),
        (sp.cos(a) * x**2 - y, x * y - sp.sin(a)),
    ],
)
def test_an_equation_without_the_other_unknown(one: sp.Expr, other: sp.Expr) -> None:
    """It vanishes wherever both equations hold, and has no root twice that they have once."""
    made = combined([Pending(one, (1,)), Pending(other, (2,))], [x, y], NUMBERS)
    assert made is not None
    found = made[0].residual
    (left,) = found.free_symbols & {x, y}
    gone = x if left == y else y
    whole = sp.resultant(one, other, gone)
    assert 0 < sp.degree(found, left) <= sp.degree(whole, left)
    assert sp.rem(sp.Poly(whole, left), sp.Poly(found, left)).is_zero
