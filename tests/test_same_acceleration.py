"""What moves with the same acceleration: the relative velocity is constant, and the places are not needed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import ROOT
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

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
    assert "A and B fall freely, with the same acceleration, so that their relative velocity is constant" in page
    assert "They meet if it points along BA:" in page
    assert "across BA: v_B sin(150° - β) = v_A sin(150° - 30°)" in page
    assert "β = 150° - 60° = 90° not 30°: they would stay as far apart as at first" in page
    assert "along BA: D = (v_B cos(150° - β) - v_A cos(150° - 30°)) t_meet" in page
    assert "t_meet = D/(v_B cos 60° - v_A cos 120°) = D/(50 m/s)" in page
    assert "1/2 g t_meet²" not in page
    assert "ΣF" not in page


def test_components_where_an_angle_is_no_number_of_degrees(tmp_path: Path) -> None:
    text = (ROOT / "problems" / "textbook" / "ex-1-15.yaml").read_text(encoding="utf-8").split("answers:")[0]
    known = "    - v(A).mag = 50 m/s\n    - v(A).angle = 30 deg\n"
    assert known in text
    file = tmp_path / "balls.yaml"
    file.write_text(text.replace(known, "    - v(A).x = 40 m/s\n    - v(A).y = 30 m/s\n"))
    solution, _ = solve_and_compare(read(str(file)), None)
    page = re.sub(r"\s+", " ", Terminal(200).render(narrate(solution)))
    assert "(3) 0 = x_A,start + (v_Ax,start - v_Bx,start) t_meet" in page
    assert "(1), (2) in (3), (4): 50 t_meet cos β = x_A,start + v_Ax,start t_meet" in page
    assert "multiplied out: D² + 30 D t_meet + 2500 t_meet² - 40 √3 D t_meet = 2500 t_meet²" in page


def test_a_ball_that_is_let_go_meets_one_that_is_thrown_up() -> None:
    assert "(3): t_meet = H/v0" in page_of_file("thrown-and-dropped")
