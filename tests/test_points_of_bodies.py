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
