"""Constants far from the size that the scales of a motion suggest: a buffer as stiff as a lorry needs."""

from __future__ import annotations

import pytest
from answered import first, solve

BUFFER = """plane: horizontal
unknowns: {k: N/m}
points: {W: [5 m, 0]}
bodies: {lorry: {particle: [0, 0], mass: 200 kg}}
joints:
  - guide: {body: lorry, along: 0 deg}
loads:
  - spring: {between: [lorry, W], stiffness: k, natural_length: 1 m, acts: push}
states:
  1: [x(lorry) = 0, v(lorry).x = 3 m/s]
  2: [v(lorry).x = 0, x(lorry) = 4.2 m]
find: {k: k}
"""


def test_the_buffer_that_stops_a_lorry() -> None:
    """k s²/2 = m v²/2 with s = 0.2 m."""
    assert float(first(solve(BUFFER)["k"])) == pytest.approx(200 * 9 / 0.04)
