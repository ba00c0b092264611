"""Loads without names of their own that are called by one point are still several loads."""

from __future__ import annotations

from math import exp, sqrt

import pytest
from answered import first, number, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

LET_GO = """title: Weight between two springs let go
plane: vertical
coordinates: {x: m, y: m}
points: {A: [0, 0], B: [1 m, 0], P: [x, y]}
bodies: {w: {particle: P, mass: 5 kg}}
loads:
  - spring: {between: [ONE], stiffness: 300 N/m, natural_length: 0.4 m}
  - spring: {between: [TWO], stiffness: 200 N/m, natural_length: 0.5 m}
states: {1: [x = 0.5 m, y = -0.3 m, at rest], 2: [t = 0.5 s]}
find: {v: v(w).mag @ 2, E: PE(all) @ 1 + KE(all) @ 1 - PE(all) @ 2 - KE(all) @ 2}
"""
CORDS = """title: Block between two cords
plane: horizontal
points: {P: [0, 0], A: [-1 m, 0], B: [1 m, 0]}
bodies: {b: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [b, A], stiffness: 100 N/m, natural_length: 1 m, acts: pull}
  - spring: {between: [b, B], stiffness: 200 N/m, natural_length: 1 m, acts: pull}
states:
  1: [t = 0, v(b).x = 1 m/s]
  2: [v(b).x = 0]
  3: [x(b) = 0]
  4: [v(b).x = 0]
find: {right: x(b) @ 2, left: x(b) @ 4}
"""
KICKED = """title: Two impulses at one point
plane: horizontal
points: {P: [0, 0]}
bodies: {b: {particle: P, mass: 2 kg}}
loads:
  - impulse: {body: b, at: P, magnitude: 4 N*s, angle: 0 deg, during: 1->2}
  - impulse: {body: b, at: P, magnitude: 6 N*s, angle: 90 deg, during: 1->2}
states:
  1: [at rest]
  2: [just after 1]
find: {x: v(b).x @ 2, y: v(b).y @ 2}
"""
SLACK = """title: Slack cord beside a damper
plane: horizontal
points: {P: [0, 0], A: [-1 m, 0]}
bodies: {b: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [b, A], stiffness: 100 N/m, natural_length: 1 m, acts: pull}
  - damper: {between: [b, A], coefficient: 5 N*s/m}
states:
  1: [t = 0, v(b).x = -1 m/s]
  2: [t = 0.1 s]
find: {v: v(b).x @ 2}
"""


@pytest.mark.parametrize(("one", "two"), [("A, w", "B, w"), ("P, A", "P, B"), ("A, P", "B, P"), ("w, A", "w, B")])
def test_energies_of_two_springs_at_one_point(one: str, two: str) -> None:
    found = solve(LET_GO.replace("ONE", one).replace("TWO", two))
    assert first(found["v"]) == pytest.approx(0.567625, abs=1e-5)
    assert first(found["E"]) == pytest.approx(0, abs=1e-9)


def test_two_cords_that_only_pull() -> None:
    """To the right the left one pulls, to the left the right one."""
    found = solve(CORDS)
    assert first(found["right"]) == pytest.approx(sqrt(2 / 100))
    assert first(found["left"]) == pytest.approx(-sqrt(2 / 200))
    problem, wrong = load_text(CORDS)
    assert problem is not None, wrong
    followed = {a.name: a.values[0] for a in simulate(problem, Settings()).answers}
    assert followed["right"] == pytest.approx(sqrt(2 / 100), rel=1e-6)


def test_two_impulses_at_one_point() -> None:
    found = solve(KICKED)
    assert (float(number(found["x"])), float(number(found["y"]))) == pytest.approx((2, 3))


def test_a_cord_that_is_slack_leaves_the_damper() -> None:
    assert first(solve(SLACK)["v"]) == pytest.approx(-exp(-0.25))


def test_each_can_be_asked_for() -> None:
    text = CORDS.replace("right: x(b) @ 2, left: x(b) @ 4", "F: force(B).mag @ 4")
    assert first(solve(text)["F"]) == pytest.approx(200 * sqrt(2 / 200))
    _, wrong = load_text(text.replace("force(B)", "force(b)"))
    assert [d.code for d in wrong] == ["PL420"]
