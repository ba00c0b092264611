"""Friction of a fixed size on what rests on something that moves: it holds as long as it can."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import Undecided
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

COIN = """
title: Coin at rest on a turning table
plane: horizontal
given: {{m: 50 g, mu: 0.4, r: 0.2 m, w: {w} rad/s}}
points: {{O: [0, 0], P: [r, 0]}}
bodies: {{table: {{disk: O, radius: 0.5 m}}, coin: {{particle: P, mass: m}}}}
joints:
  - pin: {{at: O, between: [table, ground]}}
  - flat: {{between: [coin, table], mu: mu, name: rub}}
motion: [omega(table) = w]
instant: [v(coin/table).mag = 0]
find: {{F: friction(rub/coin).mag, holds: mode(rub)}}
"""


def test_what_friction_can_hold_does_not_begin_to_slide() -> None:
    """m ω² r = 0.09 N is less than μ m g = 0.196 N."""
    found = solve(COIN.format(w=3))
    assert float((found["F"].values or ())[0]) == pytest.approx(0.05 * 9 * 0.2)
    assert found["holds"].word == "stick"


def test_what_begins_to_slide_on_what_accelerates_is_told() -> None:
    """m ω² r = 0.36 N is more: friction is not zero then, and its direction is that in which it begins."""
    with pytest.raises(Undecided, match="in which direction coin begins to slide on table"):
        solve(COIN.format(w=6))


def test_that_it_slides_is_told_all_the_same() -> None:
    text = COIN.format(w=6).replace("F: friction(rub/coin).mag, ", "")
    assert solve(text)["holds"].word == "slip"


SPUN = """
title: Block on a turntable that is spun up
plane: horizontal
given: {m: 2 kg, r: 0.4 m, e_0: 0.8 rad/s^2, mu: 0.45}
points: {O: [0, 0], B: [r, 0]}
bodies: {table: {disk: O, radius: 0.6 m}, block: {particle: B, mass: m}}
joints:
  - pin: {at: O, between: [ground, table]}
  - flat: {between: [block, table], mu: mu, name: F}
motion: [alpha(table) = e_0]
states: {1: [t = 0, at rest], 2: [mode(F) = slip]}
find: {along: friction(F/block).across(table) @ 2, across: friction(F/block).along(table) @ 2}
"""


def test_friction_keeps_its_direction_as_sliding_begins() -> None:
    """Along the motion m r α, across it what is left of μ m g."""
    problem, _ = load_text(SPUN)
    assert problem is not None
    along, across = (answer.values[0] for answer in simulate(problem, Settings()).answers)
    assert along == pytest.approx(2 * 0.4 * 0.8, rel=1e-7)
    assert across == pytest.approx(-(((0.45 * 2 * 9.81) ** 2 - along**2) ** 0.5), rel=1e-7)
