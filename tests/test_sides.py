"""Distances along a line stay distances when a body passes the point from which they are measured."""

from __future__ import annotations

import pytest
from answered import first, solve

COLLAR = """
title: Collar that passes the anchor of its spring
plane: horizontal
given: {m: 2 kg, k: 50 N/m, l: 0.5 m}
points: {O: [0, 0], P: [%s, 0]}
bodies: {collar: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: l, name: s}
states:
  1: [v(collar).x = %s]
  2: [x(P) = %s]
find: {v: v(collar).mag @ 2, T: tension(s) @ 2}
"""


@pytest.mark.parametrize("side", [1, -1])
def test_a_spring_beyond_its_anchor(side: int) -> None:
    """At the same distance it has the same tension and energy."""
    found = solve(COLLAR % (f"{0.3 * side} m", f"{-4 * side} m/s", f"{-0.3 * side} m"))
    assert first(found["v"]) == pytest.approx(4)
    assert first(found["T"]) == pytest.approx(-10)


@pytest.mark.parametrize("side", [1, -1])
def test_a_spring_that_begins_at_its_anchor(side: int) -> None:
    found = solve(COLLAR % ("0", f"{5 * side} m/s", f"{0.7 * side} m"))
    assert first(found["v"]) ** 2 == pytest.approx(25 + 50 / 2 * (0.5**2 - 0.2**2))
    assert first(found["T"]) == pytest.approx(10)
