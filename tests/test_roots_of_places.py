"""A place that what is given tells in two ways is chosen by the file; a distance is not negative."""

from __future__ import annotations

import pytest

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

ARM = """
title: Arm whose end is so far to the right
given: {{l: 2 m}}
coordinates: {{theta: deg}}
points: {{O: [0, 0], B: {{from: O, distance: l, angle: theta}}}}
bodies: {{arm: {{rod: [O, B]}}}}
joints: [pin: {{at: O, between: [ground, arm]}}]
instant: [x(B) = 1 m, omega(arm) = 2 rad/s{chosen}]
find: {{{find}}}
"""
COLLAR = """
title: Collar on an arm, so far from a post
coordinates: {r: m}
points: {O: [0, 0], A: [3 m, 0], P: {from: O, distance: r, angle: 30 deg}}
bodies: {p: {particle: P}}
instant: [r(P/A).mag = 4 m]
find: {r: r}
"""


def answer(text: str) -> float:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return float((solve_problem(problem).parts[0].found[0].values or ())[0])


def test_the_file_chooses_between_two_places() -> None:
    problem, _ = load_text(ARM.format(chosen="", find="v: v(B)"))
    assert problem is not None
    with pytest.raises(NoSolution) as refused:
        solve_problem(problem)
    why = refused.value.diagnostics[0]
    assert (why.code, why.message) == (
        "PL635",
        "theta = 60 deg; or theta = -60 deg: with each of them all equations hold",
    )
    assert "`theta < 0`" in why.hint


@pytest.mark.parametrize(("chosen", "value"), [(", y(B) > 0", -3.4641), (", theta < 0", 3.4641)])
def test_an_inequality_chooses(chosen: str, value: float) -> None:
    assert answer(ARM.format(chosen=chosen, find="v: v(B).x")) == pytest.approx(value, rel=1e-4)


def test_what_is_the_same_in_both_places_is_answered() -> None:
    assert answer(ARM.format(chosen="", find="v: v(B).mag")) == pytest.approx(4)


def test_a_distance_is_not_negative() -> None:
    assert answer(COLLAR) == pytest.approx(6.306, rel=1e-4)
