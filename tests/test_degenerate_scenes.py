"""Places that coincide, roots that are there twice, joints that deny what places say: answered or refused by name."""

from __future__ import annotations

from math import sqrt

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import FileProblem, Undecided
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load_text
from planar_cli.solve.instant.roots import real_roots
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.where_asked import where_asked

CARTS = """
title: Two carts drawn at one place of a track
plane: horizontal
points: {B: [0, 0]}
bodies: {first: {particle: B, mass: 3 kg}, second: {particle: B, mass: 5 kg}}
joints:
  - guide: {body: first, along: 0 deg}
  - guide: {body: second, along: 0 deg}
loads:
  - force: {body: first, magnitude: 6 N, angle: 0 deg}
  - force: {body: second, magnitude: 5 N, angle: 0 deg}
states: {1: [t = 0, at rest], 2: [t = 2 s]}
find: {v_1: v(first).x @ 2, v_2: v(second).x @ 2}
"""
CRANK = """
title: Arm through the pin of a crank
given: {r: 100 mm, h: %s}
coordinates: {theta: deg}
points:
  O: [0, 0]
  C: [0, -h]
  P: {from: O, distance: r, angle: theta}
  D: {from: C, towards: P, distance: 450 mm}
bodies: {crank: {rod: [O, P]}, arm: {rod: [C, D]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: C, between: [ground, arm]}
  - guide: {point: P, along: arm}
motion: [omega(crank) = 8 rad/s]
states: {down: [theta = 270 deg]}
find: {omega: omega(arm) @ down}
"""
BOOM = """
title: Boom on a truck
symbols: {h: m, l: m}
coordinates: {s: m, beta: deg}
points: {A: [s, h], B: {from: A, distance: l, angle: beta}}
bodies: {truck: {points: [A], center: A}, boom: {rod: [A, B]}}
joints:
  - guide: {body: truck, along: 0 deg}
  - pin: {at: %s, between: [truck, boom]}
find: {curve: path(B/A)}
"""


def test_two_bodies_that_slide_at_one_place() -> None:
    found = solve(CARTS)
    assert first(found["v_1"]) == pytest.approx(4)
    assert first(found["v_2"]) == pytest.approx(2)


def test_roots_that_are_there_twice() -> None:
    x = sp.Symbol("x", real=True)
    found = real_roots(sp.expand((x**3 - x - 1) ** 2 * (x**2 - 2) ** 2 * (x + 3)), x, Valuation({}), False, False)
    assert [float(r.value) for r in found] == pytest.approx([-3, -sqrt(2), 1.324717957, sqrt(2)])


def test_points_that_coincide_are_no_fault() -> None:
    assert first(solve(CRANK % "250 mm")["omega"]) == pytest.approx(-8 * 100 / 150)
    with pytest.raises(Undecided, match="`omega`: not decided, a formula has no value in this position"):
        solve(CRANK % "100 mm")


def test_a_curve_of_a_point_that_the_joints_do_not_let_move_so() -> None:
    assert solve(BOOM % "A")["curve"].curve is not None
    with pytest.raises(FileProblem, match="A is a point of both: there they part") as error:
        solve(BOOM % "B")
    assert [d.code for d in error.value.diagnostics] == ["PL467"]


def test_what_is_not_decided_has_a_place() -> None:
    def never(problem: Problem, case: str) -> PartSolution:
        raise Undecided(f"too hard{case}")

    problem, _ = load_text(CARTS, "carts.yaml")
    assert problem is not None
    with pytest.raises(Undecided, match=r"^carts.yaml:13: `v_1`, `v_2` \(case far\): not decided, too hardfar$"):
        where_asked(never, problem, "far")
