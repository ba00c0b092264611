"""Parts of the acceleration left out in the forces on what slides along an arm, or moves in polar coordinates."""

from __future__ import annotations

import pytest
from homework_made import graded, homework_of, set_of

from planar_cli.homework.sets.ready import Homework

ARM = """
plane: horizontal
given:
  {m: 1.5 kg, m_arm: 3 kg, L: 0.9 m, r: 0.4 m, omega: 4 rad/s, alpha: 6 rad/s^2, v_rel: 0.8 m/s, F: 5 N, theta: 30 deg}
unknowns: {M: N*m}
points: {O: [0, 0], A: {from: O, distance: L, angle: theta}, B: {from: O, distance: r, angle: theta}}
bodies:
  arm: {rod: [O, A], mass: m_arm}
  collar: {particle: B, mass: m}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: B, along: arm, name: slot}
loads:
  - torque: {body: arm, moment: M, name: motor}
  - force: {body: collar, magnitude: F, towards: O}
instant: [omega(arm) = omega, alpha(arm) = alpha, v(collar/arm).along(arm) = v_rel]
find: {M: M, N: N(slot), a_rel: a(collar/arm).along(arm), a: a(collar).mag}
"""
# By hand: N = m (2 v ω + r α) = 13.2 N, M = m_arm L² α/3 + N r, a_rel = r ω² - F/m = 3.067 m/s².
CORIOLIS, NORMAL, TANGENTIAL = "coriolis-left-out", "centripetal-left-out", "tangential-left-out"


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("arm"), arm=ARM))


@pytest.mark.parametrize(
    ("find", "typed", "mistake"),
    [
        ("N", "3.60 N", CORIOLIS),
        ("M", "6.30 N*m", CORIOLIS),
        ("N", "9.60 N", TANGENTIAL),
        ("a_rel", "-3.333 m/s^2", NORMAL),
        ("a", "4.107 m/s^2", CORIOLIS),
        ("a", "7.216 m/s^2", TANGENTIAL),
    ],
)
def test_a_part_is_missing(homework: Homework, find: str, typed: str, mistake: str) -> None:
    one = graded(homework, f"arm.{find}", typed)
    assert (one.verdict, one.mistakes) == ("wrong", (mistake,))
