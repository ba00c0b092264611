"""Answers along and across a slope say so: up the slope, perpendicular to it."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


@pytest.mark.parametrize(
    ("stem", "answer"),
    [
        ("wheel-pulled-uphill", "friction_C = F_C = 22.08 N down the slope"),
        ("ball-on-a-rough-slope", "v_along = v_t,3 = 0.5555 m/s down the slope"),
        ("ball-on-a-rough-slope", "v_across = v_n,3 = 3.078 m/s perpendicular to the slope, upward"),
        ("ball-on-a-rough-slope", "J_t = 0.07476 N·s up the slope"),
        ("collar-on-rotating-rod", "a_across = 3.3 m/s² perpendicular to OA, counterclockwise from it"),
        ("ball-on-a-rough-floor", "0.3429 N·s to the left"),
    ],
)
def test_the_direction_of_an_answer(stem: str, answer: str) -> None:
    assert answer in Terminal(200).render(narrate(worked(FILES[stem])[0])).partition("Answer")[2]
