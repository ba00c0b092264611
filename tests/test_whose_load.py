"""Loads of which the file does not say on which body they act, and other spellings of their keys."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.problem.structure import load_text

BAR = """
title: Bar turned by a force at its end
plane: horizontal
points: {A: [0, 0], C: [1 m, 0]}
bodies: {bar: {rod: [A, C], mass: 3 kg}, ball: {particle: [3 m, 0], mass: 1 kg}}
joints:
  - pin: {at: A, between: [ground, bar]}
loads:
  - LOAD
instant: [at rest]
find: {alpha: alpha(bar)}
"""

MAN = """
title: Parachutist
plane: vertical
bodies: {man: {particle: [0, 0], mass: 80 kg}}
loads:
  - drag: {LOAD}
instant: [v(man).x = 0, v(man).y = -20 m/s]
find: {a: a(man).y}
"""

TWO = """
title: Two bars
plane: horizontal
points: {A: [0, 0], B: [1 m, 0], C: [2 m, 0], D: [5 m, 0]}
bodies: {AB: {rod: [A, B], mass: 2 kg}, BC: {rod: [B, C], mass: 3 kg}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
loads:
  - LOAD
instant: [at rest]
find: {a: alpha(AB)}
"""


@pytest.mark.parametrize(
    "load",
    [
        "force: {at: C, magnitude: 6 N, angle: 90 deg}",
        "force: {point: C, body: bar, magnitude: 6 N, angle: 90 deg}",
        "torque: {moment: 6 N*m}",
    ],
)
def test_the_body_of_a_load(load: str) -> None:
    assert_close(solve(BAR.replace("LOAD", load))["alpha"], 6)


@pytest.mark.parametrize(
    ("keys", "a"),
    [
        ("quadratic: 0.25 kg/m", -9.81 + 0.25 * 400 / 80),
        ("linear: 25 kg/s", -9.81 + 25 * 20 / 80),
        ("body: man, linear: 1 kg/s, quadratic: 0.25 kg/m", -9.81 + (0.25 * 400 + 20) / 80),
        ("magnitude: 0.25 kg/m * v(man).mag^2", -9.81 + 0.25 * 400 / 80),
    ],
)
def test_drag_by_its_coefficient(keys: str, a: float) -> None:
    assert_close(solve(MAN.replace("LOAD", keys))["a"], a)


@pytest.mark.parametrize(
    ("load", "message", "hint"),
    [
        (
            "force: {at: B, magnitude: 6 N, angle: 90 deg}",
            "the force needs the key 'body': B is a point of AB and BC",
            "write `body: AB` or `body: BC`",
        ),
        (
            "force: {at: D, magnitude: 6 N, angle: 90 deg}",
            "the force needs the key 'body': D is a point of no body",
            "write `body: AB` or `body: BC`",
        ),
        (
            "torque: {moment: 6 N*m}",
            "the torque needs the key 'body': it may act on AB or BC",
            "write `body: AB` or `body: BC`, or `between: [a, b]`: on b, reversed on a",
        ),
    ],
)
def test_refused(load: str, message: str, hint: str) -> None:
    _, diagnostics = load_text(TWO.replace("LOAD", load))
    assert [d.message for d in diagnostics] == [message]
    assert diagnostics[0].hint == hint or not hint


def test_a_guide_of_a_point_or_of_a_body() -> None:
    guide = "guide: {body: BC, at: C, along: 0 deg}"
    _, diagnostics = load_text(TWO.replace("loads:\n  - LOAD\n", "").replace("pin: {at: B, between: [AB, BC]}", guide))
    assert [d.code for d in diagnostics] == ["PL314"]
    assert diagnostics[0].hint == "write `point: C` when its body may turn, `body: BC` when it cannot"


def test_the_unit_of_a_coefficient() -> None:
    _, diagnostics = load_text(MAN.replace("LOAD", "quadratic: 3 kg"))
    assert len(diagnostics) == 1
    assert diagnostics[0].message.startswith("quadratic of the drag")
