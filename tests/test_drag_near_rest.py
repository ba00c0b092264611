"""A drag that grows with the speed damps small oscillations; one that grows with its square does not."""

from __future__ import annotations

from math import pi, sqrt

import pytest
from answered import assert_close, solve

BLOCK = """
plane: horizontal
given: {m: 8 kg, k: 157 N/m, c: 6 N*s/m, q: 3 kg/m}
coordinates: {x: m}
points: {W: [-1 m, 0], P: [x, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: 1 m}
  - drag: {body: block, DRAG}
states: {rest: [equilibrium, x = 0]}
find: {T: period(rest)}
"""
PENDULUM = """
plane: vertical
given: {m: 8 kg, L: 0.5 m, c: 6 N*s/m}
coordinates: {phi: deg}
points: {O: [0, 0], P: {from: O, distance: L, angle: phi - 90 deg}}
bodies: {bob: {particle: P, mass: m}}
joints:
  - link: {between: [O, P]}
loads:
  - drag: {body: bob, linear: c}
states: {rest: [equilibrium, phi = 0]}
find: {T: period(rest)}
"""


@pytest.mark.parametrize(
    ("drag", "c"),
    [("linear: c", 6), ("magnitude: c*v(block).mag", 6), ("quadratic: q", 0), ("linear: c, quadratic: q", 6)],
)
def test_block(drag: str, c: float) -> None:
    assert_close(solve(BLOCK.replace("DRAG", drag))["T"], 2 * pi / sqrt(157 / 8 - (c / 16) ** 2), 9)


def test_pendulum() -> None:
    assert_close(solve(PENDULUM)["T"], 2 * pi / sqrt(9.81 / 0.5 - (6 / 16) ** 2), 9)


def test_critical_damping() -> None:
    text = BLOCK.replace("DRAG", "linear: b").replace("find: {T: period(rest)}", "find: {b: b}")
    text = text.replace("coordinates:", "unknowns: {b: N*s/m}\ncoordinates:").replace(
        "x = 0]", "x = 0, frequency(rest) = 0]"
    )
    assert_close(solve(text)["b"], 2 * sqrt(8 * 157), 9)
