"""`planar check` of problem files that is ended early, taken up again, parted, and of which a worker dies."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest
from answered import HELD_ROD

from planar_cli import cli
from planar_cli.homework.checking import checked_files
from planar_cli.homework.checking.checking import Checked

ROD = f"{HELD_ROD}find: {{alpha: alpha(rod)}}\nanswers: {{alpha: 4.905 rad/s^2 cw}}\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "in").mkdir()
    for name in "abcdef":
        (tmp_path / "in" / f"{name}.yaml").write_text(ROD)
    return tmp_path / "in"


@pytest.mark.parametrize("form", ["jsonl", "csv", "terminal"])
def test_an_interrupt_prints_what_is_done(folder: Path, form: str) -> None:
    """The command is interrupted as soon as two files stand in its results."""
    results = folder.parent / "results"
    for name in "ghijklmnopqrstuvwxyz":
        (folder / f"{name}.yaml").write_text(ROD)
    command = [sys.executable, "-m", "planar_cli", "check", str(folder), "--jobs", "1", "--format", form]
    process = subprocess.Popen([*command, "--results", str(results)], stdout=-1, stderr=-1, text=True)
    with process:
        while process.poll() is None and (not results.exists() or results.read_bytes().count(b"\n") < 2):
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        out, told = process.communicate()
    assert process.returncode == 130
    assert "of 26 problems were checked" in told
    done = results.read_bytes().count(b"\n")
    assert 2 <= done < 26
    assert out.count(f"{folder}{os.sep}") >= 2


def test_a_second_run_solves_what_is_missing_or_changed(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    command = ["check", str(folder), "--jobs", "1", "--format", "jsonl", "--results", str(folder.parent / "results")]
    assert cli.run(command) == 0
    first = capsys.readouterr().out
    (folder / "b.yaml").write_text(ROD.replace("4.905", "4.8"))
    (folder / "c.yaml").unlink()
    solved: list[str] = []
    monkeypatch.setattr(checked_files, "_as_they_end", _noted(solved))
    assert cli.run(command) == 1
    assert [Path(p).name for p in solved] == ["b.yaml"]
    second = {json.loads(line)["file"]: json.loads(line) for line in capsys.readouterr().out.splitlines()}
    for line in map(json.loads, first.splitlines()):
        if Path(line["file"]).name in ("a.yaml", "d.yaml", "e.yaml", "f.yaml"):
            assert second[line["file"]] == line
    assert [Path(p).name for p in second] == ["a.yaml", "b.yaml", "d.yaml", "e.yaml", "f.yaml"]


def _noted(solved: list[str]) -> Callable[..., Iterator[tuple[int, Checked]]]:
    plain = checked_files._as_they_end

    def as_they_end(items: Sequence[checked_files._Item], jobs: int, timeout: float) -> Iterator[tuple[int, Checked]]:
        solved.extend(item.path for item in items)
        return plain(items, jobs, timeout)

    return as_they_end


def test_shards_are_all_files_once_and_are_merged(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = []
    for k in (1, 2, 3):
        files.append(str(folder.parent / f"r{k}"))
        assert cli.run(["check", str(folder), "--shard", f"{k}/3", "--results", files[-1]]) == 0
    capsys.readouterr()
    assert cli.run(["merge", *files]) == 0
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [Path(line["file"]).stem for line in lines] == list("abcdef")
    assert {line["result"]["outcome"] for line in lines} == {"agrees"}


DIED = "PLANAR_TEST_DIED"


def die_once(item: checked_files._Item) -> Checked:
    """A worker that dies over a file, for good over another."""
    marker = Path(os.environ[DIED])
    if item.path.endswith("b.yaml") and not marker.exists():
        marker.write_text("")
        os._exit(7)
    if item.path.endswith("d.yaml"):
        os._exit(8)
    return Checked(item.path, "", "agrees")


def test_a_file_over_which_a_worker_died_is_tried_once_more(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(DIED, str(folder.parent / "died"))
    monkeypatch.setattr(checked_files, "_check", die_once)
    heard: list[Checked] = []
    paths = [str(folder / f"{name}.yaml") for name in "abcde"]
    assert checked_files.check_files(paths, 2, 60, heard.append, lambda done: None) == 0
    assert [one.path for one in heard] == paths
    assert [one.outcome for one in heard] == ["agrees", "agrees", "agrees", "fault", "agrees"]


def test_results_of_submissions_are_not_taken_for_those_of_problems(folder: Path) -> None:
    results = folder.parent / "results"
    line = {"file": "x", "content": "", "key": "", "part": 0, "parts": 1, "result": {"student": "anna", "graded": []}}
    results.write_text(json.dumps(line) + "\n")
    assert cli.run(["check", str(folder), "--results", str(results)]) == 2


def test_a_pipe_among_the_files_is_not_waited_for(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    os.mkfifo(folder / "p.yaml")
    command = ["check", str(folder / "a.yaml"), str(folder / "p.yaml"), "--results", str(folder.parent / "results")]
    assert cli.run(command) == 2
    assert "it is not a regular file" in capsys.readouterr().err


def test_data_keep_their_letters_where_a_terminal_has_none(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    (folder / "a.yaml").write_text(re.sub(r"title: .*", "title: Stab, der fällt", ROD))
    assert cli.run(["check", str(folder / "a.yaml"), "--format", "jsonl"]) == 0
    assert "Stab, der fällt" in capsys.readouterr().out
