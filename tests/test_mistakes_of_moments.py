"""Mistakes where bodies turn about an axis: m d² left out, of one body or of all, at rest and in a blow; a rebound left
out.
"""

from __future__ import annotations

import pytest
from homework_made import BALL_ON_ROD, GATE, graded, homework_of, set_of

from planar_cli.homework.sets.ready import Homework

WIDE_GATE = GATE.replace("20 in", "40 in")
PUTTY = f"""
plane: vertical
given: {{v_0: 10 m/s, M: 9 kg, m: 2 kg, l: 1.2 m, b: 0.9 m, e: 0.6}}{BALL_ON_ROD}find: {{omega: omega(rod) @ 2}}
"""


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("moments"), gate=WIDE_GATE, putty=PUTTY))


@pytest.mark.parametrize(
    ("problem", "typed", "mistake", "said"),
    [
        ("gate", "6.411 rad/s cw", "parallel-axis-left-out", "parallel-axis theorem is missing for arm"),
        ("gate", "8.618 rad/s cw", "parallel-axis-left-out", "parallel-axis theorem is missing for disk"),
        ("gate", "14.13 rad/s cw", "parallel-axis-left-out", "parallel-axis theorem is missing"),
        ("putty", "10.67 rad/s", "parallel-axis-left-out", "parallel-axis theorem is missing"),
        ("putty", "3.030 rad/s", "restitution-left-out", "without rebound, with e = 0"),
        ("putty", "1.212 rad/s", "restitution-left-out", "e times the speed of approach is the speed of separation"),
    ],
)
def test_it_is_named(homework: Homework, problem: str, typed: str, mistake: str, said: str) -> None:
    one = graded(homework, f"{problem}.omega", typed)
    assert one.verdict == "wrong"
    assert one.mistakes == (mistake,)
    assert one.feedback.endswith(said)
