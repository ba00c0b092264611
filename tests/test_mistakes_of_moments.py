"""Mistakes where bodies turn about an axis: m d² left out, of one body or of all, at rest and in a blow; a rebound left
out.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.homework.grading import grade
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.paper import Graded, Submission
from planar_cli.homework.ready import Homework
from planar_cli.homework.rules import Rules
from planar_cli.homework.set_file import read_set

GATE = """
plane: vertical
given: {W: 14 lbf, l: 3.5 ft, W_D: 8 lbf, D: 40 in, beta: 30 deg, g: 32.2 ft/s^2}
points:
  A: [0, 0]
  B: {from: A, distance: l, angle: beta}
bodies:
  arm: {rod: [A, B], weight: W}
  disk: {disk: B, radius: D/2, weight: W_D}
joints:
  - pin: {at: A, between: [ground, arm]}
  - weld: {at: B, between: [arm, disk]}
states:
  1: [at rest]
  2: [theta(arm) = -90 deg]
find: {omega: omega(arm) @ 2, A: reaction(A) @ 2}
"""
# By hand: ω² = 2 (W/2 + W_D) l (1 + sin β)/I, I = (W l²/3 + W_D l² + W_D D²/8)/g.
PUTTY = """
plane: vertical
given: {v_0: 10 m/s, M: 9 kg, m: 2 kg, l: 1.2 m, b: 0.9 m, e: 0.6}
points: {A: [0, 0], B: [0, -l], P: [0, -b]}
bodies:
  rod: {rod: [A, B], mass: M}
  ball: {particle: P, mass: m}
joints:
  - pin: {at: A, between: [ground, rod]}
  - impact: {between: [ball, rod], restitution: e, normal: 0 deg, during: 1->2}
states:
  1: [rod at rest, v(ball).x = v_0, v(ball).y = 0]
  2: [just after 1]
find: {omega: omega(rod) @ 2}
"""
# By hand: ω = (1 + e) m v_0 b/(M l²/3 + m b²).


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    path: Path = tmp_path_factory.mktemp("moments") / "set.yaml"
    (path.parent / "gate.yaml").write_text(GATE)
    (path.parent / "putty.yaml").write_text(PUTTY)
    path.write_text("problems: [gate.yaml, putty.yaml]\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 0, 1) for p in homework_set.problems])


def graded(homework: Homework, problem: str, find: str, typed: str) -> Graded:
    result = grade(Submission("ann", 0, ((problem, find, typed),)), homework.papers, Rules())
    return next(g for g in result.graded if (g.problem, g.find) == (problem, find))


@pytest.mark.parametrize(
    ("problem", "typed", "mistake", "said"),
    [
        ("gate", "6.411 rad/s cw", "parallel-axis-left-out", "parallel-axis theorem is missing for arm"),
        ("gate", "8.618 rad/s cw", "parallel-axis-left-out", "parallel-axis theorem is missing for disk"),
        ("gate", "14.13 rad/s cw", "parallel-axis-left-out", "parallel-axis theorem is missing"),
        ("putty", "10.67 rad/s", "parallel-axis-left-out", "parallel-axis theorem is missing"),
        ("putty", "3.030 rad/s", "restitution-left-out", "without rebound, with e = 0"),
        ("putty", "1.212 rad/s", "restitution-left-out", "the law of restitution has the wrong sign"),
    ],
)
def test_it_is_named(homework: Homework, problem: str, typed: str, mistake: str, said: str) -> None:
    one = graded(homework, problem, "omega", typed)
    assert one.verdict == "wrong"
    assert one.mistakes == (mistake,)
    assert one.feedback.endswith(said) or said in one.feedback
