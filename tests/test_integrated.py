"""What only following a motion tells, beside its equations of motion integrated by themselves."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

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
