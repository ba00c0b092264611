"""Sheets of the students that a set lists: handed in as they are, with keys that are named alike."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import SLOPE, set_of

from planar_cli.cli import run


@pytest.fixture
def path(tmp_path: Path) -> Path:
    varied = f"{SLOPE}variants: {{beta: [30 deg, 33 deg, 35 deg]}}\n"
    set_of(tmp_path, "students: [ann, bob]\nvariants: {seed: 7}", slope=varied)
    return tmp_path / "set.yaml"


def test_a_sheet_as_csv_is_handed_in_as_it_is(path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    out = path.parent / "out"
    assert run(["key", str(path), "--format", "csv", "-o", str(out)]) == 0
    assert sorted(p.name for p in out.glob("*-*.csv")) == [
        *("key-1-ann.csv", "key-2-bob.csv"),
        *("sheet-1-ann.csv", "sheet-2-bob.csv"),
    ]
    right = (out / "key-2-bob.csv").read_text().splitlines()[1].split(",")[3]
    sheet = out / "sheet-2-bob.csv"
    head, line = sheet.read_text().splitlines()
    assert (head, line) == ("student,variant,problem,find,answer,unit", "bob,2,slope,a,,m/s^2")
    sheet.write_text(f"{head}\n{line.replace(',,', f',{right},')}\n")
    capfd.readouterr()
    assert run(["check", "--set", str(path), str(sheet)]) == 0
    told = capfd.readouterr().out
    assert "bob, variant 2: 1 of 1" in told
    assert "not in the list" not in told


def test_of_a_student_who_left_neither_sheet_nor_key_stays(path: Path) -> None:
    out = path.parent / "out"
    for students in ("ann, bob", "ann, cid"):
        path.write_text(path.read_text().replace("ann, bob", students))
        assert run(["key", str(path), "-o", str(out)]) == 0
    assert sorted(p.name for p in out.glob("*.md")) == [
        *("key-1-ann.md", "key-2-cid.md", "key.md"),
        *("sheet-1-ann.md", "sheet-2-cid.md"),
    ]


def test_worked_solutions_are_for_an_audience(path: Path) -> None:
    pages = {}
    for audience in ("exam", "lesson"):
        out = path.parent / audience
        assert run(["key", str(path), "--worked", "--audience", audience, "-o", str(out)]) == 0
        pages[audience] = (out / "key.md").read_text()
    assert len(pages["lesson"]) > 1.5 * len(pages["exam"])


def test_variants_that_are_not_graded_are_told(path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["key", str(path), "--variants", "1"]) == 0
    assert "write `variants: {number: 1, seed: 7}` there" in capfd.readouterr().err
    assert run(["key", str(path)]) == 0
    assert "grades by the variants" not in capfd.readouterr().err


def test_a_run_that_is_taken_up_again_prints_all(path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    handed = path.parent / "in"
    handed.mkdir()
    line = ["check", "--set", str(path), str(handed), "--results", str(path.parent / "done.jsonl")]
    for student, form in (("ann", []), ("bob", []), ("", ["--format", "csv"])):
        if student:
            (handed / f"{student}.yaml").write_text("answers: {}")
        assert run([*line, *form]) == 0
        told = capfd.readouterr().out
        assert ("ann" in told, "bob" in told) == (True, student != "ann")
        assert form or "slope.a                      nobody answered" in told


def test_names_that_no_student_reads_are_told(path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    hung = """
plane: vertical
text: A lamp of mass 2 kg hangs from a rope. Find the tension in the rope.
points: {A: [0, 0], B: [0, 1 m]}
bodies: {lamp: {particle: A, mass: 2 kg}}
joints: [{rope: {path: [B, A], name: cord}}]
instant: [at rest]
find: {T: tension(cord), a: a(lamp).mag}
"""
    (path.parent / "slope.yaml").write_text(hung)
    assert run(["validate", str(path)]) == 0
    told = capfd.readouterr().err
    assert "slope.T asks for the tension in cord, and the text does not tell 'cord'" in told
    assert "slope.a" not in told
    path.write_text(path.read_text().replace("[slope.yaml]", "[{file: slope.yaml, ask: {T: the tension in the rope}}]"))
    assert run(["validate", str(path)]) == 0
    assert "warning" not in capfd.readouterr().err
