"""A block that a rope and friction hold on a turning table: how they share is open, so no tension is told."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import NoSolution

HELD_TWICE = """
title: A block on a turning table, tied to its centre
plane: horizontal
given: {m: 2 kg, r: 0.5 m, w: 4 rad/s, mu: 0.3}
points: {O: [0, 0], P: [r, 0]}
bodies:
  table: {disk: O, radius: 1 m}
  block: {particle: P, mass: m}
joints:
  - pin: {at: O, between: [ground, table]}
  - flat: {between: [block, table], mu: mu}
  - rope: {path: [O, P], name: cord}
motion: [omega(table) = w]
instant: [v(P/table).mag = 0]
find: {T: tension(cord)}
"""


def test_the_tension_is_open() -> None:
    with pytest.raises(NoSolution) as raised:
        solve(HELD_TWICE)
    assert [d.code for d in raised.value.diagnostics] == ["PL603"]


def test_it_sticks_with_the_rope_and_slips_without() -> None:
    text = HELD_TWICE.replace("tension(cord)", "mode(block)")
    assert solve(text)["T"].word == "stick"
    without = "\n".join(line for line in text.splitlines() if "- rope" not in line)
    assert solve(without)["T"].word == "slip"
