"""Finds put together from quantities at several states that are each complete in themselves."""

from __future__ import annotations

import pytest
import sympy as sp
from answered import number, solve

TURNING = """
title: Bar that turns about its end, at two instants
plane: vertical
{known}
points: {{A: [0, 0], B: [l, 0]}}
bodies: {{bar: {{rod: [A, B], mass: m}}}}
joints:
  - pin: {{at: A, between: [ground, bar]}}
states:
  1: [omega(bar) = w]
  2: [omega(bar) = 3*w]
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
