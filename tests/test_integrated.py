"""What only following a motion tells, beside its equations of motion integrated by themselves."""

from __future__ import annotations

import math
from dataclasses import replace

import sympy as sp
from answered import assert_close, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.between.branches.integrated import apart, digits
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


CORD = """
title: A ball on an elastic cord is thrown against the ceiling
plane: vertical
given: {m: 1.5 kg, k: 800 N/m, l_0: 1 m, s: 0.25 m, e: 0.8}
points: {C: [0, 0], B: [0, -l_0 - s]}
surfaces: {ceiling: {through: C, angle: 0 deg}}
bodies: {ball: {particle: B, mass: m}}
joints: [impact: {between: [ball, ceiling], restitution: e, during: hit->back}]
loads: [spring: {between: [C, B], stiffness: k, natural_length: l_0, acts: pull, name: cord}]
states: {go: [at rest], hit: [y(ball) = 0], back: [just after hit], low: [y(ball) is smallest]}
find: {stretch: -y(ball) @ low - l_0}
"""
BURN = """
title: A burn into a transfer
plane: horizontal
given: {GM: 398600 km^3/s^2, r_1: 6700 km, v_1: 10.1326 km/s, m: 1 kg}
points: {O: [0, 0], P: [r_1, 0]}
bodies: {ship: {particle: P, mass: m}}
loads:
  - force: {body: ship, magnitude: GM*m/r(ship).mag^2, towards: O}
  - impulse: {body: ship, magnitude: m*2.4 km/s, angle: 90 deg, during: a->b}
states:
  a: [t = 0, v(ship).x = 0, v(ship).y = 7.7 km/s]
  b: [just after a]
  c: [r(ship).mag = 40000 km]
find: {time: t @ c in h}
"""


def test_the_laws_of_each_stretch_and_the_blow_between_them() -> None:
    page = " ".join(Terminal(200).render(narrate(solve_problem(load_text(CORD)[0]))).split())
    assert "from go to slack, from taut to low: a_x =" in page
    assert "from slack to hit, from back to taut: a_y = -g" in page
    assert "At hit there is a blow: the velocities from back on follow from those before it" in page


def test_the_integration_begins_after_the_blow_of_the_first_state() -> None:
    page = " ".join(Terminal(200).render(narrate(solve_problem(load_text(BURN)[0]))).split())
    assert "from state b on, where" in page
    assert "from state a on" not in page
