"""Mistakes at a slider-crank: a part of the accelerations of one bar left out, a speed of rotation not converted."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from homework_made import homework_of, mistakes_of, set_of

from planar_cli.homework.grading.carried_errors import Carrier, unpickled
from planar_cli.homework.grading.grading import grade
from planar_cli.homework.sets.paper import Graded, Submission
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.rules import Rules

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


AT_TWO = """
given: {r: 60 mm, h: 150 mm, n: 10 rad/s}
coordinates: {theta: deg}
points:
  O: [0, 0]
  C: [0, -h]
  P: {from: O, distance: r, angle: theta}
  D: {from: C, towards: P, distance: 0.3 m}
bodies: {crank: {rod: [O, P]}, arm: {rod: [C, D]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: C, between: [ground, arm]}
  - guide: {point: P, along: arm}
motion: [omega(crank) = n]
states: {one: [theta = 0 deg], other: [theta = 140 deg]}
find:
  alpha_1: alpha(arm) @ one
  alpha_2: alpha(arm) @ other
  ratio: omega(arm) @ one / (omega(arm) @ other)
"""
"""Two instants of a quick return, the crank at an angle that is a coordinate."""


def by_hand(theta: float, coriolis: float = 1.0) -> tuple[float, float]:
    """ω and α of the arm: those of the line CP, by polar coordinates ρ, φ about C."""
    r, h, n = 0.06, 0.15, 10.0
    x, y = r * math.cos(theta), h + r * math.sin(theta)
    rho, phi = math.hypot(x, y), math.atan2(y, x)
    e, t = (math.cos(phi), math.sin(phi)), (-math.sin(phi), math.cos(phi))
    v, a = (-r * n * math.sin(theta), r * n * math.cos(theta)), (-n * n * x, -n * n * r * math.sin(theta))
    omega, rate = (v[0] * t[0] + v[1] * t[1]) / rho, v[0] * e[0] + v[1] * e[1]
    return omega, (a[0] * t[0] + a[1] * t[1] - coriolis * 2 * rate * omega) / rho


def test_mistakes_are_known_at_each_of_several_instants(tmp_path: Path) -> None:
    found = {e.find: e for e in mistakes_of(tmp_path, AT_TWO)}
    for find, theta in (("alpha_1", 0.0), ("alpha_2", math.radians(140))):
        assert found[find].values == pytest.approx((by_hand(theta)[1],), rel=1e-9)
        wrong = [m.values for m in found[find].mistakes if m.name == "coriolis-left-out"]
        assert wrong[0] == pytest.approx((by_hand(theta, 0.0)[1],), rel=1e-9)
    assert found["ratio"].values == pytest.approx((by_hand(0.0)[0] / by_hand(math.radians(140))[0],), rel=1e-9)
    assert any(m.name == "power-of-ten" for m in found["ratio"].mistakes)


POLAR = """
given: {u: 3 m/s, w: 4 rad/s}
plane: horizontal
coordinates: {phi: deg, s: m}
points: {C: [0, 0], Q: {from: C, distance: s, angle: phi}}
motion: [dot(phi) = w, dot(s) = u]
instant: [phi = 30 deg, s = 0.4 m]
find: {a: a(Q).mag, a_x: a(Q).x}
"""


def test_parts_of_an_acceleration_are_known_where_places_are_differentiated(tmp_path: Path) -> None:
    found = {e.find: {m.name: m.values for m in e.mistakes} for e in mistakes_of(tmp_path, POLAR)}
    # s φ̇² = 6.4 and 2 ṡ φ̇ = 24 m/s².
    assert found["a"]["coriolis-left-out"] == pytest.approx((6.4,))
    assert found["a"]["centripetal-left-out"] == pytest.approx((24.0,))
    assert found["a_x"]["coriolis-left-out"] == pytest.approx((-6.4 * math.cos(math.radians(30)),))
