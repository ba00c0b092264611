"""The point of a guide by a second name belongs to the body that has a point at that place."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.problem.structure import load_text

LADDER = """
title: Ladder that slides down a wall
plane: vertical
points: {A: [0, 75 cm], B: [1 m, 0], Q: [0, 0.75 m]}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - guide: {point: Q, along: 90 deg}
  - guide: {point: B, along: 0 deg}
instant: [v(A).y = -2 m/s]
find: {value: omega(rod)}
"""


@pytest.mark.parametrize(
    ("text", "value"),
    [
        # v_A = ω × r_A/B with r_A/B = [-1, 0.75] m has the y component -ω · 1 m.
        (LADDER, 2.0),
        (LADDER.replace("v(A)", "v(Q)"), 2.0),
        (LADDER.replace("omega(rod)", "v(Q).y"), -2.0),
    ],
)
def test_a_second_name(text: str, value: float) -> None:
    assert_close(solve(text)["value"], value)


@pytest.mark.parametrize(
    "text",
    [
        # Where no body has a point, and where a spring is held by the second name: it may be fixed there.
        LADDER.replace("0.75 m", "0.76 m"),
        LADDER.replace(
            "instant", "loads:\n  - spring: {between: [Q, B], stiffness: 9 N/m, natural_length: 1 m}\ninstant"
        ),
    ],
)
def test_what_no_body_has(text: str) -> None:
    _, diagnostics = load_text(text)
    assert [d.code for d in diagnostics] == ["PL458"]
