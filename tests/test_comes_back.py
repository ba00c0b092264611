"""A motion with blows is walked once, from state to state; what comes back does so with the same speed."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

THROWN = """
title: Ball that is thrown up while a steady force acts on it
plane: PLANE
given: {u: 5 m/s, v: 10 m/s, beta: 30 deg, F: 1 N}
bodies: {ball: {particle: [0, 0 m], mass: 0.5 kg}}
loads:
  - force: {body: ball, magnitude: F, angle: ANGLE}
states:
  1: [t = 0, v(ball).x = u, v(ball).y = v*sin(beta)]
  2: [y(ball) = 0, v(ball).y < 0]
find: {w: v(ball).y @ 2}
"""


def test_the_path_is_walked_once() -> None:
    page = page_of_file("ball-bouncing-twice")
    places = [
        page.index(said)
        for said in ("v_1 = -", "t_1 = √", "J = m", "v_4 = -", "t_4 = (v_2 - v_4)/g", "y_6 = v_5²", "t_6 = v_5")
    ]
    assert places == sorted(places)


@pytest.mark.parametrize("said", [
    "From 2 to 4, the ball comes back to the same height, with the same speed: (7) v_4 = -v_2 = -5.050 m/s",
    "J = m (v_2 - v_1) = 0.15 (5.050 - (-6.264)) = 1.697 N·s",
])  # fmt: skip
def test_short_words_and_names(said: str) -> None:
    page = page_of_file("ball-bouncing-twice")
    assert said in page
    assert not re.search(r"J_N", page)


@pytest.mark.parametrize(("plane", "angle", "said"), [
    ("vertical", "90 deg", "the ball comes back to the same height, with the same speed: (2) v_y,2 = -v_y,1 = -5 m/s"),
    ("horizontal", "-90 deg", "the ball comes back to the same place, with the same speed: (2) v_y,2 = -v_y,1"),
    ("vertical", "0 deg", "v_y,2 = -v_y,1 = -5 m/s"),
])  # fmt: skip
def test_only_what_keeps_its_speed_across(plane: str, angle: str, said: str) -> None:
    """On a table there is no height; with a force across the path the speed is another one."""
    problem, wrong = load_text(THROWN.replace("PLANE", plane).replace("ANGLE", angle))
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert said in page
    assert ("with the same speed" in page) == (angle != "0 deg")
