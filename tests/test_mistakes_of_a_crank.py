"""Mistakes at a slider-crank: a part of the accelerations of one bar left out, a speed of rotation not converted."""

from __future__ import annotations

import pytest
from homework_made import homework_of, set_of

from planar_cli.homework.carried_errors import Carrier, unpickled
from planar_cli.homework.grading import grade
from planar_cli.homework.paper import Graded, Submission
from planar_cli.homework.ready import Homework
from planar_cli.homework.rules import Rules

CRANK = """
given: {r: 80 mm, l: 220 mm, e: 40 mm, n: 150 rpm, phi: 50 deg}
points:
  O: [0, 0]
  A: {from: O, distance: r, angle: phi}
  B: {x: e, distances: {A: l}, side: above}
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - guide: {point: B, along: 90 deg}
motion: [omega(crank) = n]
find: {v_A: v(A), omega_AB: omega(rod), v_B: v(B).y, alpha_AB: alpha(rod), a_B: a(B).y}
"""
# By hand: r cos φ = 51.42, r sin φ = 61.28, y_B - r sin φ = 219.7, e - r cos φ = -11.42 mm; ω = 15.708 rad/s.


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("crank"), crank=CRANK))


def graded(homework: Homework, **typed: str) -> dict[str, Graded]:
    submission = Submission("ann", 0, tuple(("crank", find, text) for find, text in typed.items()))
    carry = Carrier(unpickled(homework.carrying)).for_variant(0)
    return {g.find: g for g in grade(submission, homework.papers, Rules(), carry).graded}


@pytest.mark.parametrize(
    ("find", "typed", "mistake", "said"),
    [
        # a_B = -r ω² sin φ + α (e - r cos φ) with α (y_B - r sin φ) = -r ω² cos φ, without the terms of ω_AB².
        ("a_B", "14.46 m/s^2 down", "centripetal-left-out", "the normal acceleration ω_rod² r is missing"),
        ("omega_AB", "41.84 rad/s cw", "given-not-converted", "n was put in with the number of rpm"),
        # r ω cos φ stands for r ω sin φ, while y_B is right.
        ("omega_AB", "3.676 rad/s cw", "sine-for-cosine", "exchanged in one place"),
        ("v_A", "[-0.1532, 0.1285] m/s", "given-not-converted", "2π is missing"),
        ("v_A", "[-9.193, 7.713] m/s", "given-not-converted", "without conversion"),
        ("alpha_AB", "5175 rad/s^2 cw", "given-not-converted", "without conversion"),
        ("alpha_AB", "5180 rad/s^2 cw", "given-not-converted", "without conversion"),
    ],
)
def test_it_is_named(homework: Homework, find: str, typed: str, mistake: str, said: str) -> None:
    one = graded(homework, **{find: typed})[find]
    assert one.mistakes == (mistake,)
    assert said in one.feedback


def test_an_own_vector_is_carried(homework: Homework) -> None:
    # v_A 10 % too small; ω_AB and v_B follow from it.
    found = graded(homework, v_A="[-0.8664, 0.7270] m/s", omega_AB="3.943 rad/s cw", v_B="0.7720 m/s")
    assert found["v_A"].verdict == "wrong"
    assert found["omega_AB"].carried == ("v_A",)
    assert found["v_B"].carried == ("v_A",)


def test_an_own_vector_is_carried_beside_a_right_value(homework: Homework) -> None:
    # ω_AB is right: v_B = 0.7270 + 0.01142 · 4.3815.
    found = graded(homework, v_A="[-0.8664, 0.7270] m/s", omega_AB="4.3815 rad/s cw", v_B="0.7770 m/s")
    assert found["omega_AB"].verdict == "right"
    assert found["v_B"].carried == ("v_A",)


def test_what_does_not_follow_is_not_carried(homework: Homework) -> None:
    found = graded(homework, v_A="[-0.8664, 0.7270] m/s", omega_AB="3.5 rad/s cw", v_B="0.9 m/s")
    assert not found["omega_AB"].carried
    assert not found["v_B"].carried
