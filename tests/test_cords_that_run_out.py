"""A cord that is drawn too short for what is asked has a place in the file, a code and a hint."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution

DRUM = """
title: Double pulley with two weights
plane: vertical
given: {{r: 0.15 m, R: 0.25 m}}
points: {{O: [0, 0], S: [-R, 0], T: [r, 0], A: [-R, {length}], B: [r, {length}]}}
bodies:
  pulley: {{disk: O, radius: R, hub: r, mass: 20 kg, radius_of_gyration: 0.18 m}}
  A: {{particle: A, mass: 15 kg}}
  B: {{particle: B, mass: 20 kg}}
joints:
  - pin: {{at: O, between: [ground, pulley]}}
  - rope: {{path: [S on pulley, A], name: cord_A}}
  - rope: {{path: [T on pulley, B], name: cord_B}}
states: {{1: [t = 0, at rest], 2: [t = 3 s]}}
find: {{omega: omega(pulley) @ 2}}
"""


def test_the_cord_is_named_with_its_place() -> None:
    with pytest.raises(NoSolution) as caught:
        solve(DRUM.format(length="-1 m"))
    (told,) = caught.value.diagnostics
    assert (told.code, told.mark.line) == ("PL712", 13)
    assert "a free part of cord_B has run out" in told.message
    assert "further off" in told.hint


def test_a_longer_cord_will_do() -> None:
    alpha = (15 * 0.25 - 20 * 0.15) * 9.81 / (20 * 0.18**2 + 15 * 0.25**2 + 20 * 0.15**2)
    assert_close(solve(DRUM.format(length="-20 m"))["omega"], 3 * alpha, 9)
