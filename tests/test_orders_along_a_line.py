"""Bodies that balance along one line: the order in which they lie is tried where nothing tells it."""

from __future__ import annotations

import pytest
from answered import Answers, solve

from planar_cli.errors import NoSolution

HUNG = """plane: vertical
coordinates: {a: m, b: m}
points: {A: [0, 0]}
bodies:
  K: {particle: [0, -a]MASS}
  W: {particle: [0, -b], mass: 3 kg}
joints:
  - guide: {body: K, along: 90 deg}
  - guide: {body: W, along: 90 deg}
loads:
  - spring: {between: [A, K], stiffness: 200 N/m, natural_length: 0.4 m}
  - spring: {between: [K, W], stiffness: 300 N/m, natural_length: 0.4 m}
"""
AT_AN_INSTANT = HUNG + "instant: [equilibriumORDER]\nfind: {a: a, b: b}\n"
IN_A_STATE = HUNG + "states: {eq: [equilibriumORDER]}\nfind: {a: a @ eq, b: b @ eq}\n"
WALLS = """plane: horizontal
coordinates: {x1: m, x2: m}
points: {A: [0, 0], D: [3 m, 0]}
bodies: {B: {particle: [x1, 0], mass: 1 kg}, C: {particle: [x2, 0], mass: 1 kg}}
joints:
  - guide: {body: B, along: 0 deg}
  - guide: {body: C, along: 0 deg}
loads:
  - spring: {between: [A, B], stiffness: 100 N/m, natural_length: 0.8 m}
  - spring: {between: [B, C], stiffness: 100 N/m, natural_length: 0.8 m}
  - spring: {between: [C, D], stiffness: 200 N/m, natural_length: 0.8 m}
states: {eq: [equilibrium, x2 < 3 m]}
find: {x1: x1 @ eq, x2: x2 @ eq}
"""


def value(found: Answers, name: str) -> float:
    values = found[name].values
    assert values is not None
    return float(values[0])


@pytest.mark.parametrize("text", [AT_AN_INSTANT, IN_A_STATE])
@pytest.mark.parametrize(("mass", "upper"), [("", 0.0), (", mass: 1 kg", 1.0)])
def test_the_order_that_is_stated(text: str, mass: str, upper: float) -> None:
    """K hangs by (m_K + 3 kg) g / 200 N/m below the free length, W by 3 kg g / 300 N/m below that of its own spring."""
    found = solve(text.replace("MASS", mass).replace("ORDER", ", b > a"))
    a = 0.4 + (upper + 3) * 9.81 / 200
    assert value(found, "a") == pytest.approx(a)
    assert value(found, "b") == pytest.approx(a + 0.4 + 3 * 9.81 / 300)


@pytest.mark.parametrize("text", [AT_AN_INSTANT, IN_A_STATE])
def test_two_orders_in_which_it_balances(text: str) -> None:
    with pytest.raises(NoSolution) as told:
        solve(text.replace("MASS", "").replace("ORDER", ""))
    (diagnostic,) = told.value.diagnostics
    assert diagnostic.code == "PL630"
    assert "b = 0.2452 m where `a > b`; a = 0.5472 m, b = 1.045 m where `b > a`" in diagnostic.message
    assert diagnostic.hint == "say which is meant: `b > a`"


def test_the_only_order_in_which_it_balances() -> None:
    """All three springs pull with 24 N."""
    found = solve(WALLS)
    assert value(found, "x1") == pytest.approx(1.04)
    assert value(found, "x2") == pytest.approx(2.08)
