"""A state that is told by the length of the way from rest: it goes where it is accelerated, also against an axis."""

from __future__ import annotations

import pytest
from answered import first, solve

SLIDES = """
title: Block that slides down
plane: vertical
bodies: {b: {particle: [0, 0], mass: 2 kg}}
joints:
  - JOINT
states: {1: [at rest], 2: [path_length(b) @ 1->2 = 4 m]}
find: {v: v(b).mag @ 2}
"""
PULLED = """
title: Block that a growing force pulls to the left
plane: horizontal
bodies: {b: {particle: [0, 0], mass: 2 kg}}
joints:
  - guide: {body: b, along: 0 deg}
loads:
  - force: {body: b, magnitude: 2 N/s * t, angle: SIDE}
states: {1: [at rest, t = 0], 2: [path_length(b) @ 1->2 = 9 m]}
find: {t: t @ 2}
"""


@pytest.mark.parametrize("angle", ["30 deg", "150 deg", "210 deg"])
def test_down_a_slope(angle: str) -> None:
    """v² = 2 g s sin 30°."""
    text = SLIDES.replace("JOINT", f"guide: {{body: b, along: {angle}}}")
    assert first(solve(text)["v"]) == pytest.approx((9.81 * 4) ** 0.5)


@pytest.mark.parametrize("side", ["0 deg", "180 deg"])
def test_where_the_force_begins_at_zero(side: str) -> None:
    """s = t³/6."""
    assert first(solve(PULLED.replace("SIDE", side))["t"]) == pytest.approx(54 ** (1 / 3))
