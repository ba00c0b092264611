"""What moves with the same acceleration: the relative velocity is constant, and the places are not needed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking import read, solve_and_compare
from planar_cli.report.narrate import narrate

CARS = """
title: One car comes up to another
given: {{v0: 20 m/s}}
bodies:
  A: {{particle: [0, 0]}}
  B: {{particle: [30 m, 0]}}
motion: [a(A).x = {rate} m/s^2, a(B).x = 2 m/s^2, v(A).y = 0, v(B).y = 0]
states:
  1: [t = 0, v(A).x = v0, v(B).x = 5 m/s]
  2: [x(A) = x(B) - 6 m]
find: {{t: t @ 2}}
"""


def _page(tmp_path: Path, rate: str) -> tuple[str, float]:
    file = tmp_path / "cars.yaml"
    file.write_text(CARS.format(rate=rate))
    solution, _ = solve_and_compare(read(str(file)), None)
    (answer,) = solution.parts[0].found
    assert answer.values is not None
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solution))), float(answer.values[0])


def test_a_way_apart_that_closes_at_a_constant_speed(tmp_path: Path) -> None:
    page, t = _page(tmp_path, "2")
    assert t == pytest.approx(24 / 15)
    assert "A and B have the same acceleration, so that their relative velocity is constant, up to" in page
    assert "1/2" not in page


def test_other_accelerations_have_places_over_time(tmp_path: Path) -> None:
    page, t = _page(tmp_path, "3")
    assert t == pytest.approx(-15 + 273**0.5)
    assert "relative velocity is constant" not in page


def test_balls_that_meet_in_the_air() -> None:
    page = page_of_file("ex-1-15")
    assert "Relative motion: with the same acceleration the relative velocity is constant." in page
    assert "their relative velocity is constant, up to x_A = x_B and y_A = y_B:" in page
    assert "(7) 0 = x_A,start + (v_Ax,start - v_Bx,start) t_meet" in page
    assert "1/2 g t_meet²" not in page
    assert "STEP 2 Motion over time" in page


def test_a_ball_that_is_let_go_meets_one_that_is_thrown_up() -> None:
    assert "(3): t_meet = H/v0" in page_of_file("thrown-and-dropped")
