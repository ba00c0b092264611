"""Errors carried forward into what is read off a motion: it is followed again with the student's own value."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from homework_made import homework_of, set_of

from planar_cli.homework.grading.carried_errors import Carrier, unpickled
from planar_cli.homework.grading.grading import grade
from planar_cli.homework.sets.paper import Graded, Submission
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.rules import Rules

# A wind that rises and falls with the place: there is no closed form over time.
SLED = """
plane: horizontal
given: {m: 2 kg, J: 12 N*s}
points: {A: [0, 0]}
bodies: {sled: {particle: A, mass: m}}
joints:
  - guide: {point: A, along: 0 deg, name: rail}
cases:
  kick:
    loads:
      - impulse: {body: sled, at: A, magnitude: J, angle: 0 deg, during: 1->2}
    states: {1: [at rest], 2: [just after 1]}
    find: {v_0: v(sled).x @ 2}
  way:
    given: {u: kick.v_0}
    loads:
      - spring: {between: [A, [0 - 1 m, 0]], stiffness: 3 N/m, natural_length: 1 m}
      - force: {body: sled, at: A, magnitude: 0.4 N * (1 + sin(x(sled)/(1 m))), angle: 180 deg, name: wind}
    states:
      1: [x(A) = 0, v(sled).x = u]
      2: [t = 0.5 s]
      3: [v(sled).x = 0]
    find: {v_2: v(sled).x @ 2, x_3: x(A) @ 3, t_3: t @ 3}
"""


def by_hand(x: float, v: float, t: float, until: float | None) -> tuple[float, float, float]:
    """Place, velocity and time at a time, or where it stops, by small steps of the midpoint rule."""

    def a(x: float) -> float:
        return -1.5 * x - 0.2 * (1 + math.sin(x))

    h = 2e-4
    while (v > 0) if until is None else (t < until - h / 2):
        middle = x + v * h / 2
        v, x, t = v + a(middle) * h, x + (v + a(x) * h / 2) * h, t + h
    return x, v, t


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("sled"), sled=SLED))


def graded(homework: Homework, **typed: str) -> dict[str, Graded]:
    submission = Submission("ann", 0, tuple(("sled", find, text) for find, text in typed.items()))
    carry = Carrier(unpickled(homework.carrying)).for_variant(0)
    return {g.find: g for g in grade(submission, homework.papers, Rules(), carry).graded}


def test_a_datum_of_the_motion_is_carried(homework: Homework) -> None:
    _, v_2, _ = by_hand(0.0, 5.0, 0.0, 0.5)
    x_3, _, t_3 = by_hand(0.0, 5.0, 0.0, None)
    found = graded(homework, v_0="5 m/s", v_2=f"{v_2:.4g} m/s", x_3=f"{x_3:.4g} m", t_3=f"{t_3:.4g} s")
    assert found["v_0"].verdict == "wrong"
    for find in ("v_2", "x_3", "t_3"):
        assert found[find].carried == ("v_0",)


def test_the_motion_goes_on_from_an_own_velocity(homework: Homework) -> None:
    x_2, _, _ = by_hand(0.0, 6.0, 0.0, 0.5)
    x_3, _, t_3 = by_hand(x_2, 4.0, 0.5, None)
    found = graded(homework, v_0="6 m/s", v_2="4 m/s", x_3=f"{x_3:.4g} m", t_3=f"{t_3:.4g} s")
    assert found["v_2"].verdict == "wrong"
    assert found["t_3"].carried == ("v_2",)
    assert found["x_3"].carried == ("v_2",)


def test_mistakes_are_known_behind_an_earlier_case(homework: Homework) -> None:
    found = {e.find: {m.name: m.values for m in e.mistakes} for t in homework.papers[0].tasks for e in t.expected}
    x, v, h = 0.0, 6.0, 1e-4
    for _ in range(5000):
        v, x = v - 0.2 * (1 + math.sin(x)) * h, x + v * h
    assert found["v_2"]["spring-left-out"] == pytest.approx((v,), rel=1e-3)


def test_what_does_not_follow_is_not_carried(homework: Homework) -> None:
    found = graded(homework, v_0="5 m/s", v_2="4.4 m/s", t_3="1.5 s")
    assert not found["v_2"].carried
    assert not found["t_3"].carried


VARIED = SLED + "variants: {J: [8 N*s, 12 N*s]}\n"


def test_it_is_followed_with_the_data_of_the_variant(tmp_path: Path) -> None:
    from planar_cli.homework.homework import assembled, prepared

    homework_set = set_of(tmp_path, "variants: {number: 2, seed: 1}", sled=VARIED)
    homework = assembled(homework_set, [prepared(p, 2, 1) for p in homework_set.problems])
    for variant, paper in homework.papers.items():
        right = {e.find: e.values[0] for t in paper.tasks for e in t.expected}
        x_2, _, _ = by_hand(0.0, right["v_0"], 0.0, 0.5)
        own = 0.8 * right["v_2"]
        _, _, t_3 = by_hand(x_2, own, 0.5, None)
        typed = (("sled", "v_2", f"{own:.5g} m/s"), ("sled", "t_3", f"{t_3:.4g} s"))
        carry = Carrier(unpickled(homework.carrying)).for_variant(variant)
        result = grade(Submission("ann", variant, typed), homework.papers, Rules(), carry)
        assert next(g for g in result.graded if g.find == "t_3").carried == ("v_2",)
