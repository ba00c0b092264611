"""`planar check --set`, `planar key` of a set and `planar merge` as they are typed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import ROOT

from planar_cli.cli import run
from planar_cli.commands._handed_out import page
from planar_cli.errors import FileProblem
from planar_cli.homework.sets.set_file import read_set
from planar_cli.homework.submissions.submissions import contents, submissions

HOMEWORK = ROOT / "tests" / "homework"
SET, HANDED_IN = str(HOMEWORK / "three.yaml"), str(HOMEWORK / "submissions")
pytestmark = pytest.mark.xdist_group("homework")


def test_a_class_is_graded_and_taken_up_again(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    results, out = tmp_path / "done.jsonl", tmp_path / "out"
    line = ["check", "--set", SET, HANDED_IN, "--results", str(results), "--format", "json"]
    assert run([*line, "--export", "gradebook", "-o", str(out)]) == 0
    told = json.loads(capfd.readouterr().out)
    scores = {r["student"]: sum(g.get("score", 0) for g in r["graded"]) for r in told["results"]}
    assert scores == {"anna": 9, "ben": 1}
    assert "rotational-inertia-left-out" in str(told)
    assert list(out.rglob("*.csv"))
    assert run([*line, "--student"]) == 0
    again = capfd.readouterr()
    assert "2 submissions were graded before" in again.err
    merged = tmp_path / "merged.jsonl"
    assert run(["merge", str(results), "-o", str(merged)]) == 0
    assert len(merged.read_text().splitlines()) == 2


def test_students_see_nothing_of_the_key(capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["check", "--set", SET, HANDED_IN, "--student"]) == 0
    assert "key:" not in capfd.readouterr().out


@pytest.mark.parametrize(
    "form",
    [pytest.param("markdown", marks=pytest.mark.slow), "html", pytest.param("json", marks=pytest.mark.slow), "csv"],
)
def test_sheets_and_key(form: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    folders = [tmp_path / "a", tmp_path / "b"]
    for folder in folders:
        assert run(["key", SET, "--format", form, "--variants", "2", "-o", str(folder), "--export", "text2qti"]) == 0
    first, second = (sorted(p.relative_to(f) for p in f.rglob("*") if p.is_file()) for f in folders)
    assert first == second
    assert len([p for p in first if p.name.startswith("sheet-") and p.suffix != ".svg"]) == 2
    assert all((folders[0] / p).read_bytes() == (folders[1] / p).read_bytes() for p in first)


def test_a_worked_key_as_html_has_no_raw_formulas(tmp_path: Path) -> None:
    line = ["key", str(HOMEWORK / "three.yaml"), "--both", "--format", "html", "--variants", "1"]
    assert run([*line, "-o", str(tmp_path)]) == 0
    page = (tmp_path / "key.html").read_text()
    assert "$$" not in page
    assert "\\frac" not in page
    assert "<pre>" not in page
    assert page.count("<mfrac>") > 3


def test_a_sheet_tells_what_is_asked_and_how_to_hand_in(tmp_path: Path) -> None:
    (tmp_path / "slot.yaml").write_text(
        "text: A block of {m}.\nplane: horizontal\ngiven: {m: 2 kg, beta: 20 deg, mu_k: 0.2}\n"
        "variants: {m: [2 kg, 3 kg]}\nbodies: {b: {particle: [0, 0], mass: m}}\nloads:\n"
        "  - force: {body: b, magnitude: 10 N, angle: beta}\n"
        "find: {s: 2*a(b).x - 1 m/s^2, n: 3*a(b).y, u: a(b).x}\n"
    )
    problem = "{file: slot.yaml, ask: {n: three times the acceleration upward}}"
    path = tmp_path / "set.yaml"
    path.write_text(f"problems: [{problem}]\nvariants: {{number: 2}}\nstudents: [Anna B, '../x']\n")
    assert run(["key", str(path), "-o", str(tmp_path / "out"), "--format", "html"]) == 0
    names = sorted(p.name for p in (tmp_path / "out").glob("sheet*.html"))
    assert names == ["sheet-1-anna-b.html", "sheet-2-x.html"]
    page = (tmp_path / "out" / names[0]).read_text()
    assert "<title>set, variant 1, Anna B</title>" in page
    assert "2*a(b)" not in page
    assert "<math><mi>s</mi></math>, in m/s²" in page
    assert "<math><mi>n</mi></math>: three times the acceleration upward, in m/s²" in page
    assert "Also given: <math><mi>β</mi><mo>=</mo><mn>20</mn>" in page
    assert "<msub><mi>μ</mi><mi>k</mi></msub><mo>=</mo><mn>0.2</mn></math>" in page
    assert "slot.s:  # 12.3 m/s^2" in page
    assert "Give 3 significant figures" in page


def test_the_example_of_a_sheet_can_be_read(tmp_path: Path) -> None:
    from planar_cli.homework.homework import assembled, prepared
    from planar_cli.homework.sets.sheets import Handed
    from planar_cli.homework.submissions.submissions import contents, submissions
    from planar_cli.report.document.handed_out import sheet

    path = tmp_path / "set.yaml"
    path.write_text(f"problems: [{HOMEWORK / 'slot.yaml'}]\n")
    homework_set = read_set(str(path))
    homework = assembled(homework_set, [prepared(p, 0, 1) for p in homework_set.problems])
    text = page(sheet(homework, Handed("sheet", 0, "O'Neil: 1")), "", "markdown").decode()
    assert "x counts to the right, y upward" in text
    filled = tmp_path / "filled.yaml"
    filled.write_text(text.split("```")[1].removeprefix("text\n").replace("#", ""))
    (read,) = submissions(contents(str(filled)))
    assert (read.student, read.wrong) == ("O'Neil: 1", ())
    assert read.answers[0] == ("slot", "v", "12.3 m/s")
    assert [find for _, find, _ in read.answers] == [e.find for e in homework.papers[0].tasks[0].expected]


def test_what_stands_in_the_text_is_not_given_again() -> None:
    from planar_cli.homework.homework import prepared

    (_, spool, _) = read_set(SET).problems
    file, *_ = prepared(spool, 0, 1).tasks
    assert file.given == ()


@pytest.mark.slow
def test_sheets_of_an_earlier_run_do_not_stay(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path, out = tmp_path / "set.yaml", tmp_path / "out"
    path.write_text(f"problems: [{HOMEWORK / 'slope.yaml'}]\n")
    assert run(["key", str(path), "--variants", "3", "-o", str(out)]) == 0
    (out / "sheet-2.md").write_text("my own notes")
    (out / "sheet-9.md").write_text("my own sheet")
    (out / "notes.md").write_text("mine")
    capfd.readouterr()
    assert run(["key", str(path), "--variants", "1", "-o", str(out), "--format", "csv"]) == 0
    names = sorted(p.name for p in out.iterdir())
    assert names == [".planar-key.json", "key.csv", "notes.md", "sheet-1.csv", "sheet-2.md", "sheet-9.md"]
    told = capfd.readouterr().err
    assert "sheet-2.md is not of this run" in told
    assert "sheet-9.md is not of this run" in told


def test_the_key_tells_senses_as_the_page_does() -> None:
    from planar_cli.homework.homework import prepared

    (*_, rod) = read_set(SET).problems
    told = [e.text for e in prepared(rod, 0, 1).tasks[0].expected]
    assert told == ["12.26 rad/s² clockwise", "14.72 N upward", "14.72 m/s² downward"]


def test_what_cannot_be_read_is_told_once(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "eve.yaml").write_text("answers: {slope: {a: 3 m/s^2\n")
    run(["check", "--set", SET, str(tmp_path)])
    told = capfd.readouterr().out
    assert told.count("this cannot be graded:") == told.count("this mapping is never closed") == 1
    assert "slope.a ungradable" not in told


def test_a_filled_in_sheet_is_a_submission(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["key", SET, "--format", "csv", "--variants", "1", "-o", str(tmp_path / "out")]) == 0
    sheet = (tmp_path / "out" / "sheet-1.csv").read_text()
    assert sheet.splitlines()[0] == "variant,problem,find,answer,unit"
    name = tmp_path / "mia.csv"
    name.write_text(sheet.replace(",,", ",1,"))
    (handed,) = submissions(contents(str(name)))
    assert (handed.student, handed.variant, handed.wrong) == ("mia", 1, ())
    assert all(text.startswith("1 ") for _, _, text in handed.answers)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("problems: [a.yaml, a.yaml]", "two problems have the name 'a'"),
        ("problems: [a.yaml]\ntolerance: 2", "does not fit the tolerance"),
        ("problems: [a.yaml]\ncredit: {units: 1}", "unknown key 'units'"),
        ("problems: [a.yaml]\ntolerance: 0.01\nsigfig: 3", "exclude each other"),
        ("problems: [a.yaml]\nvariants: {number: 0}", "does not fit the number of variants"),
        ("title: x", "needs the key 'problems'"),
        ("problems: [a.yaml]\nstudents: [s, s]", "stands twice"),
    ],
)
def test_what_is_wrong_with_a_set_is_told(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "set.yaml"
    path.write_text(text)
    with pytest.raises(FileProblem) as told:
        read_set(str(path))
    assert any(message in d.message for d in told.value.diagnostics)


def test_a_find_that_is_not_there_is_told(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "set.yaml"
    path.write_text(f"problems: [{{file: {HOMEWORK / 'rod.yaml'}, points: {{beta: 2}}}}]")
    assert run(["key", str(path)]) == 2
    assert "PL802" in capfd.readouterr().err


@pytest.mark.parametrize("command", ["solve", "check"])
def test_a_set_is_no_problem_file(command: str, capfd: pytest.CaptureFixture[str]) -> None:
    assert run([command, SET]) == 2
    told = "".join(capfd.readouterr())
    assert told.count("PL") == 1
    assert "this is a homework set" in told
    assert "use `planar key` or `planar check --set`" in told


def test_a_missing_problem_file_is_told_where_the_set_names_it(tmp_path: Path) -> None:
    path = tmp_path / "set.yaml"
    path.write_text("problems:\n  - {file: slop.yaml, points: 2}\n")
    with pytest.raises(FileProblem) as told:
        read_set(str(path))
    (one,) = told.value.diagnostics
    assert (one.code, one.mark.line, one.mark.column) == ("PL101", 2, 12)
    assert "slop.yaml of the set is not there" in one.message


def test_where_no_variant_is_fit_the_reasons_are_told(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    slope = (HOMEWORK / "slope.yaml").read_text().partition("variants:")[0]
    # On so gentle a slope the block is slowed down by friction.
    (tmp_path / "slope.yaml").write_text(f"{slope}variants: {{beta: [5 deg, 8 deg]}}\n")
    path = tmp_path / "set.yaml"
    path.write_text("problems: [slope.yaml]\nvariants: {number: 2}\n")
    assert run(["key", str(path)]) == 2
    told = capfd.readouterr().err
    assert "1:12: PL804 no variant of slope is fit" in told
    assert "of 2 combinations none: 1 because " in told
    assert "the mistake normal-force-is-weight gives nearly the right a" in told


def test_options_of_a_set_need_one(capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["check", "--student", str(HOMEWORK / "rod.yaml")]) == 2
    assert "belongs to --set" in capfd.readouterr().err


def test_what_rounding_does(capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["check", "--tolerance-report", str(HOMEWORK / "spool.yaml")]) == 0
    told = capfd.readouterr().out
    assert "rounding to 3 figures" in told
    assert "would fail an honest student" in told


@pytest.mark.parametrize("form", ["jsonl", "csv", "junit", "github", "markdown"])
def test_forms_of_a_check(form: str, capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["check", str(HOMEWORK / "rod.yaml"), str(HOMEWORK / "slot.yaml"), "--format", form]) == 0
    told = capfd.readouterr().out
    assert ("rod.yaml" in told) == (form != "github")


@pytest.mark.slow
def test_a_key_with_worked_solutions_is_not_lost(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path, out = tmp_path / "set.yaml", tmp_path / "out"
    path.write_text(f"problems: [{HOMEWORK / 'slot.yaml'}]\n")
    assert run(["key", str(path), "--both", "-o", str(out)]) == 0
    before = (out / "key.md").read_text()
    assert run(["key", str(path), "-o", str(out)]) != 0
    assert "holds worked solutions, which this run would leave out: add --both" in capfd.readouterr().err
    # A key in another format would remove it: one without steps, and one that can have none.
    for asked, way in (["--format", "html"], "add --both, or name"), (["--both", "--format", "json"], "out: name"):
        assert run(["key", str(path), *asked, "-o", str(out)]) != 0
        assert way in capfd.readouterr().err
    assert (out / "key.md").read_text() == before
    assert run(["key", str(path), "--both", "--format", "html", "-o", str(out)]) == 0
    assert not (out / "key.md").exists()
    assert "<strong>Check</strong>" in (out / "key.html").read_text()


@pytest.mark.slow
def test_names_that_make_one_file_name_have_two_files_over_several_runs(tmp_path: Path) -> None:
    path, folder = tmp_path / "set.yaml", tmp_path / "feedback"
    path.write_text(f"problems: [{HOMEWORK / 'slot.yaml'}]\n")
    for student in ("Ann Lee", "ann-lee", "Ann Lee", "ann-lee"):
        handed_in = tmp_path / "class.csv"
        handed_in.write_text(f"student,problem,find,answer\n{student},slot,v,1 m/s\n")
        assert run(["check", "--set", str(path), str(handed_in), "--feedback", str(folder)]) == 0
    told = {p.name: p.read_text().splitlines()[2] for p in folder.iterdir()}
    assert {name: line.split(":")[0] for name, line in told.items()} == {
        "ann-lee.txt": "Ann Lee",
        "ann-lee-2.txt": "ann-lee",
    }


def test_each_student_has_a_text_and_who_is_absent_is_named(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "set.yaml"
    path.write_text(f"problems: [{HOMEWORK / 'slot.yaml'}]\nstudents: [ann, bob, eve]\nvariants: {{number: 1}}\n")
    handed_in = tmp_path / "class.csv"
    handed_in.write_text("student,problem,find,answer\nann,slot,v,1 m/s\nbob,slot,v,\n")
    folder = tmp_path / "feedback"
    assert run(["check", "--set", str(path), str(handed_in), "--feedback", str(folder)]) == 0
    told = capfd.readouterr()
    assert "nothing handed in by eve" in told.err
    assert "  nothing was answered\n" in told.out
    assert sorted(p.name for p in folder.iterdir()) == ["ann.txt", "bob.txt"]
    told_to_ann = (folder / "ann.txt").read_text()
    assert "  v: `1 m/s` wrong, 0 of 1 point: the value is not right" in told_to_ann
    assert str(tmp_path) not in told_to_ann
