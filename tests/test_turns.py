"""Angles of places count turns from the first state, as angles of bodies do."""

from __future__ import annotations

import math
from math import pi

import pytest
from answered import assert_close, first, solve
from worked import page_of_file

ROD = """
title: Rod that turns uniformly
plane: horizontal
points: {O: [0, 0], A: [%s, %s]}
bodies: {rod: {rod: [O, A], mass: 1 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
states: {1: [t = 0, omega(rod) = %s rad/s], 2: [%s]}
find: {phi: r(A).angle @ 2, theta: theta(rod) @ 2, t: t @ 2}
"""
PARTICLE = """
title: Particle drawn to a point by a spring, on a circle
plane: horizontal
points: {O: [0, 0]}
bodies: {p: {particle: [1 m, 0], mass: 1 kg}}
loads:
  - spring: {between: [O, p], stiffness: 4 N/m, natural_length: 0 m}
states: {1: [t = 0, v(p).x = 0, v(p).y = %s m/s], 2: [%s]}
find: {phi: r(p).angle @ 2}
"""


@pytest.mark.parametrize("speed", [2, -2])
def test_a_point_of_a_body_that_turns(speed: float) -> None:
    found = solve(ROD % ("1 m", "0", speed, "t = 10 s"))
    assert first(found["phi"]) == pytest.approx(10 * speed)
    assert first(found["phi"]) == first(found["theta"])


def test_turns_count_from_where_it_is_drawn() -> None:
    """At (-1, -1) the angle is -135 deg."""
    found = solve(ROD % ("-1 m", "-1 m", 2, "t = 10 s"))
    assert first(found["phi"]) == pytest.approx(20 - 3 * pi / 4)


def test_a_state_given_by_turns() -> None:
    found = solve(ROD % ("1 m", "0", 2, "r(A).angle = 370 deg"))
    assert first(found["t"]) == pytest.approx(370 * pi / 180 / 2)


@pytest.mark.parametrize("speed", [2, -2, 0.2])
def test_a_particle_in_x_and_y(speed: float) -> None:
    """x = cos 2t, y = v/2 sin 2t: on an ellipse every half swing is half a turn."""
    end = 10 * pi + pi / 4
    found = solve(PARTICLE % (speed, f"t = {end!r} s"))
    turned = 2 * pi * round(2 * end / (2 * pi) - 0.25) * (1 if speed > 0 else -1)
    assert first(found["phi"]) == pytest.approx(turned + (pi / 2 if speed > 0 else -pi / 2))


def test_a_direction_that_is_reached_after_more_turns() -> None:
    """2 rad/s, from 0."""
    for degrees in (45, 370):
        found = solve(PARTICLE % (2, f"r(p).angle = {degrees} deg"))
        assert first(found["phi"]) == pytest.approx(pi * degrees / 180)


ORBIT = """
title: Satellite that goes round
plane: horizontal
given: {{m: 100 kg, K: 3.986e14 m^3/s^2, r_1: 7000 km, v_1: 9 km/s}}
points: {{O: [0, 0], P: [r_1, 0]}}
bodies: {{probe: {{particle: P, mass: m}}}}
loads:
  - force: {{body: probe, magnitude: K*m/r(probe).mag^2, towards: O}}
states:
  near: [t = 0, v(probe).x = 0, v(probe).y = v_1]
  {between}
  round: [r(probe).angle = {angle} deg]
find: {{T: t @ round}}
"""


@pytest.mark.slow
@pytest.mark.parametrize("angle", [300, 360, 720])
@pytest.mark.parametrize("between", [
    ["apogee: [r(probe).mag is largest]"],
    ["left: [y(probe) = 0 m, x(probe) < 0 m]"],
    ["up: [r(probe).angle = 90 deg]", "apogee: [r(probe).mag is largest]"],
    ["up: [r(probe).angle = 90 deg]", "down: [r(probe).angle = 250 deg]"],
])  # fmt: skip
def test_a_direction_counts_from_the_beginning_whenever_it_is_asked(between: list[str], angle: int) -> None:
    """By Kepler's equation, M = E - e sin E, with the time of a revolution by the third law."""
    k, r, v = 3.986e14, 7e6, 9e3
    a, e = 1 / (2 / r - v * v / k), r * v * v / k - 1
    turns, rest = divmod(angle, 360)
    anomaly = 2 * math.atan(math.sqrt((1 - e) / (1 + e)) * math.tan(math.radians(rest) / 2)) % math.tau
    time = math.sqrt(a**3 / k) * (anomaly - e * math.sin(anomaly) + math.tau * turns)
    found = solve(ORBIT.format(between="\n  ".join(between), angle=angle))
    assert_close(found["T"], time, 8)


BEAD = """
title: Bead on a turning rod
plane: horizontal
given: {w: 2 rad/s, r_0: 0.005 m, L: 3 m, m: 1 kg}
unknowns: {u: m/s}
points: {O: [0, 0], E: [L, 0], P: [r_0, 0]}
bodies:
  rod: {rod: [O, E]}
  bead: {particle: P, mass: m}
joints:
  - pin: {at: O, between: [ground, rod]}
  - guide: {point: P, along: rod}
motion: [omega(rod) = w]
states: {1: [t = 0, v(P/rod).along(rod) = u], 2: [%s]}
find: {u: u, t_2: t @ 2}
"""
PLACE = ["r(P/O).mag = L", "r(P/O).angle = 400 deg"]


@pytest.mark.parametrize("place", [PLACE, PLACE[::-1]])
def test_a_distance_and_a_direction_with_its_turns(place: list[str]) -> None:
    """Each says what it says alone: the direction counts turns beside the distance as well."""
    found = solve(BEAD % ", ".join(place))
    t = math.radians(400) / 2
    assert first(found["t_2"]) == pytest.approx(t)
    assert first(found["u"]) == pytest.approx(2 * (3 - 0.005 * math.cosh(2 * t)) / math.sinh(2 * t))


def test_what_is_given_of_a_place_is_not_found() -> None:
    page = page_of_file("satellite-to-a-second-point-in-forty-minutes")
    assert "the distance of S from O = r_B" in page
    assert "cos φ_B" not in page
