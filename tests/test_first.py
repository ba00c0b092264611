"""The first instant: roots and grazing contacts of functions of time, against closed forms."""

from __future__ import annotations

import math
from collections.abc import Callable
from decimal import Decimal
from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_cli.calculus.first import Root, all_roots, roots
from planar_cli.calculus.polish import polish
from planar_cli.equation.values.exact import FUNCTIONS, PI

sin, cos, exp = math.sin, math.cos, math.exp
exact_sin, exact_cos = FUNCTIONS[sp.sin], FUNCTIONS[sp.cos]
Function = Callable[[float], float]


def first_root(g: Function, after: float, horizon: float | None = None, **more: Any) -> Root | None:
    return next(roots(g, after, horizon, **more), None)


@pytest.mark.parametrize(
    ("g", "after", "root"),
    [
        (sin, 0, math.pi),
        (sin, math.pi, 2 * math.pi),
        (lambda t: sin(1e6 * t), 0, math.pi / 1e6),
        (lambda t: sin(1e-6 * t), 0, math.pi * 1e6),
        (lambda t: t * t - 2 * t, 0, 2),
        (lambda t: t * t * (t - 3), 0, 3),
        (lambda t: t * t - 1e-6 * t, 0, 1e-6),
        (lambda t: t - 5, -3, 5),
        (lambda t: t - 1e9, 0, 1e9),
        (lambda t: exp(-1e6 * t) + 5 - t, 0, 5),
        (lambda t: 1e20 * exp(-t) + 1e-3 * (t - 100), 0, 49.0281842920746),
        (lambda t: 1 / (1 + ((t - 5) / 0.001) ** 2) - 0.5, 0, 4.999),
        (lambda t: math.sqrt(sin(t)) - 0.5, 1, math.pi - math.asin(0.25)),
        (math.tan, 1, math.pi),
    ],
)
def test_crossings(g: Function, after: float, root: float) -> None:
    found = first_root(g, after)
    assert found is not None
    assert found.kind == "crossing"
    assert found.value == pytest.approx(root, rel=2e-15, abs=0)
    assert found.low < root < found.high


@pytest.mark.parametrize(
    "g",
    [
        lambda t: t * t + 1e-3,
        lambda t: exp(-t),
        lambda t: 1 - math.tanh(t),
        lambda t: 2 + sin(t),
        lambda t: 2.1 + sin(t) + sin(math.sqrt(2) * t),
        lambda t: 1 / (t - 1),
        lambda t: -1.0 if t < 1 else 1.0,
        lambda t: 3.0,
        lambda t: math.log(2 + t),
    ],
)
def test_no_root(g: Function) -> None:
    assert first_root(g, 0) is None


@pytest.mark.parametrize("after", [math.nextafter(2, 0), 2.0, math.nextafter(2, 3)])
def test_a_root_at_the_beginning_does_not_count(after: float) -> None:
    assert first_root(lambda t: t * t - 2 * t, after) is None


def test_zero_all_along_is_said() -> None:
    assert (root := first_root(lambda t: 0.0, 1)) is not None
    assert (root.value, root.kind) == (1, "stays")
    root = first_root(lambda t: sin(t) ** 2 + cos(t) ** 2 - 1, 0, size=1)
    assert root is not None
    assert root.kind == "stays"
    with pytest.raises(ArithmeticError, match="noise"):
        first_root(lambda t: sin(t) ** 2 + cos(t) ** 2 - 1, 0)


def test_edge_of_the_domain() -> None:
    root = first_root(lambda t: math.sqrt(1 - t), 0)
    assert root is not None
    assert (root.value, root.kind) == (1, "edge")
    assert first_root(lambda t: 1 + math.sqrt(1 - t), 0) is None


def test_a_horizon() -> None:
    assert first_root(sin, 0, 3.1) is None
    assert first_root(sin, 0, 3.0, scale=0.1) is None
    root = first_root(lambda t: t - 5, 0, 5)
    assert root is not None
    assert root.value == 5
    touch = first_root(lambda t: (t - 5) ** 2, 0, 6)
    assert touch is not None
    assert touch.value == pytest.approx(5, rel=1e-12)
    assert touch.kind == "touch"
    assert first_root(sin, 2, 1) is None
    with pytest.raises(ArithmeticError, match="too fast"):
        first_root(lambda t: 2 + sin(1e6 * t), 0, 1e6, evaluations=50_000)


V, G = 10.0, 9.81
PEAK = math.atan(100)


def ceiling(delta: float) -> Function:
    height = V * V / 2 / G - delta
    return lambda t: height - (V * t - G * t * t / 2)


@pytest.mark.parametrize("delta", [1e-3, 1e-6, 1e-8, 1e-10])
def test_two_contacts_with_a_ceiling(delta: float) -> None:
    first, second = all_roots(ceiling(delta), 0, 2)
    assert {first.kind, second.kind} == {"crossing"}
    apart = 2 * math.sqrt(2 * delta / G)
    assert second.value - first.value == pytest.approx(apart, rel=1e-14 / delta + 1e-12)
    again = first_root(ceiling(delta), first.value)
    assert again is not None
    assert again.value - first.value == pytest.approx(apart, rel=1e-14 / delta + 1e-12)
    assert again.low < second.value < again.high


def test_grazing_and_missing() -> None:
    (root,) = all_roots(ceiling(0), 0, 2)
    assert root.kind == "touch"
    assert root.value == pytest.approx(V / G, rel=1e-12)
    assert first_root(ceiling(0), root.value) is None
    assert first_root(ceiling(-1e-6), 0) is None
    assert first_root(ceiling(-1e-8), 0) is None


@pytest.mark.parametrize("rate", [1e-7, 1.0, 1e7])
def test_a_double_root_at_the_beginning_and_again(rate: float) -> None:
    root = first_root(lambda t: 1 - cos(rate * t), 0)
    assert root is not None
    assert root.kind == "touch"
    assert rate * root.value == pytest.approx(2 * math.pi, rel=1e-12)


def test_all_roots() -> None:
    assert len(all_roots(lambda t: exp(-t) * cos(10 * t), 0, 100, limit=1000)) == 318
    assert len(all_roots(lambda t: sin(t * t), 0, 30, limit=1000)) == 286
    found = all_roots(lambda t: sin(1 / t), 0.01, 1)
    assert [r.value for r in found] == pytest.approx([1 / (k * math.pi) for k in range(31, 0, -1)], rel=1e-13)
    assert len(all_roots(sin, 0, 1e4, limit=7)) == 7


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.floats(0.05, 9.9), min_size=1, max_size=5, unique_by=lambda x: round(x, 2)),
    st.sampled_from([1e-9, 1e-3, 1.0, 1e6]),
)
def test_no_root_of_a_product_is_skipped(zeros: list[float], unit: float) -> None:
    def g(t: float) -> float:
        return math.prod(sin((t / unit - z) / 7) for z in zeros) * exp(-t / unit)

    found = [r.value / unit for r in all_roots(g, 0, 10 * unit)]
    assert found == pytest.approx(sorted(zeros), rel=1e-8)
    first = first_root(g, 0, scale=unit)
    assert first is not None
    assert first.value / unit == pytest.approx(min(zeros), rel=1e-8)


@pytest.mark.parametrize(
    ("g", "approximate", "root"),
    [
        (exact_sin, sin, PI),
        (lambda t: 1 - exact_cos(t), lambda t: 1 - cos(t), 2 * PI),
        (lambda t: t * t - 2, lambda t: t * t - 2, Decimal(2).sqrt()),
    ],
)
def test_polish(g: Callable[[Decimal], Decimal], approximate: Function, root: Decimal) -> None:
    found = first_root(approximate, 0)
    assert found is not None
    assert abs(polish(g, found.low, found.high) / root - 1) < Decimal("1e-48")


@pytest.mark.parametrize("delta", ["1e-3", "1e-6", "1e-9", "1e-11", "1e-12", "1e-14", "0"])
def test_polish_tells_grazing_apart(delta: str) -> None:
    d, g = Decimal(delta), Decimal("9.81")
    found = first_root(ceiling(float(delta)), 0)
    assert found is not None
    root = polish(lambda t: 50 / g - d - (10 * t - g * t * t / 2), found.low, found.high)
    assert abs(root * g / (10 - (2 * g * d).sqrt()) - 1) < Decimal("1e-45")
    if found.kind == "touch":
        with pytest.raises(ArithmeticError, match="no root"):
            polish(lambda t: 50 / g + Decimal("1e-20") - (10 * t - g * t * t / 2), found.low, found.high)
