"""A blow that the file names and in which nothing strikes is refused, and not told as one that changes nothing."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

JUMP = """
title: Skier who lands on a slope
plane: vertical
given: {beta: 25 deg, gamma: 35 deg, s: 30 m, h: HEIGHT}
points: {E: [0, 0], S: {from: E, distance: s, angle: 180 deg - beta}, F: [0, -h]}
surfaces: {ramp: {through: E, angle: -beta}, hill: {through: F, angle: -gamma}}
bodies: {skier: {particle: S, mass: 70 kg}}
joints:
  - contact: {between: [skier, ramp], at: S, mu: 0, during: 1->2}
  - impact: {between: [skier, hill], restitution: 0, during: 3->4}
states:
  1: [at rest]
  2: [x(skier) = 0]
  3: [y(skier) = -h - x(skier)*tan(gamma)]
  4: [just after 3]
find: {v: v(skier).mag @ 4}
"""


@pytest.mark.parametrize(("mu", "named"), [("mu: 0", ", during: 3->4}"), ("mu_k: 0.05", "}")])
def test_the_slope_has_no_end_and_the_start_lies_on_its_other_side(mu: str, named: str) -> None:
    with pytest.raises(NoSolution) as raised:
        solve(JUMP.replace("HEIGHT", "2 m").replace("mu: 0", mu).replace(", during: 3->4}", named))
    (why,) = raised.value.diagnostics
    assert (why.code, why.mark.line) == ("PL626", 10)
    assert why.message.startswith("skier and hill do not approach each other in state 3")


def test_from_above_it_lands() -> None:
    found = solve(JUMP.replace("HEIGHT", "20 m"))
    b, c = math.radians(25), math.radians(35)
    v = math.sqrt(2 * 9.81 * 30 * math.sin(b))
    along, down = v * math.cos(b), v * math.sin(b) - v * math.cos(b) * math.tan(c)
    t = (-down + math.sqrt(down**2 + 2 * 9.81 * 20)) / 9.81
    assert first(found["v"]) == pytest.approx(along * math.cos(c) + (v * math.sin(b) + 9.81 * t) * math.sin(c))
