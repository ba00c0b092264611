"""What touches at a place that is written out is called by its body: no name that the file does not use is needed."""

from __future__ import annotations

import pytest
from answered import first, solve

WHEEL = """
title: Wheel that is pulled
plane: vertical
given: {R: 0.5 m}
bodies: {w: {disk: [0, R], radius: R, mass: 2 kg}}
joints: [{rolling: {between: [w, ground], at: [0, 0]}}]
loads: [{force: {body: w, at: [0, R], magnitude: 3 N, angle: 0 deg}}]
instant: [at rest]
find: {N: N(w), F: friction(w).x, P: force(w).x}
"""


def test_forces_are_asked_by_the_body() -> None:
    found = solve(WHEEL)
    assert first(found["N"]) == pytest.approx(2 * 9.81)
    assert first(found["F"]) == pytest.approx(-1)
    assert first(found["P"]) == pytest.approx(3)
