"""A prefix that is lost in a given value: the answer is off by a root of ten, or by a power of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.homework.grading import grade
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.paper import Submission
from planar_cli.homework.ready import Homework
from planar_cli.homework.rules import Rules
from planar_cli.homework.set_file import read_set

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
    path: Path = tmp_path_factory.mktemp("gun") / "set.yaml"
    (path.parent / "gun.yaml").write_text(GUN)
    path.write_text("problems: [gun.yaml]\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 0, 1) for p in homework_set.problems])


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("0.3394 m/s", "k was put in with the number of kN/m, without its power of ten"),
        # The same as a slip at the end: nobody knows where it was made.
        ("10730 m/s", "the number is off by a power of ten"),
    ],
)
def test_a_prefix_is_lost(homework: Homework, typed: str, said: str) -> None:
    (one,) = grade(Submission("ann", 0, (("gun", "v", typed),)), homework.papers, Rules()).graded
    assert (one.verdict, one.mistakes) == ("wrong", ("power-of-ten",))
    assert said in one.feedback
