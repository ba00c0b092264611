"""`planar accuracy`: what it prints of one file and of several, and what it refuses."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest
from answered import LEVEL_ROD

from planar_cli import cli
from planar_cli.problem.structure import load_text
from planar_cli.simulate.subject import SceneSubject

ROD = f"""{LEVEL_ROD}\
states:
  1: [t = 0, at rest]
  2: [t = 2 s]
find: {{omega: omega(rod) @ 2}}
"""
BALL = """\
title: Ball that is dropped
plane: vertical
given: {e: 0.5}
points: {P: [0, 1 m], O: [0, 0]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {ball: {particle: P, mass: 1 kg}}
joints:
  - impact: {between: [ball, floor], restitution: e}
states:
  1: [t = 0, at rest]
  2: [t = 1 s]
"""
QUICK = ["--tolerance", "1e-6", "--tolerance", "1e-9"]


@pytest.fixture
def rod(tmp_path: Path) -> str:
    path = tmp_path / "rod.yaml"
    path.write_text(ROD, encoding="utf-8")
    return str(path)


def run(capsys: pytest.CaptureFixture[str], *args: str, status: int = 0) -> str:
    assert cli.run(["accuracy", *args]) == status, capsys.readouterr().err
    return capsys.readouterr().out


def test_one_file_as_a_table(capsys: pytest.CaptureFixture[str], rod: str) -> None:
    out = run(capsys, rod, *QUICK, "--integrator", "dop853", "--integrator", "rk4", "--step", "0.01 s")
    assert out.startswith("Rod let go level\n")
    assert "dop853" in out
    assert "rk4" in out
    assert "1.00e-02 s" in out
    assert "6 digits: " in out
    assert "`planar solve` takes" in out


def test_errors_and_estimates_of_a_scene(capsys: pytest.CaptureFixture[str], rod: str) -> None:
    data = json.loads(run(capsys, rod, *QUICK, "--integrator", "dop853", "--format", "json"))
    for row in data["rows"]:
        assert 0.0 < row["error"] < 1e3 * row["tolerance"]
        assert 0.1 <= row["estimated_error"] / row["error"] <= 10.0
        assert row["energy_error"] < 100 * row["tolerance"]
    assert data["reference"]["uncertainty"] < 1e-11


def test_csv_has_a_line_for_every_run(capsys: pytest.CaptureFixture[str], rod: str) -> None:
    rows = list(csv.DictReader(io.StringIO(run(capsys, rod, *QUICK, "--integrator", "dop853", "--format", "csv"))))
    assert [float(r["tolerance"]) for r in rows] == [1e-6, 1e-9]


def test_a_folder_gets_a_line_for_every_scene(capsys: pytest.CaptureFixture[str], rod: str) -> None:
    (Path(rod).parent / "open.yaml").write_text(ROD.replace("mass: 2 kg", "mass: m"), encoding="utf-8")
    out = run(capsys, str(Path(rod).parent), *QUICK, status=2)
    (line,) = [line for line in out.splitlines() if line.startswith("Rod let go level")]
    assert "ms" in line


def test_an_end_of_its_own(capsys: pytest.CaptureFixture[str], rod: str) -> None:
    assert "to t = 0.5 s" in run(capsys, rod, *QUICK, "--integrator", "dop853", "--until", "0.5 s")


def test_a_start_that_is_displaced_stays_on_the_joints() -> None:
    problem, _ = load_text(ROD)
    assert problem is not None
    subject = SceneSubject(problem)
    near, far = subject.run("auto", 1e-9), subject.run("auto", 1e-9, None, 1e-3)
    assert max(abs(a - b) for a, b in zip(near.path(0.0), far.path(0.0), strict=True)) > 1e-4
    assert far.drift < 1e-6


def test_runs_that_meet_impacts_are_compared_at_them() -> None:
    problem, wrong = load_text(BALL)
    assert problem is not None, wrong
    subject = SceneSubject(problem)
    coarse, fine = subject.run("auto", 1e-6), subject.run("auto", 1e-12)
    assert coarse.met == fine.met
    assert any(words.startswith("impact") for words in coarse.met)
    assert max(abs(a - b) for a, b in zip(coarse.values, fine.values, strict=True)) < 1e-10


BRAKING = """
title: A block slips to rest
plane: vertical
points: {A: [0, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {block: {particle: A, mass: 2 kg}}
joints: [{contact: {between: [block, floor], mu: 0.3}}]
states:
  start: [t = 0, v(block).x = 3 m/s]
  end: [mode(block) = stick]
find: {t_end: t @ end}
"""


@pytest.mark.slow
def test_a_start_beside_that_of_what_slides_slides_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "braking.yaml"
    file.write_text(BRAKING, encoding="utf-8")
    assert cli.run(["accuracy", str(file)]) == 0
    assert "A unit in the last place at the start is 3.5e+00 units at the end" in capsys.readouterr().out
