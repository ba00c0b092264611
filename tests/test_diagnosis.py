"""Scenes without a solution, or with several: every file of tests/bad_solve has a golden message and exit status.

`PLANAR_UPDATE=1 pytest tests/test_diagnosis.py` writes the messages anew; read the difference before you keep it.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from planar_cli import cli
from planar_cli.errors import Diagnostic, FileProblem, NoSolution
from planar_cli.manual import explanation
from planar_cli.problem.structure import load
from planar_cli.solve.run import solve_problem

FOLDER = Path(__file__).parent / "bad_solve"
BAD = sorted(FOLDER.glob("*.yaml"))
CODES = {
    "PL513", "PL523", "PL528", "PL529", "PL536", "PL537", "PL590", "PL591", "PL601", "PL602", "PL603", "PL604", "PL605",
    "PL606", "PL607", "PL608", "PL609", "PL610", "PL611", "PL612", "PL613", "PL614", "PL615", "PL620", "PL621", "PL623",
    "PL624", "PL630", "PL631", "PL632", "PL633", "PL650", "PL651",
}  # fmt: skip


def told(path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> str:
    """What `planar solve` prints on standard error, and its exit status; nothing on standard output."""
    monkeypatch.chdir(FOLDER)
    monkeypatch.setenv("NO_COLOR", "1")
    status = cli.run(["solve", path.name])
    captured = capsys.readouterr()
    assert not captured.out
    return f"{captured.err}exit status {status}\n"


@pytest.mark.parametrize("path", BAD, ids=lambda p: p.stem)
def test_messages(path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    message = told(path, capsys, monkeypatch)
    golden = path.with_suffix(".expected")
    if os.environ.get("PLANAR_UPDATE"):
        golden.write_text(message, encoding="utf-8")
    assert message == golden.read_text(encoding="utf-8")


def test_every_diagnosis_has_a_file_and_an_explanation() -> None:
    seen = set(re.findall(r"PL\d+", "".join(p.with_suffix(".expected").read_text(encoding="utf-8") for p in BAD)))
    assert seen == CODES
    assert all(explanation(code).startswith(code) for code in seen)


def diagnoses(text: str, tmp_path: Path) -> tuple[Diagnostic, ...]:
    """The diagnostics of a scene; () when it is solved."""
    path = tmp_path / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    try:
        solve_problem(problem)
    except (NoSolution, FileProblem) as error:
        return error.diagnostics
    return ()


CRANKS = """
title: Cranks in parallel
plane: vertical
given: {r: 1 m, d: 1 m}
points:
  O: [0, 0]
  A: {from: O, distance: r, angle: ANGLE}
  P: [d, 0]
  B: {from: P, distance: r, angle: ANGLE}
  Q: [2*d, 0]
  C: {from: Q, distance: r, angle: ANGLE}
bodies:
  OA: {rod: [O, A], mass: 1 kg}
  PB: {rod: [P, B], mass: 1 kg}
  QC: {rod: [Q, C], mass: 1 kg}
  bar: {rod: [A, C], mass: 2 kg, points: [B]}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: P, between: [ground, PB]}
  - pin: {at: Q, between: [ground, QC]}
  - pin: {at: A, between: [OA, bar]}
  - pin: {at: B, between: [PB, bar]}
  - pin: {at: C, between: [QC, bar]}
instant: [omega(OA) = 2 rad/s]
find: {FIND}
"""


@pytest.mark.parametrize(
    ("angle", "find", "codes"),
    [
        ("60 deg", "alpha: alpha(OA)", []),
        ("60 deg", "A: reaction(A/bar)", ["PL603"]),
        ("0 deg", "alpha: alpha(OA)", ["PL611"]),
        ("180 deg", "omega: omega(QC)", ["PL611"]),
    ],
)
def test_redundant_cranks_are_no_change_point_before_they_stretch(
    angle: str, find: str, codes: list[str], tmp_path: Path
) -> None:
    text = CRANKS.replace("ANGLE", angle).replace("FIND", find)
    assert [d.code for d in diagnoses(text, tmp_path)] == codes


STRETCHED = """
title: Stretched parallelogram let go
plane: vertical
points: {O: [0, 0], A: [1 m, 0], C: [2 m, 0], B: [3 m, 0]}
bodies: {OA: {rod: [O, A], mass: 1 kg}, AB: {rod: [A, B], mass: 1 kg}, CB: {rod: [C, B], mass: MASS}}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
  - pin: {at: B, between: [AB, CB]}
  - pin: {at: C, between: [ground, CB]}
instant: [at rest]
find: {alpha: alpha(OA)}
"""


@pytest.mark.parametrize(("mass", "codes"), [("1 kg", []), ("5 kg", ["PL611"])])
def test_a_stretched_linkage_starts_only_in_ways_that_it_can_go(mass: str, codes: list[str], tmp_path: Path) -> None:
    assert [d.code for d in diagnoses(STRETCHED.replace("MASS", mass), tmp_path)] == codes


SLIDER = """
title: Crank mechanism near its dead centre
points: {O: [0, 0], A: {from: O, distance: 0.2 m, angle: ANGLE}, B: {y: 0 m, distances: {A: 0.5 m}, side: right}}
bodies: {OA: {rod: [O, A]}, AB: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
  - guide: {point: B, along: 0 deg}
instant: [GIVEN]
find: {FIND}
"""


@pytest.mark.parametrize(
    ("angle", "given", "find", "codes"),
    [
        ("0 deg", "v(B).x = 1 m/s", "omega: omega(OA)", ["PL610"]),
        ("180 deg", "v(B).x = 0 m/s", "omega: omega(OA)", ["PL610"]),
        ("0.001 deg", "v(B).x = 1 m/s", "omega: omega(OA)", []),
        ("0 deg", "omega(OA) = 1 rad/s", "v: v(B).x", []),
        ("0 deg", "v(B).y = 1 m/s", "omega: omega(OA)", ["PL607"]),
        ("30 deg", "v(B).y = 1 m/s", "omega: omega(OA)", ["PL607"]),
    ],
)
def test_dead_centres_are_told_from_what_never_moves(
    angle: str, given: str, find: str, codes: list[str], tmp_path: Path
) -> None:
    text = SLIDER.replace("ANGLE", angle).replace("GIVEN", given).replace("FIND", find)
    assert [d.code for d in diagnoses(text, tmp_path)] == codes


def test_a_mass_that_cancels_is_no_diagnosis(tmp_path: Path) -> None:
    text = (FOLDER / "mass-missing.yaml").read_text(encoding="utf-8").replace("magnitude: F", "magnitude: 0*F")
    assert diagnoses(text, tmp_path) == ()
