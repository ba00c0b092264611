"""A constant that an equilibrium tells, as by its frequency, decides how the motion beside it runs."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

GUN = """
title: Gun that recoils
plane: horizontal
given: {{m: 600 kg, k: 30 kN/m, v_0: 8 m/s}}
unknowns: {{c: N*s/m}}
coordinates: {{x: m}}
points: {{O: [-3 m, 0], P: [x, 0]}}
bodies: {{gun: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [O, P], stiffness: k, relaxed_at: [x = 0]}}
  - damper: {{between: [O, P], coefficient: c}}
states:
  {states}
find: {{c: c, x: x @ far, t: t @ far}}
"""
NATURAL = math.sqrt(50)


def gun(first: str, *others: str) -> str:
    return GUN.format(states="\n  ".join([first, *others]))


@pytest.mark.parametrize("first", [True, False])
def test_critical_damping_beside_a_motion(first: bool) -> None:
    rest = "rest: [equilibrium, x = 0, frequency(rest) = 0]"
    motion = ["shot: [t = 0, x = 0, v(gun).x = v_0]", "far: [x is largest]"]
    found = solve(gun(*([rest, *motion] if first else [*motion, rest])))
    assert_close(found["c"], 2 * 600 * NATURAL)
    assert_close(found["t"], 1 / NATURAL)
    assert_close(found["x"], 8 / NATURAL / math.e)


def test_a_frequency_beside_a_motion() -> None:
    """Half a swing a second: the damped frequency is pi, and the turning point lies where its speed vanishes."""
    found = solve(gun("rest: [equilibrium, frequency(rest) = 0.5 Hz]", "shot: [t = 0, x = 0, v(gun).x = v_0]",
                      "far: [x is largest]"))  # fmt: skip
    decay = math.sqrt(50 - math.pi**2)
    turned = math.atan(math.pi / decay) / math.pi
    assert_close(found["c"], 2 * 600 * decay)
    assert_close(found["t"], turned)
    assert_close(found["x"], 8 / math.pi * math.exp(-decay * turned) * math.sin(math.pi * turned))
