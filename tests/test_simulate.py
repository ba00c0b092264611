"""`planar simulate`: what it prints, in every output, and what it refuses."""

from __future__ import annotations

import io
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from answered import LEVEL_ROD
from test_cli import imported

from planar_cli import cli

ROD = f"""{LEVEL_ROD}\
states:
  1: [t = 0, at rest]
  2: [theta(rod) = -90 deg]
find: {{t_2: t @ 2, omega: omega(rod) @ 2, R: reaction(O) @ 2, way: path_length(A) @ 1->2, low: y(A) @ 2 < -0.9 m}}
"""
CRATE = """\
title: Crate on a rough floor
plane: vertical
given: {mu: 0.3, v_0: 3 m/s, c: 2 N*s/m}
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {crate: {particle: C, mass: 10 kg}}
joints:
  - contact: {between: [crate, floor], at: C, mu: mu}
loads:
  - drag: {body: crate, magnitude: c*v(crate).mag}
states:
  1: [t = 0, v(crate).x = v_0]
  2: [at rest]
find: {s: x(crate) @ 2 - x(crate) @ 1, held: mode(C) @ 2, W: work(C) @ 1->2}
"""


@pytest.fixture
def rod(tmp_path: Path) -> str:
    return written(tmp_path, ROD)


def written(folder: Path, text: str) -> str:
    path = folder / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def run(capsys: pytest.CaptureFixture[str], *args: str, status: int = 0) -> str:
    assert cli.run(["simulate", *args]) == status, capsys.readouterr().err
    return capsys.readouterr().out


def data(capsys: pytest.CaptureFixture[str], *args: str, status: int = 0) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(run(capsys, *args, "--output", "json", status=status))
    return found["motions"][0]


def test_a_rod_that_swings_down(rod: str, capsys: pytest.CaptureFixture[str]) -> None:
    answers = data(capsys, rod)["answers"]
    omega = math.sqrt(3 * 9.81)
    assert answers["omega"]["value"] == pytest.approx(-omega, rel=1e-9)
    assert abs(answers["omega"]["value"] + omega) <= answers["omega"]["error"]
    assert answers["R"]["value"] == pytest.approx([0, 2.5 * 2 * 9.81], abs=1e-7)
    assert answers["way"]["value"] == pytest.approx(math.pi / 2, rel=1e-9)
    assert answers["low"]["value"] is True


def test_the_table_has_what_is_asked_for(rod: str, capsys: pytest.CaptureFixture[str]) -> None:
    shown = run(capsys, rod, "-q", "v(A).mag in km/h", "-q", "E=KE(rod) + PE(rod)", "--rows", "3")
    assert "v(A).mag in km/h [km/h]" in shown
    assert shown.index("E [J]") < shown.index("Answer")


def test_numbers_for_programs(rod: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, rod, "--output", "csv", "--rows", "5").splitlines()
    assert lines[0] == "t [s],x(rod) [m],y(rod) [m],theta(rod) [deg]"
    assert len(lines) == 6
    target = tmp_path / "motion.npz"
    run(capsys, rod, "--output", "npz", "-o", str(target), "--rows", "5")
    arrays = np.load(io.BytesIO(target.read_bytes()))
    assert arrays["y(rod) [m]"][-1] == pytest.approx(-0.5)


def test_it_ends_where_it_is_told_to(rod: str, capsys: pytest.CaptureFixture[str]) -> None:
    found = data(capsys, rod, "--stop", "y(A) = -0.5 m", status=cli.UNDECIDED)
    assert found["rows"][-1][2] == pytest.approx(-0.25)
    assert "2" not in found["states"]
    found = data(capsys, rod, "--until", "0.1 s", status=cli.UNDECIDED)
    assert found["rows"][-1][0] == pytest.approx(0.1)
    assert found["missed"] == ["2"]


def test_without_friction_it_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path, CRATE)
    found = data(capsys, path, "--without", "drag")
    deceleration, drag = 0.3 * 9.81, 0.2
    # v' = -mu g - c v/m
    stop = math.log(1 + drag * 3 / deceleration) / drag
    way = 3 / drag - deceleration / drag * stop
    assert found["answers"]["s"]["value"] == pytest.approx(way, rel=1e-8)
    assert found["answers"]["held"]["value"] == "stick"
    assert found["answers"]["W"]["value"] == pytest.approx(-10 * deceleration * way, rel=1e-8)
    assert found["without"]["s"]["value"] == pytest.approx(9 / (2 * deceleration), rel=1e-8)


def test_the_ledger_names_the_lines(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shown = run(capsys, written(tmp_path, CRATE), "--effects")
    for words, line in (("drag", 10), ("friction", 8), ("weight", 6)):
        assert any(words in row and row.endswith(f"line {line}") for row in shown.splitlines())
    assert "Not in this scene:" in shown
    absent = shown.partition("Not in this scene:")[2]
    assert "spring" in absent


def test_what_is_not_there_costs_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def operations(text: str) -> int:
        shown = json.loads(run(capsys, written(tmp_path, text), "--effects", "--output", "json"))
        found: int = shown["effects"][0]["operations"]
        return found

    bare = CRATE.replace("loads:\n  - drag: {body: crate, magnitude: c*v(crate).mag}\n", "")
    assert operations(bare) < operations(CRATE)
    assert operations(bare.replace(", c: 2 N*s/m", "")) == operations(bare)


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (["--without", "drafg"], "no effect 'drafg'"),
        (["--until", "3 kg"], "is no time"),
        (["--case", "other"], "there is no case other"),
        (["-q", "v(Q).x"], "Q"),
        (["--set", "3"], "no name with a value"),
        (["--stop", "y(A) ="], "--stop:1"),
    ],
)
def test_options_that_can_not_be_meant(
    rod: str, args: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run(["simulate", rod, *args]) == cli.BAD
    assert said in capsys.readouterr().err


def test_letters_get_numbers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = ROD.replace("plane:", "symbols: {m: kg}\nplane:").replace("mass: 2 kg", "mass: m")
    path = written(tmp_path, text)
    assert cli.run(["simulate", path]) == cli.BAD
    assert "PL705" in capsys.readouterr().err
    assert data(capsys, path, "--set", "m=2 kg")["answers"]["R"]["value"][1] == pytest.approx(49.05)


def test_it_needs_no_algebra(rod: str) -> None:
    assert not imported("simulate", rod) & {"sympy", "numpy", "scipy", "mpmath"}


PUCK = """\
title: Puck thrown back by a wall
plane: horizontal
points: {A: [0, 0], W: [3 m, 0]}
surfaces: {wall: {through: W, angle: 90 deg}}
bodies: {puck: {particle: A, mass: 2 kg}}
joints:
  - flat: {between: [puck, ground], mu: 0.1, name: table}
  - impact: {between: [puck, wall], restitution: 0.5, during: 2->3, name: hit}
states:
  1: [t = 0, v(puck).x = 4 m/s, v(puck).y = 0]
  2: [x(puck) = 3 m]
  3: [just after 2]
  4: [v(puck).mag = 0]
find: {x: x(puck) @ 4, W: work(table) @ 1->2, back: work(table) @ 3->4}
"""


def test_sliding_goes_on_the_other_way_after_an_impact(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    answers = data(capsys, written(tmp_path, PUCK))["answers"]
    found = {name: a["value"] for name, a in answers.items()}
    after = 0.25 * (16 - 2 * 0.981 * 3)
    assert found["x"] == pytest.approx(3 - after / (2 * 0.981), rel=1e-10)
    assert found["W"] == pytest.approx(-0.1 * 2 * 9.81 * 3, rel=1e-10)
    assert found["back"] == pytest.approx(-after, rel=1e-10)
    assert answers["W"]["unit"] == "J"


def test_a_case_that_is_refused_does_not_keep_the_others_back(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cases = "cases:\n  sought:\n    unknowns: {c: N*s/m}\n    find: {c: c}\n"
    file = written(tmp_path, CRATE + cases)
    out = run(capsys, file, status=3)
    assert "held = stick" in out
    assert "CASE  sought" in out
    assert "PL705 the unknown c has no number" in out
    motions = json.loads(run(capsys, file, "--output", "json", status=3))["motions"]
    assert [("refused" in m, m["case"]) for m in motions] == [(False, ""), (True, "sought")]
    run(capsys, file, "--output", "npz", "-o", str(tmp_path / "motion.npz"), status=3)


SWAYING = """\
title: Block on a spring
plane: horizontal
given: {{m: 2 kg, k: 200 N/m, a: 0.1 m}}
points: {{W: [-1 m, 0], P: [0.1 m, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg, name: rail}}
loads:
  - spring: {{between: [W, P], stiffness: k, natural_length: 1 m, name: coil}}
states:
  1: [t = 0, at rest]
  2: [t = {end!r} s]
find: {{way: path_length(P) @ 1->2}}
"""


@pytest.mark.parametrize("past", [1e-7, 1e-4, 1e-3, 0.02, 0.1, 0.3])
def test_the_length_of_a_way_there_and_back(past: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """x = a cos(10/s t) has come to its third turning and gone on for a little."""
    end = (3 * math.pi + past) / 10
    found = data(capsys, written(tmp_path, SWAYING.format(end=end)), "--tolerance", "1e-12")
    way = 0.1 * (6 + 2 * math.sin(past / 2) ** 2)
    assert found["answers"]["way"]["value"] == pytest.approx(way, rel=1e-11)


TROLLEY = """\
title: A crane trolley that is pushed away from above its load
plane: vertical
points: {A: [0, 0], B: [0, -2 m]}
bodies:
  trolley: {particle: A, mass: 3 kg}
  load: {particle: B, mass: 10 kg}
joints:
  - guide: {point: A, along: 0 deg, name: rail}
  - rope: {path: [A, B], along: 90 deg, name: rope}
loads:
  - force: {body: trolley, magnitude: 6 N, angle: 0 deg}
states: {1: [at rest], 2: [t = 1 s]}
find: {x: x(load) @ 2}
"""


@pytest.mark.parametrize(
    ("mass", "status", "place"), [(", mass: 3 kg", cli.DISAGREES, "9:5: PL539"), ("", cli.UNDECIDED, "5:3: PL702")]
)
@pytest.mark.parametrize("output", ["table", "csv"])
def test_of_what_is_refused_there_is_no_table(
    mass: str, status: int, place: str, output: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A rope that does not stay upright; a trolley without mass, which forces do not move."""
    path = written(tmp_path, TROLLEY.replace(", mass: 3 kg", mass))
    assert cli.run(["simulate", path, "--output", output]) == status
    shown = capsys.readouterr()
    assert shown.out == ""
    assert f"{path}:{place}" in shown.err
