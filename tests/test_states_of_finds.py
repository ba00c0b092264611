"""Which state a find means, and what is equal at a state that is found to some rounding."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.problem.structure import load_text

BRAKED = """
title: Drum that is braked while its load descends
plane: vertical
given: {W: 400 N}
points: {O: [0, 0], T: [0.3 m, 0], L: [0.3 m, -3 m]}
bodies:
  drum: {disk: O, radius: 0.3 m, mass: 40 kg, radius_of_gyration: 0.25 m}
  cage: {particle: L, mass: 50 kg}
joints:
  - pin: {at: O, between: [ground, drum], friction_torque: 250 N*m}
  - rope: {path: [T on drum, L], name: cable}
states:
  1: [t = 0, v(cage).y = -3 m/s]
  2: [omega(drum) = 0]
"""


@pytest.mark.parametrize(("relation", "truth"), [
    ("omega(drum) @ 2 = 0", "true"), ("omega(drum) @ 2 > 0", "false"), ("omega(drum) @ 2 >= 0", "true"),
    ("omega(drum) @ 2 < 0", "false"), ("v(cage).y @ 1 < v(cage).y @ 2", "true"),
])  # fmt: skip
def test_a_zero_that_is_found_to_a_rounding_is_zero(relation: str, truth: str) -> None:
    """The motion that is followed agrees with the one that is solved."""
    assert solve(BRAKED + f"find: {{told: {relation}, t: t @ 2}}")["told"].word == truth


def test_a_state_belongs_to_what_stands_just_before_it() -> None:
    _, told = load_text(BRAKED + "find: {part: tension(cable)/W @ 1}")
    assert [(d.code, d.mark.line) for d in told] == [("PL435", 15)]
    assert "`W @ 1`: W is the same at every state, and tension(cable) has none" in told[0].message
    (value,) = solve(BRAKED + "find: {part: tension(cable) @ 1/W}")["part"].values or ()
    assert float(value) == pytest.approx(1.777, rel=1e-3)


def test_nor_does_a_bracket_of_constants_have_a_state() -> None:
    _, told = load_text(BRAKED + "find: {part: tension(cable)/(2*W) @ 1}")
    assert [(d.code, d.mark.line) for d in told] == [("PL435", 15)]
    assert "`(…) @ 1`: what stands in the bracket is the same at every state, and tension(cable) has none" in str(
        told[0].message
    )
    (value,) = solve(BRAKED + "find: {part: (tension(cable)/(2*W)) @ 1}")["part"].values or ()
    assert float(value) == pytest.approx(1.777 / 2, rel=1e-3)
