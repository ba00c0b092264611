"""The numbers that exports take for right and those of mistakes: intervals that never overlap."""

from __future__ import annotations

import itertools
from dataclasses import replace

import pytest
from exported import PAPERS, number

from planar_cli.homework.exports._asked import Asked, LeftOut, Number, finds, is_numeric, numbers, problems, question_of
from planar_cli.homework.sets.paper import Expected, Mistaken, Task


def found(expected: Expected, left_out: LeftOut | None = None) -> tuple[Number, ...]:
    task = Task("p", "P", "", (), (expected,))
    return numbers(Asked(task, expected, 0), left_out or LeftOut())


def wrong(value: float, name: str = "weight-left-out") -> Mistaken:
    return Mistaken(name, "Why.", (value,))


def everything() -> list[Number]:
    asked = [a for v in problems(PAPERS).values() for of_one in finds(v).values() for a in of_one]
    return [n for a in asked if is_numeric(a.expected) for n in numbers(a, LeftOut())]


@pytest.mark.parametrize("one", everything(), ids=lambda n: n.name)
def test_intervals_are_apart(one: Number) -> None:
    for a, b in itertools.combinations((one.right, *one.turned, *one.mistakes), 2):
        assert abs(a.value - b.value) > a.tolerance + b.tolerance


def test_the_tolerance_is_that_of_the_check() -> None:
    (one,) = found(number("a", 3.2, "m/s^2"))
    assert one.right.tolerance == pytest.approx(0.01 * 3.2 + 1e-3 * 0.01 * 10)


def test_a_zero_is_measured_by_the_scale() -> None:
    (one,) = found(number("R", 0.0, "N"))
    assert one.right.tolerance == pytest.approx(1e-4)


def test_a_vector_is_measured_by_its_size() -> None:
    x, y = found(Expected("v", "v", "vector", (3.0, -4.0), "m/s", "", 0.01, 0.0))
    assert (x.name, y.name) == ("v_x", "v_y")
    assert (x.right.tolerance, y.right.tolerance) == pytest.approx((0.05, 0.05))


def test_a_list_is_asked_from_the_smallest_on() -> None:
    first, second = found(Expected("t", "t", "list", (4.0, 2.0), "s", "", 0.01, 0.0))
    assert (first.right.value, second.right.value) == (2.0, 4.0)
    assert "smallest first" in question_of(Expected("t", "t", "list", (4.0, 2.0), "s", "", 0.01, 0.0))


def test_a_direction_is_right_after_a_turn() -> None:
    (one,) = found(number("theta", 350.0, "deg", direction=True))
    assert [t.value for t in one.turned] == pytest.approx([-10.0, 710.0])


def test_a_mistake_at_the_right_answer_is_left_out_and_told() -> None:
    left_out = LeftOut()
    (one,) = found(number("a", 3.2, "N", wrong(3.205), wrong(5.0, "other-root")), left_out)
    assert [m.name for m in one.mistakes] == ["other-root"]
    (sentence,) = left_out.sentences()
    assert sentence.startswith("1 mistake has no feedback of its own")
    assert "p, a" in sentence


def test_mistakes_with_one_number_are_both_left_out_and_told() -> None:
    left_out = LeftOut()
    (one,) = found(number("a", 3.2, "N", wrong(5.0), wrong(5.001, "other-root")), left_out)
    assert not one.mistakes
    found(number("b", 3.2, "N", wrong(3.205)), left_out)
    (sentence,) = left_out.sentences()
    assert sentence.startswith("3 mistakes have no feedback of their own")
    assert "p, a; p, b" in sentence


def test_a_component_that_a_mistake_leaves_as_it_is_has_none() -> None:
    mistake = Mistaken("coriolis-left-out", "Why.", (3.0, 9.0))
    x, y = found(Expected("v", "v", "vector", (3.0, 0.0), "m/s", "", 0.01, 1.0, mistakes=(mistake,)))
    assert not x.mistakes
    assert len(y.mistakes) == 1


def test_a_mistake_that_gives_zero_has_an_interval() -> None:
    (one,) = found(replace(number("a", 3.0, "N", wrong(0.0)), scale=0.0))
    assert [(m.value, m.tolerance) for m in one.mistakes] == [(0.0, pytest.approx(0.03))]


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_what_is_no_finite_number_is_told(value: float) -> None:
    left_out = LeftOut()
    assert found(number("a", value, "N"), left_out) == ()
    assert "no finite number" in left_out.sentences()[0]


def test_sentences_name_their_variants_once() -> None:
    left_out = LeftOut()
    for variant in (0, 3, 3):
        left_out.tell("It is so", variant)
    assert left_out.sentences() == ("It is so (variants 0, 3)",)


def test_signs_are_told() -> None:
    assert "Counterclockwise is positive." in question_of(number("omega", 1.0, "rad/s", rotation=True))
    assert "Positive upward." in question_of(number("a", 1.0, "m/s^2", axis="y"))
    said = replace(number("a", 1.0, "m/s^2", axis="y"), asked="the acceleration of the crate, up the ramp positive")
    assert "Positive upward." not in question_of(said)
    assert "in m/s²" in question_of(number("a", 1.0, "m/s^2"))
