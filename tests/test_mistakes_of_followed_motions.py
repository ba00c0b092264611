"""Where a motion is followed in numbers, mistakes are known by following it without an effect."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from planar_cli.errors import Mark
from planar_cli.homework.grading.followed_mistakes import FEW, MOST, left_out
from planar_cli.homework.homework import prepared
from planar_cli.homework.sets.set_file import SetProblem
from planar_cli.homework.variants.worked_problem import read_and_solve

# A wind that rises and falls with the place: there is no closed form over time.
SLED = """
plane: horizontal
given: {m: 2 kg, v_0: 6 m/s}
points: {A: [0, 0]}
bodies: {sled: {particle: A, mass: m}}
joints:
  - guide: {point: A, along: 0 deg, name: rail}
loads:
  - spring: {between: [A, [0 - 1 m, 0]], stiffness: 3 N/m, natural_length: 1 m}
  - force: {body: sled, at: A, magnitude: 0.4 N * (1 + sin(x(sled)/(1 m))), angle: 180 deg, name: wind}
states:
  1: [x(A) = 0, v(sled).x = v_0]
  2: [t = 0.5 s]
find: {x_2: x(A) @ 2, v_2: v(sled).x @ 2}
"""


def test_a_spring_left_out_is_known(tmp_path: Path) -> None:
    path = tmp_path / "sled.yaml"
    path.write_text(SLED)
    made = prepared(SetProblem("sled", str(path), Mark("sled", 1, 1)), 0, 1)
    found = {e.find: {m.name: m.values[0] for m in e.mistakes} for e in made.tasks[0].expected}
    assert {"spring-left-out"} <= set(found["x_2"])

    def without(t: float, steps: int = 20_000) -> float:
        x, v, h = 0.0, 6.0, t / steps
        for _ in range(steps):
            v -= 0.2 * (1 + math.sin(x)) * h
            x += v * h
        return x

    assert found["x_2"]["spring-left-out"] == pytest.approx(without(0.5), rel=1e-4)


def test_mistakes_that_are_not_looked_for_are_told(tmp_path: Path) -> None:
    path = tmp_path / "sled.yaml"
    path.write_text(SLED)
    problem = read_and_solve(str(path), "sled")
    assert not [*left_out(problem, FEW)]
    (told,) = left_out(problem, MOST)
    assert told.endswith("in 5 variants or more data ten times off are not told there")
    (told,) = left_out(problem, MOST + 1)
    assert told.startswith("x_2 and v_2 are found by following a motion in numbers; in 30 variants or more mistakes")


BALL = """
plane: vertical
given: {m: 0.5 kg, c: 0.01 kg/m, u: 50 mi/h}
bodies: {ball: {particle: [0, 0], mass: m}}
loads: [drag: {body: ball, linear: 0.02 kg/s, quadratic: c}]
states: {1: [t = 0, v(ball).x = 0, v(ball).y = u], 2: [t = 1 s]}
find: {h: y(ball) @ 2}
"""


def test_data_that_were_not_converted_are_known(tmp_path: Path) -> None:
    found = {}
    for u in ("50 mi/h", "50 m/s"):
        path = tmp_path / "ball.yaml"
        path.write_text(BALL.replace("50 mi/h", u))
        (expected,) = prepared(SetProblem("ball", str(path), Mark("ball", 1, 1)), 0, 1).tasks[0].expected
        found[u] = expected
    known = {m.name: m.values[0] for m in found["50 mi/h"].mistakes}
    assert known["given-not-converted"] == pytest.approx(found["50 m/s"].values[0], rel=1e-6)
