"""Finds put together from quantities at several states that are each complete in themselves."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from answered import first, number, solve

TURNING = """
title: Bar that turns about its end, at two instants
plane: vertical
{known}
coordinates: {{phi: deg}}
points: {{A: [0, 0], B: {{from: A, distance: l, angle: phi}}}}
bodies: {{bar: {{rod: [A, B], mass: m}}}}
joints:
  - pin: {{at: A, between: [ground, bar]}}
states:
  1: [phi = 0, omega(bar) = w]
  2: [phi = 0, omega(bar) = 3*w]
"""
NUMBERS = TURNING.format(known="given: {m: 2 kg, l: 2 m, w: 1 rad/s}")


def test_pieces_of_several_states_are_kept_apart() -> None:
    """A_x = -m w² l/2: -2 N and -18 N."""
    found = solve(
        NUMBERS
        + "find: {d: reaction(A).x @ 1 - 2*reaction(A).x @ 2, q: sqrt(reaction(A).x @ 1/(reaction(A).x @ 2)), "
        + "k: (reaction(A).x @ 1)^2, turned: -(omega(bar)/2) @ 2 in rpm, one: reaction(A).x @ 2}"
    )
    assert {name: float(number(f)) for name, f in found.items()} == pytest.approx(
        {"d": 34, "q": 1 / 3, "k": 4, "turned": -1.5, "one": -18}
    )
    assert {name: f.unit.text for name, f in found.items()} == {
        "d": "N",
        "q": "1",
        "k": "kg^2*m^2/s^4",
        "turned": "rpm",
        "one": "N",
    }


def test_differences_of_vectors() -> None:
    found = solve(NUMBERS + "find: {s: a(B) @ 1 - a(B) @ 2, half: (a(B) @ 2)/2}")
    assert [float(v) for v in found["s"].values or ()] == pytest.approx([16, 0])
    assert [float(v) for v in found["half"].values or ()] == pytest.approx([-9, -14.715 / 2])


def test_letters_stay_in_a_difference() -> None:
    found = solve(
        TURNING.format(known="symbols: {m: kg, l: m, w: rad/s}") + "find: {d: reaction(A).x @ 1 - reaction(A).x @ 2}"
    )["d"]
    assert found.values is None
    m, length, w = (next(s for s in found.expressions[0].free_symbols if s.name == n) for n in "mlw")
    assert sp.expand(found.expressions[0] - 4 * m * length * w**2) == 0


SWING = """
title: Rod let go level, in a pivot that rubs
plane: vertical
points: {O: [0, 0], E: [0.9 m, 0]}
bodies: {rod: {rod: [O, E], mass: 6 kg}}
joints:
  - pin: {at: O, between: [ground, rod], friction_torque: 1 N*m}
states:
  1: [at rest]
  2: [omega(rod) = 0]
find: {turned: theta(rod) @ 2}
"""


def test_a_later_state_is_not_where_the_first_is_drawn() -> None:
    """½ m g l (sin φ) = M φ with φ = π - the rest: the rod comes to rest on the other side."""
    turned = -first(solve(SWING)["turned"])
    assert 3.0 < turned < 3.14
    assert 0.5 * 6 * 9.81 * 0.9 * math.sin(turned) == pytest.approx(turned, rel=1e-9)
