"""Whose a point is that more than one body may claim."""

from __future__ import annotations

import pytest
from answered import first, solve

WEDGE = """
title: A block on a smooth wedge that may slide
plane: vertical
points: {O: [0, 0], B: [0, 1 m]}
surfaces: {face: {through: B, angle: 30 deg, body: A}}
bodies:
  A: {points: [O, B], center: O, mass: 3 kg}
  B: {particle: B, mass: 1 kg}
joints:
  - guide: {body: A, along: 0 deg}
  - contact: {between: [B, face], at: B, mu: 0}
instant: [at rest]
find: {relative: a(B/A).mag}
"""


def test_a_point_that_is_called_like_a_body_is_its_own() -> None:
    # (M + m) g sin β / (M + m sin² β), of the block over the wedge.
    assert first(solve(WEDGE)["relative"]) == pytest.approx(4 * 9.81 * 0.5 / 3.25)


ENGINE = """
title: A piston on the pin of its rod
plane: horizontal
points: {O: [0, 0], A: [0, 3 m], B: [4 m, 0]}
bodies:
  crank: {rod: [O, A]}
  rod: {rod: [A, B]}
  piston: {particle: B, mass: 2 kg}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - pin: {at: B, between: [rod, piston]}
  - guide: {point: B, along: 0 deg, name: wall}
loads:
  - force: {body: piston, magnitude: 80 N, angle: 180 deg}
  - torque: {body: crank, moment: M}
unknowns: {M: N*m}
motion: [omega(crank) = 0]
find: {pin: reaction(B/rod).mag, wall: N(wall)}
"""


def test_a_track_presses_on_the_particle_at_a_pin() -> None:
    # The rod has two forces, along itself: 80 N = F 4/5; the wall holds the piston across with F 3/5.
    found = solve(ENGINE)
    assert first(found["pin"]) == pytest.approx(100)
    assert first(found["wall"]) == pytest.approx(60)
