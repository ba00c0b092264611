"""Closed answers are short in their angles, and no bars stand round what is positive."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.report.answers.plain_answers import is_positive, plainest
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.shorter_angles import shorter

g, mu, beta, d, h, v, phi, theta = sp.symbols("g mu beta d h v phi theta", positive=True)
half, root = sp.atan(d / h) / 2, sp.sqrt(d**2 + h**2)
SLOPE = sp.sin(theta) - sp.tan(beta) * sp.cos(theta)
NUMBERS = {g: 9.8, mu: 0.3, beta: 0.7, d: 2.0, h: 1.1, v: 3.0, phi: 0.4, theta: 1.1}


@pytest.mark.parametrize(
    ("long", "short"),
    [
        (
            g / (mu * sp.sin(beta) ** 2 + sp.sin(2 * beta) / 2) - g / sp.tan(beta),
            g * (sp.sin(beta) - mu * sp.cos(beta)) / (mu * sp.sin(beta) + sp.cos(beta)),
        ),
        (d * sp.sqrt(root) * sp.sqrt(g / (d**2 - 2 * h * sp.sin(half) ** 2 * root)), sp.sqrt(g * (h + root))),
        (sp.cot(half), (h + root) / d),
        (
            sp.cos(phi / 2 + sp.pi / 4)
            * (sp.sin(phi / 2 + sp.pi / 4) - sp.tan(phi) * sp.cos(phi / 2 + sp.pi / 4))
            / sp.cos(phi),
            1 / (2 * (1 + sp.sin(phi))),
        ),
        (2 * v * SLOPE / g, 2 * v * sp.sin(theta - beta) / (g * sp.cos(beta))),
    ],
)
def test_a_formula_of_angles(long: sp.Expr, short: sp.Expr) -> None:
    found = shorter(long)
    assert sp.count_ops(found) <= sp.count_ops(short) + 1
    assert float(found.subs(NUMBERS)) == pytest.approx(float(long.subs(NUMBERS)))
    assert not found.has(sp.atan)


def test_what_is_short_already_stays() -> None:
    kept = g * (mu * sp.cos(beta) + sp.sin(beta)) / (sp.cos(beta) - mu * sp.sin(beta))
    assert shorter(kept) == kept


def test_a_sum_stands_below_rather_than_a_difference() -> None:
    """The sign is seen: -6 g sin² β / (L (1 + 3 sin² β)), and not 6 g sin² β / (L (3 cos² β - 4))."""
    expr = -6 * g * sp.sin(beta) ** 2 / (d * (1 + 3 * sp.sin(beta) ** 2))
    for other in (expr, expr.xreplace({1 + 3 * sp.sin(beta) ** 2: 4 - 3 * sp.cos(beta) ** 2})):
        assert shorter(other) == expr


@pytest.mark.parametrize(
    ("expr", "positive"),
    [
        (mu * sp.cos(beta) + sp.sin(beta), True),
        (1 + sp.sin(phi), True),
        (1 - sp.sin(phi), True),
        (sp.sin(beta) - mu * sp.cos(beta), False),
        (d - h, False),
    ],
)
def test_what_is_positive_for_acute_angles(expr: sp.Expr, positive: bool) -> None:
    assert is_positive(expr, {mu, beta, phi, d, h}) is positive


@pytest.mark.parametrize(
    ("steeper", "flatter"), [(theta, beta), (beta, theta)], ids=["as SymPy orders them", "the other way"]
)
def test_the_sine_of_a_difference_that_is_assumed_positive(steeper: sp.Expr, flatter: sp.Expr) -> None:
    """A throw up a slope, in letters that SymPy puts in either order: no bars, and no minus sign."""
    slope = SLOPE.xreplace({theta: steeper, beta: flatter})
    expr = 2 * v**2 * sp.Abs(sp.cos(steeper) * slope / sp.cos(flatter)) / g
    value = Valuation({s: Decimal(str(x)) for s, x in {**NUMBERS, steeper: 1.1, flatter: 0.7}.items()})
    a, b = steeper.name, flatter.name
    found = plain(plainest(expr, set(NUMBERS), value, (steeper - flatter,)))
    assert found.replace("θ", "theta").replace("β", "beta") == f"2 v² sin({a} - {b}) cos {a} / (g cos² {b})"
    assert plainest(expr, set(NUMBERS), value).has(sp.Abs)


def test_a_sum_of_fractions_is_one_where_that_is_shorter() -> None:
    value = Valuation({s: Decimal(str(x)) for s, x in NUMBERS.items()})
    found = plainest((d * g + 2 * d * v - h * g) / (d + h) - v, set(NUMBERS), value)
    assert found == (d - h) * (g + v) / (d + h)
    for kept in (v - d * g / (d + h), v**2 / (2 * d) - g, 1 / d + 1 / h):
        assert plainest(kept, set(NUMBERS), value) == kept
