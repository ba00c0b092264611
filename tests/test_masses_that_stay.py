"""A mass that a stream changes stays what it is before the stream begins and after it has ended."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem

ROCKET = """
title: Rocket that burns and coasts
plane: vertical
given: {M: 100 kg, q: 2 kg/s, u: 1500 m/s}
bodies: {rocket: {particle: [0, 0], mass: M - q*t}}
loads:
  - stream: {body: rocket, rate: q, leaves: {at: rocket, speed: u, angle: -90 deg}, during: 1->2}
  - drag: {body: rocket, linear: 5 N*s/m, during: 2->4}
states:
  1: [t = 0, at rest]
  2: [END]
  3: [t = 50 s]
  4: [y(rocket) is largest]
find: {m_2: mass(rocket) @ 2, m_3: mass(rocket) @ 3, v_2: v(rocket).y @ 2, v_3: v(rocket).y @ 3}
"""
CART = """
title: Cart that rolls under a hopper
plane: horizontal
given: {M: 20 kg, q: 4 kg/s, v: 3 m/s}
bodies: {cart: {particle: [0, 0], mass: M + q*(t - 5 s)}}
joints:
  - guide: {point: cart, along: 0 deg, name: rail}
loads:
  - stream: {body: cart, rate: q, enters: {at: cart, speed: v(cart).x, angle: 180 deg}, during: under->past}
states:
  start: [t = 0, v(cart).x = v]
  under: [t = 5 s]
  past: [t = 10 s]
  end: [t = 20 s]
find: {m_0: mass(cart) @ start, m_1: mass(cart) @ end, v_1: v(cart).x @ end, x: x(cart) @ end}
"""


def test_it_coasts_with_the_mass_at_the_end_of_burning() -> None:
    found = solve(ROCKET.replace("END", "t = 40 s"))
    v = 1500 * math.log(5) - 9.81 * 40
    rate, limit = 5 / 20, 9.81 * 20 / 5
    assert (first(found["m_2"]), first(found["m_3"])) == (20, 20)
    assert first(found["v_2"]) == pytest.approx(v)
    assert first(found["v_3"]) == pytest.approx((v + limit) * math.exp(-rate * 10) - limit)


def test_before_it_and_after_it() -> None:
    found = solve(CART)
    assert (first(found["m_0"]), first(found["m_1"])) == (20, 40)
    assert first(found["v_1"]) == pytest.approx(1.5)
    assert first(found["x"]) == pytest.approx(15 + 20 * 3 / 4 * math.log(2) + 15)


def test_the_end_of_a_stream_has_a_time() -> None:
    with pytest.raises(FileProblem) as raised:
        solve(ROCKET.replace("END", "y(rocket) = 5000 m"))
    (why,) = raised.value.diagnostics
    assert why.code == "PL468"
    assert why.message == "the stream on rocket ends in state 2, and the file does not tell when"


def test_a_stream_until_a_state_that_is_not_there() -> None:
    with pytest.raises(FileProblem) as told:
        solve(ROCKET.replace("  2: [END]\n", "").replace(", m_2: mass(rocket) @ 2", ""))
    assert {d.code for d in told.value.diagnostics} == {"PL405"}
