"""Couples with their sense, right numbers with another unit, degrees that were not written, and angles on which nothing
rests.
"""

from __future__ import annotations

import pytest
from homework_made import graded, homework_of, set_of

from planar_cli.homework.sets.ready import Homework

ARM = """
title: Collar on a driven arm
plane: horizontal
given: {m: 1.5 kg, m_arm: 3 kg, L: 0.9 m, r: 0.4 m, omega: 4 rad/s, alpha: 6 rad/s^2, F: 5 N, theta: 30 deg}
unknowns: {M: N*m}
points: {O: [0, 0], A: {from: O, distance: L, angle: theta}, B: {from: O, distance: r, angle: theta}}
bodies: {arm: {rod: [O, A], mass: m_arm}, collar: {particle: B, mass: m}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: B, along: arm, name: slot}
loads:
  - torque: {body: arm, moment: M}
  - force: {body: collar, magnitude: F, towards: O}
instant: [omega(arm) = omega, alpha(arm) = alpha, v(collar/arm).along(arm) = 0.8 m/s]
find: {M: M, a_rel: a(collar/arm).along(arm)}
"""


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("arm"), arm=ARM))


@pytest.mark.parametrize(
    ("typed", "verdict", "sign"),
    [
        ("10.14 N*m", "right", "right"),
        ("10.14 N*m ccw", "right", "right"),
        ("10.14 N*m cw", "wrong", "wrong"),
    ],
)
def test_a_couple_that_is_sought_has_a_sense(homework: Homework, typed: str, verdict: str, sign: str) -> None:
    found = graded(homework, "arm.M", typed)
    assert (found.verdict, found.sign) == (verdict, sign)
    assert found.expected.endswith("counterclockwise")


def test_the_right_number_with_another_unit(homework: Homework) -> None:
    found = graded(homework, "arm.M", "10.14 lbf*ft")
    assert (found.value, found.unit) == ("right", "wrong")
    assert "it is not lbf·ft" in found.message


def test_degrees_that_were_not_written_are_told(homework: Homework) -> None:
    found = graded(homework, "arm.a_rel", "16*0.4*sin(30) m/s^2")
    assert found.verdict == "ungradable"
    assert "write sin(30 deg)" in found.message
    assert graded(homework, "arm.a_rel", "16*0.4*sin(0.6) m/s^2").verdict == "wrong"


def test_an_angle_on_which_nothing_rests_is_no_mistake(homework: Homework) -> None:
    (task,) = homework.papers[0].tasks
    expected = next(e for e in task.expected if e.find == "a_rel")
    assert "sine-for-cosine" not in {m.name for m in expected.mistakes}
