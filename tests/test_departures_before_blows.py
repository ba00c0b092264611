"""A departure from an unstable equilibrium at rest, where a blow follows: the laws tell both, as without the blow."""

from __future__ import annotations

from math import asin, sqrt

import pytest
from answered import number, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

G = 9.81
PEG = """
title: Upright rod falls and strikes a peg
plane: vertical
given: {m: 3 kg, L: 1.2 m, e: 0.5}
points: {A: [0, 0], B: [0, L], C: [2/3*L, 0]}
bodies:
  rod: {rod: [A, B], mass: m}
  peg: {particle: C, mass: m}
joints:
  - pin: {at: A, between: [ground, rod], name: hinge}
  - weld: {at: C, between: [ground, peg], name: block}
  - impact: {between: [rod, peg], normal: 90 deg, restitution: e, during: 2->3, name: hit}
states:
  1: [at rest]
  2: [theta(rod) = 0]
  3: [just after 2]
  4: [omega(rod) = 0]
find: {w: omega(rod) @ 3, phi: theta(rod) @ 4, A_y: impulse(hinge).y @ 2->3}
"""
BOX = """
title: Upright rod topples and strikes a box, the box slides
plane: vertical
given: {m: 4 kg, L: 1 m, M: 2 kg, e: 0.5, mu: 0.4}
points: {A: [0, L], B: [0, 2*L], C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies:
  rod: {rod: [A, B], mass: m}
  box: {particle: C, mass: M}
joints:
  - pin: {at: A, between: [ground, rod]}
  - contact: {between: [box, floor], mu: mu}
  - impact: {between: [rod, box], at: B, normal: 0 deg, restitution: e, during: 2->3}
states:
  1: [at rest]
  2: [theta(rod) = -90 deg]
  3: [just after 2]
  4: [v(box).x = 0]
find: {w_2: abs(omega(rod)) @ 2, v_box: v(box).mag @ 3, s: path_length(box) @ 3->4}
"""


def test_rod_that_strikes_in_its_centre_of_percussion() -> None:
    """The time of the fall has no bound; the impulse of the hinge in the blow does not rest on it."""
    found = solve(PEG)
    assert abs(float(number(found["w"]))) == pytest.approx(0.5 * sqrt(3 * G / 1.2))
    assert float(number(found["phi"])) == pytest.approx(asin(0.25))
    assert abs(float(number(found["A_y"]))) < 1e-9


@pytest.mark.slow
def test_what_rests_until_it_is_struck_moves_afterwards() -> None:
    found = solve(BOX)
    fast = sqrt(6 * G)
    hit = 1.5 * 4 * fast / (3 * 2 + 4)
    assert float(number(found["w_2"])) == pytest.approx(fast)
    assert float(number(found["v_box"])) == pytest.approx(hit)
    assert float(number(found["s"])) == pytest.approx(hit**2 / (2 * 0.4 * G))


@pytest.mark.slow
def test_no_time_is_told_after_a_slight_touch() -> None:
    """It would be the time that the touch takes to grow."""
    problem, _ = load_text(BOX)
    assert problem is not None
    text = Terminal().render(narrate(solve_problem(problem)))
    assert "the limit of a slight touch" in text
    assert "it turns at" not in text
