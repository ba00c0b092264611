"""What only following a motion tells, beside its equations of motion integrated by themselves."""

from __future__ import annotations

import math
from dataclasses import replace

import sympy as sp
from answered import assert_close, solve

from planar_cli.problem.structure import load_text
from planar_cli.solve.between.integrated import apart, digits
from planar_cli.solve.following.mode_search import ModeSearch
from planar_cli.solve.regimes.mode_sequence import Workshop
from planar_cli.solve.run import solve_problem

SWING = """
title: A damped swing
plane: vertical
given: {m: 2 kg, l: 0.8 m, c: 0.05 N*m*s}
coordinates: {theta: deg}
points: {O: [0, 0], A: [l*sin(theta), -l*cos(theta)]}
bodies: {rod: {rod: [O, A], mass: m}}
joints: [{pin: {at: O, between: [ground, rod]}}]
loads: [{torque: {body: rod, moment: -c*dot(theta)}}]
states:
  1: [theta = 40 deg, at rest]
  2: [theta = -20 deg]
find: {omega: omega(rod) @ 2}
"""

PUCK = """
title: A puck on a string that is pulled through a hole
plane: horizontal
points: {O: [0, 0]}
bodies: {P: {particle: [0.6 m, 0], mass: 0.2 kg}, hand: {particle: [0, -1 m]}}
joints: [{rope: {path: [P, O, hand]}}, {guide: {point: hand, along: 90 deg}}]
motion: [v(hand).y = -0.1 m/s]
states: {1: [t = 0, v(P).theta = 1.5 m/s], 2: [r(P).mag = 0.3 m]}
find: {v: v(P).theta @ 2, turns: (r(P).angle @ 2 - r(P).angle @ 1)/(2*pi)}
"""


def test_equations_of_motion_agree_with_what_was_followed_and_a_wrong_one_does_not() -> None:
    problem, wrong = load_text(SWING)
    assert problem is not None
    assert not wrong
    found = ModeSearch(problem, Workshop({}), units={}, trial={}).run()
    assert found.guessed
    assert found.followed is not None
    (segment,) = found.followed.segments
    sought = {"": set[sp.Symbol](), "2": {segment.regime.coordinates[0].symbol}}
    off = apart([segment], found.followed.sizes, sought)
    assert off is not None
    assert digits(off) >= 10
    assert apart([segment], found.followed.sizes, {"": set()}) is None
    (u,) = segment.regime.accelerations
    # A thousandth of the weight's moment, sign and all.
    segment.regime.accelerations[u] *= sp.Rational(1001, 1000)
    off = apart([replace(segment)], found.followed.sizes, sought)
    assert off is not None
    assert 1e-4 < off < 1e-2


def test_its_answers_are_compared() -> None:
    problem, _ = load_text(SWING)
    assert problem is not None
    (part,) = solve_problem(problem).parts
    assert part.motion is not None
    assert part.confirmed.finds == {"omega"}
    assert part.motion.integrated


def test_a_divisor_that_passes_through_zero_cuts_what_is_compared() -> None:
    """v_x = (v_hand r - v_y y)/x has a pole wherever the puck passes x = 0; v_theta = r_0 v_0/r beside it."""
    problem, wrong = load_text(PUCK)
    assert problem is not None
    assert not wrong
    (part,) = solve_problem(problem).parts
    assert part.motion is not None
    assert part.motion.integrated
    assert part.confirmed.finds == {"v", "turns"}
    found = solve(PUCK)
    assert_close(found["v"], 3.0)
    assert_close(found["turns"], 7.5 / math.pi)
