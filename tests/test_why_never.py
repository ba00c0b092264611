"""A state that is not reached is what the refusal points at, with how near the motion comes on the whole way to it."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import Diagnostic, NoSolution

BUNGEE = """
title: Bungee jump
plane: vertical
given: {m: 70 kg, l: 15 m, H: 45 m}
points: {O: [0, 0], P: [0, 0]}
bodies: {man: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 90 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: l, acts: pull, name: cord}
"""
SOUGHT = "unknowns: {k: N/m}\nstates:\n  1: [at rest]\n  low: [v(man).y = 0, y(man) = PLACE]\nfind: {k: k}\n"
FALLS = "states:\n  1: [t = 0, at rest]\n  low: [y(man) = -60 m]\nfind: {v: v(man).mag @ low}\n"


def why(text: str) -> Diagnostic:
    with pytest.raises(NoSolution) as refused:
        solve(text)
    return refused.value.diagnostics[0]


def test_the_stiffness_with_which_he_just_gets_there() -> None:
    """m g H = k (H - l)²/2."""
    k = float(solve(BUNGEE + SOUGHT.replace("PLACE", "-H"))["k"].values[0])
    assert k == pytest.approx(2 * 70 * 9.81 * 45 / 30**2)


def test_a_place_that_no_stiffness_lets_him_reach_is_pointed_at() -> None:
    found = why(BUNGEE + SOUGHT.replace("PLACE", "H"))
    assert (found.code, found.mark.line) == ("PL624", 14)
    assert "`y(man) = H` contradict `at rest` in state 1" in found.message
    assert "whatever the value of k" in found.message


def test_how_near_he_comes_also_before_the_cord_is_free_again() -> None:
    """m g s = k (s - l)²/2 at the lowest place."""
    found = why(BUNGEE.replace("H: 45 m", "k: 60 N/m") + FALLS)
    half = 15 + 70 * 9.81 / 60
    low = half + math.sqrt(half * half - 15**2)
    fall, turn = math.sqrt(2 * 15 / 9.81), math.sqrt(60 / 70)
    after = (math.pi / 2 + math.atan(9.81 / turn / math.sqrt(2 * 9.81 * 15))) / turn
    assert (found.code, found.mark.line) == ("PL621", 13)
    assert f"is nearest at t = {fall + after:.4g} s, where the sides differ by {60 - low:.4g} m" in found.hint
