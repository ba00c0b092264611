"""Equations of several unknowns brought to one: by resultants, and where one holds on a whole stretch."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.instant.branches import holds_between
from planar_cli.solve.instant.elimination import Pending, combined, eliminate, subtracted

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


def test_squares_of_one_unknown_that_cancel() -> None:
    """Also where their factor is a sum; not where it holds another unknown, or another power is there."""
    factor = (a + b) * x**2
    pool = [Pending(factor + y - 1, (1,)), Pending(3 * x**2 + 2 * y - a, (2,))]
    made = subtracted(pool, [x, y], NUMBERS)
    assert made is not None
    assert x not in made[-1].residual.free_symbols
    assert sp.expand(made[-1].residual - (3 * (y - 1) - (a + b) * (2 * y - a))).equals(0)
    for other in (x**2 * y, x**3 + x**2, sp.sin(x) * x**2, x**2 + 1 / x):
        assert subtracted([pool[0], Pending(other - a, (2,))], [x, y], NUMBERS) is None


def test_a_positive_unknown_that_stands_in_squares() -> None:
    t = sp.Symbol("t", positive=True)
    step = eliminate([Pending(t**4 - sp.exp(y), (1,)), Pending(t**2 * sp.cos(y) - 1, (2,))], [t, y], [t], NUMBERS, [t])
    assert step is not None
    assert step.line.symbol == t
    assert step.line.formula == sp.sqrt(1 / sp.cos(y))
