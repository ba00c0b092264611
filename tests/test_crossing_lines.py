"""A point where two lines cross: `lines`, or `line` beside `on`."""

from __future__ import annotations

import math

import pytest

from planar_cli.errors import Diagnostic, FileProblem, NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

TWO = """\
title: Where two lines cross
{known}
points: {{A: [0, 0], B: [{b}, 0], P: {{{place}}}}}
bodies: {{bar: {{rod: [A, P]}}}}
joints:
  - pin: {{at: A, between: [ground, bar]}}
motion: [omega(bar) = 2 rad/s]
find: {{v: v(P), AP: r(P/A).mag}}
"""


def answers(place: str, known: str = "", b: str = "500 mm") -> dict[str, tuple[float, ...]]:
    problem, wrong = load_text(TWO.format(place=place, known=known, b=b))
    assert not wrong
    return {f.name: tuple(map(float, f.values or ())) for f in solve_problem(problem).parts[0].found}


def refused(place: str) -> Diagnostic:
    problem, wrong = load_text(TWO.format(place=place, known="", b="500 mm"))
    if wrong:
        return wrong[0]
    with pytest.raises((FileProblem, NoSolution)) as error:
        solve_problem(problem)
    return error.value.diagnostics[0]


@pytest.mark.parametrize(
    "place",
    [
        "lines: [[A, 60 deg], [B, 120 deg]]",
        "lines: [[B, 120 deg], [A, 60 deg]]",
        "lines: [{through: A, angle: 60 deg}, [B, -60 deg]]",
        "line: [A, 60 deg], on: {through: B, angle: 120 deg}",
        "lines: [[A, 240 deg]], x: 250 mm",
        "on: [B, 120 deg], lines: [[A, 60 deg]]",
    ],
)
def test_two_lines_cross(place: str) -> None:
    found = answers(place)
    assert found["AP"] == pytest.approx((0.5,))
    assert found["v"] == pytest.approx((-math.sqrt(3) / 2, 0.5))


def test_mirrored_and_in_feet() -> None:
    found = answers("lines: [[A, -60 deg], [B, 240 deg]]", known="given: {b: 5 ft}", b="b")
    assert found["AP"] == pytest.approx((5,))
    assert found["v"] == pytest.approx((5 * math.sqrt(3), 5))


def test_in_letters() -> None:
    problem, _ = load_text(TWO.format(place="lines: [[A, 60 deg], [B, 120 deg]]", known="symbols: {b: m}", b="b"))
    told = {f.name: f.expressions for f in solve_problem(problem).parts[0].found}
    assert [str(e) for e in told["AP"]] == ["b"]


def test_parallel_lines_meet_nowhere() -> None:
    told = refused("lines: [[A, 60 deg], [B, -120 deg]]")
    assert told.code == "PL512"
    assert "the line through A and the line through B are parallel" in told.message


@pytest.mark.parametrize(
    ("place", "code"),
    [
        ("lines: [[A, 60 deg]]", "PL323"),
        ("lines: [[A, 60 deg], [B, 120 deg]], x: 0.2 m", "PL323"),
        ("lines: [A, 60 deg]", "PL322"),
        ("from: A, distance: 0.2 m, line: [A, 60 deg], on: [B, 120 deg]", "PL323"),
    ],
)
def test_what_is_no_two_facts(place: str, code: str) -> None:
    assert refused(place).code == code
