"""Speeds that are sought at an instant: a resistance acts against them, whichever way they turn out to go."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve
from conftest import ROOT

from planar_cli.errors import NoSolution

FALL = """
title: Parachutist at his terminal speed
plane: vertical
given: {{m: 80 kg, c: 0.3 N*s^2/m^2}}
bodies: {{P: {{particle: [0, 0], mass: m}}}}
loads:
  - drag: {{body: P, magnitude: c*v(P).mag^2}}
instant: [a(P).y = 0, v(P).x = 0{more}]
find: {{v: v(P).y, a: a(P).x}}
"""
POWER = """
title: Top speed of a car of a given power
plane: horizontal
given: {m: 900 kg, P: 45 kW, c: 0.5 N*s^2/m^2}
bodies: {car: {particle: [0, 0], mass: m}}
joints:
  - guide: {body: car, along: 0 deg}
loads:
  - force: {body: car, magnitude: P/v(car).mag, angle: 0 deg}
  - drag: {body: car, magnitude: c*v(car).mag^2}
instant: [v(car).x > 0, a(car).x = 0]
find: {v: v(car).x}
"""
HILL = """
title: Cyclist who rolls down a hill against the wind
plane: vertical
given: {k: 4 N*s/m, c: 0.4 N*s^2/m^2}
points: {P: [0, 0]}
bodies: {rider: {particle: P, mass: 90 kg}}
joints:
  - guide: {point: P, along: -5 deg}
loads:
  - drag: {body: rider, magnitude: k*v(rider).mag + c*v(rider).mag^2}
instant: [a(P).along(-5 deg) = 0.2 m/s^2]
find: {v: v(P).along(-5 deg)}
"""


@pytest.mark.parametrize("more", ["", ", v(P).y < 0"])
def test_terminal_speed(more: str) -> None:
    found = solve(FALL.format(more=more))
    assert_close(found["v"], -math.sqrt(80 * 9.81 / 0.3))
    assert_close(found["a"], 0)


def test_top_speed_of_a_given_power() -> None:
    assert_close(solve(POWER)["v"], (45e3 / 0.5) ** (1 / 3))


def test_speed_at_which_the_acceleration_is_given() -> None:
    """m a = m g sin 5° - 4 v - 0.4 v²."""
    pull = 90 * (9.81 * math.sin(math.radians(5)) - 0.2)
    assert_close(solve(HILL)["v"], (-4 + math.sqrt(16 + 1.6 * pull)) / 0.8, digits=10)


STEADY = """
title: Cart that rolls on steadily
plane: horizontal
given: {c: 2 N*s^2/m^2, F: 50 N}
bodies: {cart: {particle: [0, 0], mass: 20 kg}}
joints:
  - guide: {body: cart, along: 0 deg}
loads:
  - force: {body: cart, magnitude: F, angle: 0 deg}
  - drag: {body: cart, magnitude: c*v(cart).mag^2}
instant: [equilibrium, v(cart).x > 0]
find: {v: v(cart).x}
"""


def test_equilibrium_of_what_moves() -> None:
    """Zero accelerations: F = c v²."""
    assert_close(solve(STEADY)["v"], 5)


def test_a_speed_that_nothing_tells_is_named_though_its_equations_are_wide() -> None:
    text = (ROOT / "problems/particles/can-driven-along-a-groove.yaml").read_text(encoding="utf-8")
    with pytest.raises(NoSolution, match=r"the velocities are open: nothing determines omega\(rod\)"):
        solve(text.replace("motion: [omega(rod) = 6 rad/s]", ""))
