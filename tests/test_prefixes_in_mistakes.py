"""A prefix that is lost in a given value: the answer is off by a root of ten, or by a power of it."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from homework_made import graded, homework_of, set_of

from planar_cli.homework.sets.ready import Homework

GUN = """
plane: horizontal
given: {m: 0.2 kg, s: 120 mm, k: 1.6 kN/m, l_0: 300 mm}
points: {O: {from: Q, distance: l_0, angle: 180 deg}, Q: [0, 0], P: {from: Q, distance: s, angle: 180 deg}}
bodies: {ball: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: l_0}
states:
  1: [at rest]
  2: [x(ball) = 0]
find: {v: v(ball).mag @ 2}
"""
# By hand: v = s √(k/m) = 10.73 m/s.


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("gun"), gun=GUN))


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("0.3394 m/s", "k was put in with the number of kN/m, without its power of ten"),
        # Ten times the stiffness, or a tenth of the mass: v √10.
        ("33.94 m/s", "a given value was put in off by a power of ten"),
        # The same as a slip at the end: nobody knows where it was made.
        ("10730 m/s", "the number is off by a power of ten"),
    ],
)
def test_a_prefix_is_lost(homework: Homework, typed: str, said: str) -> None:
    one = graded(homework, "gun.v", typed)
    assert (one.verdict, one.mistakes) == ("wrong", ("power-of-ten",))
    assert said in one.feedback


THROW = """
plane: vertical
given: {m: 3 kg, F: 80 N, d: 0.4 m}
points: {P: [0, 0]}
bodies: {crate: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg, mu: 0.2}
loads:
  - force: {body: crate, magnitude: F, angle: 0 deg}
states: {1: [at rest], 2: [x(crate) = d]}
find: {v: v(crate).mag @ 2}
"""
# By hand: v = √(2 d (F/m - 0.2 g)).


def test_a_value_is_off_by_ten(tmp_path: Path) -> None:
    homework = homework_of(set_of(tmp_path, crate=THROW))
    # A tenth of the mass gives what ten times the force does.
    for d, m, said in (
        (0.4, 0.3, "a given value was put in off by a power of ten"),
        (4.0, 3, "d was put in ten times too large"),
    ):
        v = math.sqrt(2 * d * (80 / m - 0.2 * 9.81))
        one = graded(homework, "crate.v", f"{v:.4g} m/s")
        assert one.mistakes == ("power-of-ten",)
        assert one.feedback == f"{said}: look at its unit and its decimal point"
