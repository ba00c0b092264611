"""An `instant` whose time nobody writes down, but whose relations tell it."""

from __future__ import annotations

import math
import re

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ALONG = """
title: Along a line
bodies: {{P: {{particle: free}}}}
motion: ["x(P) = {law}", y(P) = 0]
instant: ["{now}"]
find: {{t: t, v: v(P).x, far: x(P) > 1 m}}
"""
TURNING = """
title: Turning rod
points: {{A: [0, 0], B: [0.3 m, 0]}}
bodies: {{r: {{rod: [A, B]}}}}
joints: [{{pin: {{at: A, between: [r, ground]}}}}]
motion: ["{law}"]
instant: ["{now}"]
find: {{t: t, a: a(B).mag}}
"""
PUSHED = """
title: Growing force
plane: horizontal
bodies: {{b: {{particle: [0, 0], mass: 2 kg}}}}
loads: [{{force: {{body: b, magnitude: 3 N/s * t, angle: 0 deg}}}}]
instant: [at rest{now}]
find: {{t: t}}
"""


@pytest.mark.parametrize(
    ("law", "now", "t", "v"),
    [
        ("2 m/s * t", "x(P) = 3 m", 1.5, 2),
        ("2 m/s * t + 1 m/s^3 * t^3", "x(P) = 3 m", 1, 5),
        ("2 m/s^2 * t^2", "x(P) = 8 m", 2, 8),
        ("2 m/s^3 * t^3", "v(P).x = 24 m/s", 2, 24),
        ("2 m/s * t + 1 m * sin(1 rad/s * t)", "x(P) = 3 m", 1.0630731, 2 + math.cos(1.0630731)),
    ],
)
def test_a_place_or_a_speed_tells_when_it_is(law: str, now: str, t: float, v: float) -> None:
    found = solve(ALONG.format(law=law, now=now))
    assert first(found["t"]) == pytest.approx(t)
    assert first(found["v"]) == pytest.approx(v)
    assert found["far"].word == "true"


def test_a_turning_rod() -> None:
    found = solve(TURNING.format(law="omega(r) = 2 rad/s^2 * t", now="omega(r) = 6 rad/s"))
    assert first(found["t"]) == pytest.approx(3)
    assert first(found["a"]) == pytest.approx(0.3 * math.hypot(2, 36))


def test_of_two_times_the_one_that_is_not_negative() -> None:
    found = solve(TURNING.format(law="theta(r) = 2 rad/s^2 * t^2", now="theta(r) = 60 deg"))
    assert first(found["t"]) == pytest.approx(math.sqrt(math.pi / 6))


@pytest.mark.parametrize(
    ("law", "now", "chosen", "t", "why"),
    [
        ("1 m/s^3 * t^3 - 3 m/s * t", "v(P).mag = 5 m/s", "t > 0 s", math.sqrt(8 / 3), "1.633 s"),
        ("1 m/s^3 * t^3 - 3 m/s * t", "v(P).mag = 5 m/s", "t < 0 s", -math.sqrt(8 / 3), "the negative root: t_1 < 0 s"),
        ("1 m/s^2 * t^2 - 6 m/s * t", "x(P) = -8 m", "t > 3 s", 4, "the root for which t_1 > 3 s"),
        ("1 m/s^2 * t^2 - 6 m/s * t", "x(P) = -8 m", "0.05 min > t", 2, "the first such time after the start"),
    ],
)
def test_an_inequality_chooses_among_several_times(law: str, now: str, chosen: str, t: float, why: str) -> None:
    text = ALONG.format(law=law, now=f'{now}", "{chosen}')
    assert first(solve(text)["t"]) == pytest.approx(t)
    problem, _ = load_text(text)
    assert problem is not None
    line = next(x for x in Terminal().render(narrate(solve_problem(problem))).splitlines() if re.search(r"  t_1 = ", x))
    assert line.endswith(why), "of two roots of one size the positive one needs no word"


def test_a_force_that_grows() -> None:
    assert first(solve(PUSHED.format(now=", a(b).x = 6 m/s^2"))["t"]) == pytest.approx(4)


@pytest.mark.parametrize(
    "text", [TURNING.format(law="omega(r) = 2 rad/s^2 * t", now="v(A).x = 0"), PUSHED.format(now="")]
)
def test_where_nothing_tells_when_it_is_that_is_asked_for(text: str) -> None:
    with pytest.raises(FileProblem) as refused:
        solve(text)
    assert refused.value.diagnostics[0].code == "PL590"
