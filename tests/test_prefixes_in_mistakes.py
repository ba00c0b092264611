"""A prefix that is lost in a given value: the answer is off by a root of ten, or by a power of it."""

from __future__ import annotations

import pytest
from homework_made import graded, homework_of, set_of

from planar_cli.homework.ready import Homework

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
        # The same as a slip at the end: nobody knows where it was made.
        ("10730 m/s", "the number is off by a power of ten"),
    ],
)
def test_a_prefix_is_lost(homework: Homework, typed: str, said: str) -> None:
    one = graded(homework, "gun.v", typed)
    assert (one.verdict, one.mistakes) == ("wrong", ("power-of-ten",))
    assert said in one.feedback
