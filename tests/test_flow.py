"""Solutions of differential equations against closed forms, and the digits claimed for them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import Any

import mpmath
import pytest

from planar_cli.calculus.first import first_extreme, first_root
from planar_cli.calculus.flow import Flow, Leaves


def swing(t: Any, y: Sequence[Any]) -> list[Any]:
    return [y[1], -y[0]]


def sun(t: float, y: Sequence[float]) -> list[float]:
    x, z, u, v = y
    cube = (x * x + z * z) ** 1.5
    return [u, v, -x / cube, -z / cube]


def forced(t: Any, y: Sequence[Any]) -> list[Any]:
    return [y[1], -y[0] + 2 * (math.cos(t) if isinstance(t, float) else mpmath.cos(t))]


Case = tuple[Callable[..., list[Any]], list[int | str], Callable[[Any], tuple[Any, ...]], tuple[float, ...]]
TIMES = (0.1, 1.7, 5.0, 11.3, -3.3)
CASES: dict[str, Case] = {
    "oscillator": (swing, [1, 0], lambda t: (mpmath.cos(t), -mpmath.sin(t)), TIMES),
    "decay": (lambda t, y: [-y[0]], [1], lambda t: (mpmath.exp(-t),), TIMES),
    "unstable": (lambda t, y: [y[1], y[0]], [1, -1], lambda t: (mpmath.exp(-t), -mpmath.exp(-t)), (1, 5, 20)),
    "tangent": (lambda t, y: [1 + y[0] ** 2], [0], lambda t: (mpmath.tan(t),), (0.3, 1, 1.5, 1.57)),
    "logistic": (lambda t, y: [y[0] * (1 - y[0])], ["0.25"], lambda t: (1 / (1 + 3 * mpmath.exp(-t)),), TIMES),
    "resonance": (forced, [0, 0], lambda t: (t * mpmath.sin(t), mpmath.sin(t) + t * mpmath.cos(t)), TIMES),
    "drag": (lambda t, y: [-(y[0] ** 2)], [1], lambda t: (1 / (1 + t),), (1, 1e3, 1e6)),
}


@pytest.mark.parametrize("digits", [6, 10, 12, 13, 18, 25])
@pytest.mark.parametrize("case", CASES)
def test_the_claims_are_lower_bounds(case: str, digits: int) -> None:
    rhs, start, true, times = CASES[case]
    flow = Flow(rhs, 0, start, digits)
    for t in times:
        state, bounds, certain = flow.at(t), flow.error(t), flow.certain(t)
        with mpmath.workdps(50):
            right = true(mpmath.mpf(t))
            for a, b, bound in zip(state, right, bounds, strict=True):
                assert abs(mpmath.mpf(a) - b) <= bound
            if case in {"oscillator", "tangent", "logistic"}:
                size = max(1, *(abs(float(b)) for b in right))
                assert all(abs(mpmath.mpf(a) - b) <= size * 10.0**-certain for a, b in zip(state, right, strict=True))
        if case != "tangent":
            assert certain >= min(digits, 12) - 1 if digits <= 13 else certain >= digits - 1


def test_a_comet() -> None:
    start = [0.01, 0.0, 0.0, math.sqrt(1.99 / 0.01)]
    flow = Flow(sun, 0, start, 13)
    period = 2 * math.pi
    assert flow.at(period) == pytest.approx(start, rel=1e-7, abs=1e-7)
    assert flow.at(-period)[:2] == pytest.approx(start[:2], abs=1e-7)
    assert flow.at(math.pi / 2)[:2] == pytest.approx([-1.660325136181952, 0.1046815065561854], abs=1e-11)
    assert flow.certain(period) >= 6
    assert abs(flow.at(period)[1]) <= flow.error(period)[1]
    assert flow.stepper.spent < 40_000


def test_twenty_five_digits_in_few_evaluations() -> None:
    flow = Flow(swing, 0, [1, 0], 25)
    state = flow.at(10)
    assert flow.stepper.spent < 40_000
    with mpmath.workdps(40):
        assert abs(state[0] - mpmath.cos(10)) < mpmath.mpf(10) ** -25


def test_decimals_stay_decimals() -> None:
    flow = Flow(swing, Decimal(0), [Decimal(1), Decimal(0)], 30)
    state = flow.at(Decimal("2.5"))
    assert all(isinstance(a, Decimal) for a in state)
    with mpmath.workdps(45):
        assert abs(mpmath.mpf(str(state[0])) - mpmath.cos(2.5)) < mpmath.mpf(10) ** -29
    assert flow.certain(Decimal("2.5")) >= 29


def test_a_stiff_spring() -> None:
    flow = Flow(lambda t, y: [y[1], 9.81 - 1e10 * y[0]], 0, [0.0, 0.0], 12)
    assert flow.at(0.01)[0] == pytest.approx(4.293061261588e-10, rel=1e-9)
    with pytest.raises(ArithmeticError, match="given up"):
        Flow(lambda t, y: [y[1], 9.81 - 1e20 * y[0]], 0, [0.0, 0.0], 12, 50_000).at(10)


@pytest.mark.parametrize("second", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("metre", [1e-9, 1.0, 1e9])
def test_units_do_not_enter(metre: float, second: float) -> None:
    def pendulum(t: float, y: Sequence[float]) -> list[float]:
        return [y[1], -math.sin(y[0] / metre) * metre / second**2]

    flow = Flow(pendulum, 0, [2 * metre, 0.0], 12)
    place, speed = flow.at(10 * second)
    assert (place / metre, speed / metre * second) == pytest.approx((0.7131481806012, -1.5313085041358), rel=1e-11)
    assert flow.certain(10 * second) >= 11


def test_back_again() -> None:
    there = Flow(swing, 0, [1.0, 0.25], 12)
    back = Flow(swing, 20, there.at(20), 12)
    assert back.at(0) == pytest.approx([1.0, 0.25], rel=1e-11)
    assert there.at(-4.25) == pytest.approx(back.at(-4.25), rel=1e-11)


def test_repeated_questions_cost_nothing() -> None:
    flow = Flow(swing, 0, [1.0, 0.0], 12)
    grid = [k * 0.01 for k in range(1000)]
    first = [flow.at(t)[0] for t in grid]
    assert first == pytest.approx([math.cos(t) for t in grid], abs=1e-12)
    spent = flow.stepper.spent
    assert [flow.at(t)[0] for t in grid] == first
    assert flow.stepper.spent == spent


@pytest.mark.parametrize("digits", [12, 20])
def test_leaving_the_domain(digits: int) -> None:
    def rhs(t: Any, y: Sequence[Any]) -> list[Any]:
        return [-math.sqrt(1 - t) if isinstance(t, float) else -mpmath.sqrt(1 - t)]

    flow = Flow(rhs, 0, [1], digits)
    assert float(flow.at(0.999)[0]) == pytest.approx(1 / 3 + 2 / 3 * 0.001**1.5, rel=1e-11)
    for _ in range(2):
        with pytest.raises(Leaves, match="known up to t = 1") as caught:
            flow.at(1.5)
        assert float(caught.value.reached) == pytest.approx(1, abs=1e-11)
        assert caught.value.reached <= 1
    with pytest.raises(ArithmeticError):
        Flow(lambda t, y: [math.log(y[0])], 0, [-1.0], 12).at(1)


def test_becoming_infinite() -> None:
    flow = Flow(lambda t, y: [y[0] ** 2], 0, [1.0], 12)
    assert abs(flow.at(0.999)[0] - 1000) <= flow.error(0.999)[0]
    with pytest.raises(Leaves) as caught:
        flow.at(1.5)
    assert caught.value.reached == pytest.approx(1, rel=1e-9)


def test_an_unstable_equilibrium_claims_no_digits() -> None:
    flow = Flow(lambda t, y: [y[1], -9.81 * math.sin(y[0])], 0, [math.pi, 0.0], 12)
    assert flow.certain(60) == 0
    assert flow.certain(0.5) >= 8


def test_released_from_the_horizontal() -> None:
    flow = Flow(lambda t, y: [y[1], -9.81 * math.sin(y[0])], 0, [math.pi / 2, 0.0], 12)
    quarter = float(mpmath.ellipk(0.5)) / math.sqrt(9.81)
    root = first_root(lambda t: flow.at(t)[0], 0, scale=0.3)
    assert root is not None
    assert root.value == pytest.approx(quarter, rel=1e-11)
    fastest = first_extreme(lambda t: flow.at(t)[1], 0, scale=0.3)
    assert fastest is not None
    assert fastest.again
    assert fastest.value == pytest.approx(math.sqrt(2 * 9.81), rel=1e-11)
    assert fastest.at == pytest.approx(3 * quarter, rel=1e-9)


def test_nothing_moves() -> None:
    flow = Flow(lambda t, y: [0.0 * y[0], 0.0], 0, [0.0, 3.0], 12)
    assert flow.at(100) == [0.0, 3.0]
    assert flow.certain(100) >= 12
