"""Loads on a body without mass that balance but for a tiny part of them do not balance."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import NoSolution

PULLED = """
title: Block without mass between two forces
plane: horizontal
points: {A: [0, 0]}
bodies: {block: {particle: A}, stone: {particle: [1 m, 0], mass: 2 kg}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: stone, along: 0 deg}
loads:
  - force: {body: block, magnitude: 100000000000000000000 N, angle: 0 deg}
  - force: {body: block, magnitude: 99999999999999999999 N, angle: 180 deg}
  - force: {body: stone, magnitude: 4 N, angle: 0 deg}
instant: [at rest]
find: {a: a(stone).x}
"""


def test_one_newton_beside_very_large_forces_is_no_rounding() -> None:
    with pytest.raises(NoSolution, match="forces on block cannot balance"):
        solve(PULLED)
