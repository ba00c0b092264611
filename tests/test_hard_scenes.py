"""The scenes of problems/hard: right to their stated digits, or refused by name; never wrong in silence."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from answered import BARS_IN_A_LOOP
from conftest import ROOT

from planar_cli import cli
from planar_cli.homework.checking.checking import read, solve_and_compare

HARD = sorted((ROOT / "problems" / "hard").glob("*.yaml"))
JAMMED = """\
title: Rod that jams
plane: vertical
points: {C: [0, 0], D: {from: C, distance: 2 m, angle: 60 deg}}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {rod: {rod: [C, D], mass: 1 kg}}
joints:
  - contact: {between: [rod, floor], at: C, mu: 1.5}
"""
ON_ONE_LINE = BARS_IN_A_LOOP.format(A="[0, 0]", B="[1 m, 0]", C="[2 m, 0]", D="[1 m, 0]", mass="1 kg")
CEILING = """\
title: Ball below a ceiling
plane: vertical
given: {v0: 10 m/s, h: v0^2/(2*g) %s}
points: {O: [0, 0], C: [0, h]}
surfaces: {ceiling: {through: C, angle: 0 deg}}
bodies: {ball: {particle: O, mass: 0.1 kg}}
joints:
  - impact: {between: [ball, ceiling], restitution: 1}
states:
  1: [t = 0, v(ball).x = 0, v(ball).y = v0]
  2: [t = 2 s]
"""


@pytest.mark.parametrize("path", HARD, ids=lambda p: p.stem)
def test_a_hard_scene_agrees(path: Path) -> None:
    solution, verdicts = solve_and_compare(read(str(path)))
    assert solution.problem.answers
    assert len(verdicts) == len(solution.problem.answers)
    assert not [v.message for v in verdicts if not v.agrees]


def simulated(text: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, dict[str, Any]]:
    path = folder / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    status = cli.run(["simulate", str(path), "--output", "json"])
    found = capsys.readouterr().out
    return status, json.loads(found)["motions"][0] if found else {}


def test_a_rod_that_jams_is_refused_by_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Painleve: p = 1 + 3 cos(cos - mu sin) < 0."""
    states = "states: {1: [t = 0, omega(rod) = 0, v(C).x = -1 m/s, v(C).y = 0], 2: [t = 1 s]}\n"
    status, found = simulated(JAMMED + states, tmp_path, capsys)
    assert status == cli.DISAGREES
    assert found["code"] in ("PL700", "PL701")


def test_links_on_one_line_have_a_message(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "line.yaml"
    path.write_text(ON_ONE_LINE + "instant: [omega(AB) = 1 rad/s]\nfind: {w: omega(CD)}\n", encoding="utf-8")
    status = cli.run(["solve", str(path)])
    shown = capsys.readouterr()
    assert "nan" not in (shown.out + shown.err).lower()
    assert status in (cli.SOLVED, cli.DISAGREES, cli.BAD)
    assert shown.out or "PL" in shown.err


@pytest.mark.parametrize(("gap", "contacts"), [("- 1e-6 m", 1), ("+ 1e-6 m", 0)])
def test_a_ceiling_just_in_reach(gap: str, contacts: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    _, found = simulated(CEILING % gap, tmp_path, capsys)
    assert sum(x["kind"] == "impact" for x in found["transitions"]) == contacts
