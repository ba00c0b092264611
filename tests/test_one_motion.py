"""A motion whose accelerations are all given is one step; a chase is solved for the time."""

from __future__ import annotations

import re
from unicodedata import normalize

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

CHASE = """
title: Two runners
coordinates: {x_A: m, x_B: m}
points: {A: [x_A, 0], B: [x_B, 0]}
motion:
  - dot(x_A) = 18 km/h
  - ddot(x_B) = 0 during start->go
  - ddot(x_B) = 2 m/s^2 during go->meet
states:
  start: [t = 0, x_A = 0, x_B = 0, dot(x_B) = 0]
  go: [t = 1 s]
  gap: [x_A - x_B is largest]
  meet: [x_A = x_B]
find: {d: (x_A - x_B) @ gap, t_meet: t @ meet}
"""


def page() -> str:
    problem, _ = load_text(CHASE)
    assert problem is not None
    return Terminal(100).render(narrate(solve_problem(problem)))


def test_it_is_one_step_with_the_given_speed_once() -> None:
    told = page()
    assert re.findall(r"STEP \d", told) == ["STEP 1"]
    assert "MOTION " not in told
    assert told.count("18 km/h = 5 m/s") == 1
    assert "states start, go, gap, meet" in told


def test_a_difference_stands_where_it_is_largest() -> None:
    told = page()
    assert "x_A - x_B is largest, where both change equally fast" in told
    # 5 · 3.5 - (3.5 - 1)² = 11.25 m
    assert told.index("d = ") < told.index("At meet, x_A = x_B")


def test_ways_along_different_roads_have_no_common_velocity() -> None:
    problem, _ = load_text(CHASE.replace("B: [x_B, 0]", "B: [0, x_B]"))
    assert problem is not None
    told = " ".join(Terminal(100).render(narrate(solve_problem(problem))).split())
    assert "x_A - x_B is largest, where both change equally fast: " in told


def test_both_places_are_equal_as_functions_of_the_time() -> None:
    told = " ".join(normalize("NFC", page()).split())
    assert "(6), (7) in (5): ẋ_A t_meet = 1/2 ẍ_B (t_meet - t_go)² hence: t_meet = " in told
    # 5 t = (t - 1)²: t² - 7 t + 1 = 0
    assert "= 6.854 s" in told
