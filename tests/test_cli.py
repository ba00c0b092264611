"""The outer command line: exit statuses, messages, formats, and what is not imported."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest

from planar_cli import by_click, cli, help_page
from planar_cli.errors import NOWHERE, Diagnostic, FileProblem, NoSolution, PlanarError, Undecided
from planar_cli.manual import pages, topics
from planar_cli.problem.codes.codes import CODES
from planar_cli.problem.codes.codes_structure import CODES_STRUCTURE

GOOD = "title: A point\npoints: {A: [1 m, 0]}\nfind: {x: x(A)}\n"
BAD = "title: A point\npoint: {A: [1 m, 0]}\nfind: {x: 3 m}\n"


@pytest.fixture
def files(tmp_path: Path) -> Path:
    (tmp_path / "sub").mkdir()
    (tmp_path / "good.yaml").write_text(GOOD)
    (tmp_path / "sub" / "bad.yml").write_text(BAD)
    (tmp_path / "notes.txt").write_text("no problem file")
    return tmp_path


def imported(*args: str) -> set[str]:
    """The modules that a run of planar imports."""
    return imports_of("-m", "planar_cli", *args)


def imports_of(*args: str) -> set[str]:
    """The modules that a run of Python imports."""
    run = subprocess.run([sys.executable, "-X", "importtime", *args], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return {line.rpartition("|")[2].strip() for line in run.stderr.splitlines() if line.startswith("import time:")}


def test_help_imports_nothing_heavy() -> None:
    # An installation for development imports some modules at every start of Python.
    names = imported("--help") - imports_of("-c", "pass")
    assert not names & {"sympy", "numpy", "yaml", "rich", "click", "ast", "difflib", "pathlib", "re"}
    assert not any(name.startswith("planar_cli.commands.") for name in names)


def test_validate_imports_no_algebra(files: Path) -> None:
    assert not imported("validate", str(files / "good.yaml")) & {"sympy", "numpy"}


def test_help_lists_the_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["--help"]) == 0
    shown = capsys.readouterr().out
    for name in ("validate", "list", "explain", "schema", "completion"):
        assert f"  {name}" in shown


@pytest.mark.parametrize("columns", [50, 60, 72, 80, 100])
def test_the_help_page_is_that_of_click(columns: int) -> None:
    context = click.Context(by_click.cli, info_name="planar", terminal_width=min(columns - 2, help_page.WIDEST))
    assert help_page.page(min(columns - 2, help_page.WIDEST)) == by_click.cli.get_help(context)


def test_every_command_has_a_short_help_and_a_page(capsys: pytest.CaptureFixture[str]) -> None:
    context = click.Context(by_click.cli)
    for name in by_click.cli.list_commands(context):
        assert help_page.commands()[name]
        assert cli.run([name, "--help"]) == 0
    assert "Usage: planar validate" in capsys.readouterr().out


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["--version"]) == 0
    assert capsys.readouterr().out.startswith("planar, version ")


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (["valdate"], "Did you mean 'validate'?"),
        (["qqqqqqq"], "There are "),
        (["validate"], "Missing argument"),
        (["validate", "--frmat", "json", "x"], "--format"),
        (["explain", "roppe"], "did you mean 'rope'?"),
        (["explain", "PL999"], "there is no page"),
        (["completion", "tcsh"], "Invalid value"),
    ],
)
def test_wrong_usage(args: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(args) == 2
    assert said in capsys.readouterr().err


def test_validate_text(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["validate", str(files / "good.yaml")]) == 0
    assert capsys.readouterr().out == "1 file read, all right\n"
    assert cli.run(["validate", str(files)]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert "bad.yml:2:1: PL310 unknown key 'point'" in told.err
    assert "did you mean 'points'?" in told.err
    assert "2 files read, 1 with errors" in told.err


def test_validate_a_set(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With its problem files, each once; finds that the set speaks of are there."""
    (bad,) = (p.relative_to(files) for p in files.rglob("bad.yml"))
    (files / "set.yaml").write_text(f"problems: [{{file: good.yaml, ask: {{speed: how fast}}}}, {bad}, none.yaml]\n")
    assert cli.run(["validate", str(files / "set.yaml")]) == 2
    told = capsys.readouterr().err
    assert "the problem file none.yaml of the set is not there" in told
    assert "bad.yml:2:1" not in told
    (files / "set.yaml").write_text(f"problems: [{{file: good.yaml, ask: {{speed: how fast}}}}, {bad}]\n")
    assert cli.run(["validate", str(files)]) == 2
    told = capsys.readouterr().err
    assert "has no find 'speed'" in told
    assert told.count("bad.yml:2:1: PL310") == 1
    assert "3 files read, 2 with errors" in told


def test_validate_json(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["validate", "--format", "json", str(files)]) == 2
    told = json.loads(capsys.readouterr().out)
    assert told["schema_version"] == 1
    assert len(told["files"]) == 2
    assert told["diagnostics"][0]["code"] == "PL310"
    assert (told["diagnostics"][0]["line"], told["diagnostics"][0]["column"]) == (2, 1)


def test_validate_github(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["validate", "--format", "github", str(files)]) == 2
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 1
    assert lines[0].startswith("::error file=")
    assert ",line=2,col=1,title=PL310::unknown key" in lines[0]


def test_missing_files_and_empty_folders(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["validate", str(tmp_path / "none.yaml")]) == 2
    assert "PL101" in capsys.readouterr().err
    assert cli.run(["validate", str(tmp_path)]) == 2
    assert "no problem files" in capsys.readouterr().err


def test_standard_input() -> None:
    command = [sys.executable, "-m", "planar_cli", "validate", "-"]
    run = subprocess.run(command, input=BAD, capture_output=True, text=True, check=False)
    assert run.returncode == 2
    assert "<stdin>:2:1: PL310" in run.stderr
    assert "  point: {A: [1 m, 0]}" in run.stderr
    assert "\x1b[" not in run.stderr


def test_colour_is_asked_for(files: Path) -> None:
    command = [sys.executable, "-m", "planar_cli", "validate", str(files)]
    plain = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "FORCE_COLOR")}
    for more, coloured in (({"FORCE_COLOR": "1"}, True), ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False), ({}, False)):
        run = subprocess.run(command, capture_output=True, text=True, check=False, env={**plain, **more})
        assert ("\x1b[" in run.stderr) is coloured


def test_list(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["list"]) == 0
    assert "  rope " in capsys.readouterr().out
    assert cli.run(["list", str(files / "good.yaml"), "--format", "json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["problems"][0]["title"] == "A point"
    assert told["problems"][0]["find"] == ["x"]
    assert cli.run(["list", str(files)]) == 2


def test_explain_everything(capsys: pytest.CaptureFixture[str]) -> None:
    listed = topics()
    for topic, page in pages().items():
        assert topic in listed
        assert cli.run(["explain", topic]) == 0
        assert capsys.readouterr().out.strip() == page.strip()
        assert max(len(line) for line in page.splitlines()) <= 122
    for code in {**CODES, **CODES_STRUCTURE}:
        assert cli.run(["explain", code.lower()]) == 0
    assert cli.run(["explain"]) == 0


def test_schema_and_completion(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["schema"]) == 0
    assert json.loads(capsys.readouterr().out)["$schema"].startswith("http://json-schema.org/draft-07/")
    for shell in ("bash", "zsh", "fish"):
        assert cli.run(["completion", shell]) == 0
        assert "_PLANAR_COMPLETE" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("error", "status"),
    [
        (FileProblem([Diagnostic(NOWHERE, "PL310", "unknown key")]), 2),
        (NoSolution([Diagnostic(NOWHERE, "PL310", "one datum is missing")]), 1),
        (Undecided("not within 10 s"), 3),
        (PlanarError("no"), 2),
        (ZeroDivisionError("oops"), 4),
    ],
)
def test_exit_statuses(
    error: Exception, status: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(_: str) -> str:
        raise error

    monkeypatch.delenv("PLANAR_DEBUG", raising=False)
    monkeypatch.setattr("planar_cli.commands.explain.explanation", fail)
    assert cli.run(["explain", "rope"]) == status
    told = capsys.readouterr().err
    assert "Traceback" not in told
    assert told


def test_our_own_fault_is_shown_on_request(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: str) -> str:
        raise ZeroDivisionError

    monkeypatch.setenv("PLANAR_DEBUG", "1")
    monkeypatch.setattr("planar_cli.commands.explain.explanation", fail)
    with pytest.raises(ZeroDivisionError):
        cli.run(["explain", "rope"])
