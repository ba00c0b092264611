"""Products multiplied out, factors and counts of operations: as SymPy has them, at another price."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import factor_terms, together
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.machine import compiled
from planar_cli.equation.algebra.plain import identically_zero, letters, replaced, simplified

m, k, n = sp.symbols("m k n", positive=True)
u, v, w = sp.symbols("u v w", real=True)
HALF = sp.Rational(1, 2)


def sums(depth: int) -> st.SearchStrategy[sp.Expr]:
    """Sums, products, powers and roots of letters, numbers, sines and cosines."""
    leaf = st.sampled_from([m, k, n, u, v, sp.sin(u), sp.cos(u), sp.cos(u + v), sp.sqrt(2), sp.pi, sp.S(1), sp.S(-3)])
    leaf = leaf | st.builds(sp.Rational, st.integers(-6, 6), st.integers(1, 4))
    below = leaf if depth == 0 else leaf | sums(depth - 1)
    several = st.lists(below, min_size=2, max_size=3)
    powers = st.builds(
        lambda a, p: a if a == 0 else a**p, below, st.sampled_from([2, 3, -1, -2, HALF, -HALF, 3 * HALF])
    )
    return several.map(lambda parts: sp.Add(*parts)) | several.map(lambda parts: sp.Mul(*parts)) | powers


def same(one: sp.Expr, other: sp.Expr) -> bool:
    place = {m: sp.Rational(7, 5), k: sp.Rational(3, 7), n: sp.Rational(11, 4), u: sp.Rational(4, 9), v: -HALF, w: 2}
    first, second = (sp.N(e.xreplace(place), 40) for e in (one, other))
    return bool(first == second) or abs(first - second) <= sp.Float("1e-30") * (1 + abs(second))


@given(sums(2))
@settings(max_examples=60)
def test_expanded_has_the_value_and_no_product_left(expr: sp.Expr) -> None:
    found = expanded(expr)
    if found.has(sp.nan, sp.zoo):
        return
    assert same(found, expr)
    for term in sp.Add.make_args(found):
        assert not any(f.is_Add or (f.is_Pow and f.base.is_Add and f.exp >= 1) for f in sp.Mul.make_args(term))


@pytest.mark.parametrize(
    "expr",
    [
        (u + v) ** 2 * (u - v),
        m * (u + v) / (k * (m + k)),
        sp.sqrt(m * k * (u**2 + v**2)) * sp.sqrt(u**2 + v**2),
        (u**2 + v**2) ** (3 * HALF),
        1 / (u**2 + v**2) ** (3 * HALF),
        sp.sin(u * (v + 1)) * (1 + sp.cos(u)),
        ((u + 1) / (v + 1) + m) / (u + 1),
        sp.exp(u + v) * (u + v),
        sp.log(m * k) * (u + v),
        sp.Piecewise((u * (v + 1), u > 0), (v, True)),
        1.5 * u * (v + 2),
        sp.I * (u + v) ** 2,
    ],
)
def test_expanded_is_what_sympy_finds(expr: sp.Expr) -> None:
    assert expanded(expr) == sp.expand(expr)


def test_an_angle_that_holds_a_root_of_an_angle_keeps_no_letter() -> None:
    expr = sp.sqrt(sp.sin(u)) * sp.tan(w * sp.sqrt(sp.sin(u)) - sp.atan(k / sp.sqrt(sp.sin(u)))) * sp.cos(v)
    found = simplified(expr)
    assert found.free_symbols == expr.free_symbols
    assert simplified(found - expr) == 0


def test_terms_over_one_sum_are_found_to_cancel() -> None:
    assert expanded((u + v) / (4 * (m + k) ** 3) - u / (4 * (m + k) ** 3) - v / (2 * (m + k) ** 3) / 2) == 0
    assert expanded(u * (v + 2) / 2 / (m + k) - u * v / 2 / (m + k)) == u / (m + k)


FACTORED = [
    m * u + k * u,
    m**2 - k**2,
    u**2 * m - u**2 * k + 2 * m - 2 * k,
    (m * u + k) * (v * n - m) * (u + 2 * v),
    -((k * (n * sp.cos(u) + m - HALF)) ** 2) / 2,
    (1 - sp.sin(u) ** 2) * sp.cos(u),
    u**3 - v**3,
    u**4 + 4,
    sp.sqrt(m**2 - u**2) * 3,
    (2 * m**2 - 2 * k**2) ** (-3 * HALF),
    m**k - m ** (2 * k),
    1.5 * u + 3.0 * u * v,
    sp.I * u + sp.I,
    sp.sqrt(2) + 1,
    2 * sp.sqrt(2) + 2,
    sp.pi * u + sp.pi**2,
    u / 3 - v / 3 * sp.sin(w),
    sp.exp(2 * u) - sp.exp(2 * v),
    sp.S(0),
    sp.S(5),
    u,
]


@pytest.mark.parametrize("expr", FACTORED)
def test_factored_is_what_sympy_finds(expr: sp.Expr) -> None:
    for form in (expr, sp.expand(expr)):
        assert factored(form) == sp.factor(form)


@given(st.lists(sums(1).filter(lambda e: not e.has(sp.nan, sp.zoo)), min_size=1, max_size=2))
@settings(max_examples=30, deadline=None)
def test_factors_have_the_value(parts: list[sp.Expr]) -> None:
    whole = sp.Mul(*parts)
    assert same(factored(expanded(whole)), whole)


def test_a_sum_that_is_a_number_has_no_factors() -> None:
    assert factored((1 - sp.sin(u) ** 2) ** 2 - sp.sin(u) ** 4 + 2 * sp.sin(u) ** 2 - 2) == -1


def test_a_long_polynomial_of_high_degree_is_left() -> None:
    """SymPy's factoring has no bound; here what no letter decides is given to it only while it is short."""
    letters = sp.symbols("a b c d e f", real=True)
    whole = sp.expand(sum(x**3 for x in letters) ** 2 + sum(letters) ** 4 + 1)
    assert factored(whole) == whole


@given(sums(2))
@settings(max_examples=60)
def test_operations_are_counted_as_sympy_counts(expr: sp.Expr) -> None:
    for form in (expr, -expr, 2 * expr, 1 / expr if expr != 0 else expr):
        if not form.has(sp.nan, sp.zoo):
            assert operations(form) == sp.count_ops(form)


def test_what_only_a_common_denominator_shows_to_be_zero() -> None:
    assert identically_zero(u / (u + v) + v / (u + v) - 1)
    assert not identically_zero(u / (u + v) + v / (u + v) - 2)


SHARED = [
    m * u + m * v,
    2 * m * u / 3 - 4 * m * v / 9,
    -m * u - k,
    u / 2 + 1,
    (2 * u + 4 * v) ** 3 * m + (u + 2 * v) * k,
    m / (k + n) + u / (k * (k + n)) - 1,
    sp.sqrt(2 * m * u**2 + 4 * m * v**2) / (2 * k) + sp.sqrt(k) * m,
    m * sp.sin(2 * u + 2 * v) + m * sp.cos(u) / k,
    1 / (1 / m + 1 / k),
    sp.exp(-(u + 2)) * m + m,
    sp.Piecewise((m * u + m, u > 0), (v, True)),
    1.5 * u + 3.0 * m * u,
    sp.Abs(sp.sqrt(2 * m * k * (u**2 + 1))) + sp.S(1) / 2,
    m * (v - u) - k * (v - u) ** 2 / 2,
    m * (v - u) / 3 - k * (v - u) ** 2 / 2 + (v - u) / (u + w),
]


@pytest.mark.parametrize("expr", [*SHARED, *FACTORED])
def test_common_factors_and_fractions_are_what_sympy_finds(expr: sp.Expr) -> None:
    assert factor_terms(expr) == sp.factor_terms(expr)
    assert together(expr) == sp.together(expr)
    assert cancelled(expr) == sp.cancel(expr)


@given(sums(2))
@settings(max_examples=60)
def test_common_factors_and_fractions_of_any_expression(expr: sp.Expr) -> None:
    if not expr.has(sp.nan, sp.zoo):
        assert factor_terms(expr) == sp.factor_terms(expr)
        assert together(expr) == sp.together(expr)
        assert same(cancelled(expr), expr)


def test_roots_below_the_stroke_are_no_letters_of_their_own() -> None:
    """SymPy brings the square of a root above the stroke, and what was one fraction becomes many terms."""
    root = sp.sqrt(m**2 + 2 * m * n * sp.sin(u) - 2 * n**2 * sp.cos(u) + 2 * n**2)
    whole = k * (m**2 * sp.cos(u) / (n * root) + m * sp.sin(u) / root - m * sp.cos(u) / n - sp.sin(u))
    assert operations(cancelled(whole)) < operations(sp.cancel(whole))


# --- formulas put together of others ----------------------------------------------------------------------------------


def nested(levels: int) -> sp.Expr:
    """A formula with few distinct parts, which as a tree has 3 to the power of `levels` leaves."""
    whole = u
    for _ in range(levels):
        whole = sp.sin(whole) / (1 + whole**2 * sp.cos(whole))
    return whole


def test_machine_code_has_the_values_of_the_formulas() -> None:
    exprs = [
        u**2 + v / 3,
        sp.sqrt(m * k) / (m + k) ** 2,
        (m + 1) ** (3 * HALF) * (u + 1) ** -3,
        sp.sin(u) * sp.Abs(-v) + sp.sign(-v),
        sp.atan2(u, v) + sp.pi,
        m**u * sp.exp(-v) * sp.E,
        sp.Max(u, v, 2),
        sp.Piecewise((u, u > 0), (sp.sqrt(-u), True)),
        sp.S(3),
        w * u,
    ]
    place = {m: 1.3, k: 0.7, u: 0.4, v: -1.7, w: -2.5}
    for group in (exprs, exprs[:7]):
        numbers = compiled(group, [m, k, u, v], lambda s: place[s])(*(place[s] for s in (m, k, u, v)))
        for expr, number in zip(group, numbers, strict=True):
            assert number == pytest.approx(float(expr.subs(place)), rel=1e-14)


def test_machine_code_of_nothing() -> None:
    assert list(compiled([], [u])(1.0)) == []


def test_what_occurs_many_times_is_worked_out_once() -> None:
    whole = nested(40)
    (number,) = compiled([whole], [u])(0.7)
    again = 0.7
    for _ in range(40):
        again = math.sin(again) / (1 + again**2 * math.cos(again))
    assert number == pytest.approx(again, rel=1e-12)
    assert letters(whole) == {u}
    assert letters(replaced(whole, {u: v + w})) == {v, w}


def test_a_formula_that_would_fill_pages_is_left() -> None:
    whole = sp.Mul(*(m + sp.Symbol(f"x_{i}", real=True) * sp.cos(u + i) for i in range(16)))
    assert wide(whole)
    assert simplified(whole) == whole
    assert not wide((m + k * sp.cos(u)) ** 3 / (m + k))
