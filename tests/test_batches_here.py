"""Batches on workers of this machine: no submission costs another one its verdict, and no worker is left."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from graders import grader, no_grader

from planar_cli.errors import PlanarError
from planar_cli.homework.submissions.batches import Ran, grade_files, in_shard, shard_of
from planar_cli.homework.submissions.grader import Grading
from planar_cli.homework.tasks.results import Line, result_of, results

GRADING = Grading(grader, "key", timeout=1.0)
ENDS = {
    "5 N": "ok",
    "6 N": "ok",
    "hang": "timeout",
    "power": "timeout",
    "eat": "memory",
    "exit": "crashed",
    "raise": "crashed",
    "recursion": "crashed",
}


def hand_in(folder: Path, answers: list[str]) -> dict[str, str]:
    """A file for each answer; the answers by student."""
    folder.mkdir(exist_ok=True)
    handed = {f"s{i:03}": answer for i, answer in enumerate(answers)}
    for student, answer in handed.items():
        (folder / f"{student}.yaml").write_text(f"answers: {{p.a: {answer}}}\n")
    return handed


def lines(file: Path) -> list[dict[str, Any]]:
    return [json.loads(text) for text in file.read_text().splitlines()]


def workers(marker: str) -> list[int]:
    """The processes, by their numbers, that have a word in their environment."""
    found = []
    for folder in Path("/proc").iterdir():
        try:
            if folder.name.isdigit() and f"MARKER={marker}".encode() in (folder / "environ").read_bytes():
                found.append(int(folder.name))
        except OSError:
            continue
    return found


def test_each_submission_ends_as_it_must(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    handed = hand_in(tmp_path / "in", [*ENDS, "5 N", "once", "5 N"])
    monkeypatch.setenv("GRADED_ONCE", str(tmp_path / "flag"))
    heard: list[Line] = []
    ran = grade_files([str(tmp_path / "in")], GRADING, 2, str(tmp_path / "r"), take=heard.append)
    # A worker that ended by chance: the file is tried once more, and graded.
    ends = {**ENDS, "once": "ok"}
    assert {line.student: line.ended for line in heard} == {s: ends[a] for s, a in handed.items()}
    # In the order of the files, though those behind a file that hangs are graded before it.
    assert [line.student for line in heard] == list(handed)
    assert ran == Ran(11, 0, {"crashed": 3, "memory": 1, "ok": 5, "timeout": 2}, ())
    told = {line["result"]["student"]: line for line in lines(tmp_path / "r")}
    by_answer = {a: told[s] for s, a in handed.items()}
    assert by_answer["hang"]["result"]["wrong"] == ["ungradable (timeout): not decided within 1 s"]
    assert by_answer["exit"]["result"]["wrong"] == ["ungradable (crashed): the process ended with code 7"]
    assert by_answer["raise"]["result"]["wrong"] == ["ungradable (crashed): grading it failed"]
    # To the lecturer alone.
    assert by_answer["raise"]["why"] == "ValueError: the key is 5 N"
    assert [g["verdict"] for g in by_answer["eat"]["result"]["graded"]] == ["ungradable"]
    assert [g["verdict"] for s in ("5 N", "6 N") for g in by_answer[s]["result"]["graded"]] == ["right", "wrong"]


def test_a_table_of_a_class_is_parted(tmp_path: Path) -> None:
    answers = ["5 N", "hang", "exit", "6 N", "raise", "5 N"]
    table = tmp_path / "c.csv"
    table.write_text("student,p.a\n" + "".join(f"s{i},{a}\n" for i, a in enumerate(answers)))
    heard: list[Line] = []
    grade_files([str(table)], GRADING, 2, str(tmp_path / "r"), take=heard.append)
    found = sorted((line.part, line.parts, line.student, line.ended) for line in heard)
    assert found == [(i, 6, f"s{i}", ENDS[a]) for i, a in enumerate(answers)]


def test_who_cannot_be_graded_even_without_answers(tmp_path: Path) -> None:
    (tmp_path / "always.yaml").write_text("answers: {p.a: 5 N}\n")
    (tmp_path / "c.csv").write_text("student,p.a\ns1,5 N\nalways,5 N\ns2,6 N\n")
    heard: list[Line] = []
    grade_files([str(tmp_path)], GRADING, 1, str(tmp_path / "r"), take=heard.append)
    found = sorted((line.student, line.ended, line.part, line.parts) for line in heard)
    assert found == [
        ("always", "crashed", 0, 1),
        ("c #2", "crashed", 1, 3),
        ("s1", "ok", 0, 3),
        ("s2", "ok", 2, 3),
    ]
    why = "ungradable (crashed): the process ended with code 4"
    assert [r.wrong for r in results([str(tmp_path / "r")]) if not r.graded] == [(why,), (why,)]
    assert grade_files([str(tmp_path)], GRADING, 1, str(tmp_path / "r")) == Ran(0, 4, {}, ())


def test_what_is_done_is_not_done_again(tmp_path: Path) -> None:
    folder, file = tmp_path / "in", tmp_path / "r"
    hand_in(folder, ["5 N", "6 N", "raise"])
    (folder / "link.yaml").symlink_to("s000.yaml")
    (folder / "t.csv").write_text("student,p.a\na,5 N\nb,6 N\n")
    assert grade_files([str(folder)], GRADING, 1, str(file)).graded == 6
    assert grade_files([str(folder)], GRADING, 1, str(file)) == Ran(0, 6, {}, ())
    (folder / "s001.yaml").write_text("answers: {p.a: 5 N}\n")
    assert grade_files([str(folder)], GRADING, 1, str(file)) == Ran(1, 5, {"ok": 1}, ())
    assert [r.score for r in results([str(file)])] == [0.0, 1.0, 1.0, 0.0, 1.0, 0.0]
    # A whole table, of which the last line was torn.
    torn = file.read_bytes()[:-1]
    file.write_bytes(torn[: torn.rindex(b"\n") + 30])
    assert grade_files([str(folder)], GRADING, 1, str(file)).graded == 1
    assert grade_files([str(folder)], replace(GRADING, key="other"), 1, str(file)).graded == 6
    assert len(list(results([str(file)]))) == 6


def test_of_a_table_only_what_is_missing_is_graded(tmp_path: Path) -> None:
    table, file = tmp_path / "c.csv", tmp_path / "r"
    table.write_text("student,p.a\n" + "".join(f"s{i},5 N\n" for i in range(5)))
    grade_files([str(table)], GRADING, 1, str(file))
    kept = file.read_bytes().splitlines(keepends=True)
    file.write_bytes(b"".join([kept[0], kept[3]]))
    heard: list[Line] = []
    assert grade_files([str(table)], GRADING, 1, str(file), take=heard.append).skipped == 2
    assert [line.student for line in heard] == ["s1", "s2", "s4"]


def test_two_submissions_of_one_student_are_told(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("student: s1\nanswers: {p.a: 5 N}\n")
    (tmp_path / "b.csv").write_text("student,p.a\ns1,6 N\ns2,5 N\n")
    ran = grade_files([str(tmp_path / "a.yaml"), str(tmp_path / "b.csv")], GRADING, 1)
    assert ran.graded == 3
    assert ran.twice == (
        f"s1 handed in 2 times: {tmp_path}/a.yaml, {tmp_path}/b.csv; "
        "all are graded, the last that can be counts in the average",
    )


def test_results_in_the_folder_of_the_submissions_are_none(tmp_path: Path) -> None:
    hand_in(tmp_path, ["5 N"])
    for _ in range(2):
        ran = grade_files([str(tmp_path)], GRADING, 1, str(tmp_path / "r.json"))
        assert ran.graded + ran.skipped == 1


def test_shards_share_the_files(tmp_path: Path) -> None:
    names = [f"s{i}.yaml" for i in range(300)]
    shares = [[n for n in names if in_shard(str(tmp_path / n), (k, 3))] for k in (1, 2, 3)]
    assert sorted(n for share in shares for n in share) == sorted(names)
    assert all(70 < len(share) < 130 for share in shares)
    assert shares[0] == [n for n in names if in_shard(f"/elsewhere/{n}", (1, 3))]
    assert shard_of("3/40") == (3, 40)
    for text in ("0/3", "4/3", "1", "1/0", "a/b", "1/3/5"):
        with pytest.raises(PlanarError, match="is no shard"):
            shard_of(text)


def test_a_key_that_cannot_be_used(tmp_path: Path) -> None:
    hand_in(tmp_path / "in", ["5 N"])
    with pytest.raises(RuntimeError, match="could not be started: ValueError: no key"):
        grade_files([str(tmp_path / "in")], Grading(no_grader, "key"), 1)


# --- stopped ---------------------------------------------------------------------------------------------------------

RUN = """
import signal
import sys
from graders import grader
from planar_cli.homework.submissions.batches import grade_files
from planar_cli.homework.submissions.grader import Grading
if __name__ == "__main__":
    # Who is started in the background inherits that the signal is ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    ran = grade_files([sys.argv[1]], Grading(grader, "key", 60), 2, sys.argv[2])
    print(ran.graded, ran.interrupted, flush=True)
    sys.exit(128 + ran.interrupted)
"""


@pytest.fixture
def stopped(tmp_path: Path) -> Iterator[subprocess.Popen[str]]:
    """A run whose workers grade what they can, and then hang, one of them so that no thread of it runs."""
    hand_in(tmp_path / "in", ["5 N", "6 N", "power", "hang"])
    (tmp_path / "run.py").write_text(RUN)
    environment = {**os.environ, "MARKER": tmp_path.name, "PYTHONPATH": str(Path(__file__).parent)}
    command = [sys.executable, str(tmp_path / "run.py"), str(tmp_path / "in"), str(tmp_path / "r")]
    # In a session of its own, so that an interrupt goes to all of it, as that of a terminal does.
    with subprocess.Popen(command, env=environment, stdout=-1, stderr=-1, text=True, start_new_session=True) as process:
        for _ in range(600):
            if (tmp_path / "r").exists() and (tmp_path / "r").read_text().count("\n") == 2:
                break
            time.sleep(0.05)
        yield process
        process.kill()


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_whoever_stops_it_no_worker_is_left(
    stopped: subprocess.Popen[str], tmp_path: Path, how: signal.Signals
) -> None:
    assert len(workers(tmp_path.name)) >= 2
    if how == signal.SIGINT:
        os.killpg(stopped.pid, how)
    else:
        stopped.send_signal(how)
    out, error = stopped.communicate(timeout=20)
    if how == signal.SIGKILL:
        assert stopped.returncode == -9
    else:
        assert (out, error, stopped.returncode) == (f"2 {how.value}\n", "", 128 + how)
    for _ in range(100):
        if not workers(tmp_path.name):
            break
        time.sleep(0.05)
    assert workers(tmp_path.name) == []
    assert [line["result"]["student"] for line in lines(tmp_path / "r")] == ["s000", "s001"]
    # Taken up again, nothing is lost, and nothing is done twice.
    heard: list[Line] = []
    ran = grade_files([str(tmp_path / "in")], GRADING, 2, str(tmp_path / "r"), take=heard.append)
    assert ran == Ran(2, 2, {"timeout": 2}, ())
    assert len(lines(tmp_path / "r")) == 4
    assert {result_of(line.text).student for line in heard} == {"s002", "s003"}


def test_a_run_that_is_broken_off_tells_what_is_left(tmp_path: Path) -> None:
    hand_in(tmp_path / "in", ["5 N", "6 N", "7 N"])
    stops = [KeyboardInterrupt()]

    def take(line: Line) -> None:
        while stops:
            raise stops.pop()

    ran = grade_files([str(tmp_path / "in")], GRADING, 1, take=take)
    assert (ran.interrupted, ran.graded, ran.left) == (signal.SIGINT, 1, 2)
