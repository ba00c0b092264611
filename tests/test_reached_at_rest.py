"""A last state of rest: what slows down by a root of its speed comes to it at once, and is no motion to a top."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import page_of_file

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILE = ROOT / "problems" / "motion" / "speed-that-dies-out-by-its-root.yaml"


def test_a_speed_that_dies_out_by_its_root_is_reached() -> None:
    page = page_of_file("speed-that-dies-out-by-its-root")
    assert "t_stop = t_4 = 0.9474 s" in page
    assert "never reached" not in page


def test_whether_its_time_is_asked_or_not(tmp_path: Path) -> None:
    path = tmp_path / "car.yaml"
    text = FILE.read_text().replace(", t_stop: t @ 4", "").replace(", t_stop: 0.947368 s", "")
    path.write_text(text)
    page = Terminal(200).render(narrate(solve_problem(load(str(path))[0])))
    assert "v_20 = 29.35 m/s" in page
    assert "never reached" not in page


CARS = """title: Two cars
points: {{A: [0, 0], B: [50 m, 0]}}
bodies: {{A: {{particle: A}}, B: {{particle: B}}}}
instant:
  - v(A).x = 0
  - v(A).y = -18 m/s
  - a(A).x = 0
  - a(A).y = -2 m/s^2
  - v(B).mag = 12 m/s
  - v(B).angle = -120 deg
  - a(B).t = -3 m/s^2
  - a(B).n = (12 m/s)^2/(100 m)
  - a(B).x {side}
find: {{a: a(B/A).mag}}
"""


def test_the_side_of_the_centre_of_curvature_is_what_is_open(tmp_path: Path) -> None:
    path = tmp_path / "cars.yaml"
    path.write_text(CARS.format(side="> 0"))
    with pytest.raises(NoSolution) as refused:
        solve_problem(load(str(path))[0])
    (told,) = refused.value.diagnostics
    assert told.code == "PL618"
    assert told.message.startswith("`a(B).n = (12 m/s)^2/(100 m)` holds both ways")
    assert "`a(B).x < 2 m/s^2`" in (told.hint or "")
    path.write_text(CARS.format(side="< 2 m/s^2"))
    (found,) = solve_problem(load(str(path))[0]).parts[0].found
    assert found.values is not None
    assert float(found.values[0]) == pytest.approx(5.3243, rel=1e-4)
