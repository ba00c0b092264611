"""`planar check`: every outcome, order, limits that hold whatever a task does; and the comparison of answers."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from answered import HELD_ROD

from planar_cli import cli
from planar_cli.homework.checking.answers import compare
from planar_cli.homework.checking.verdict import Verdict
from planar_cli.homework.tasks.supervisor import Supervisor
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

ROD = f"""{HELD_ROD}\
find: {{alpha: alpha(rod), pin: reaction(O/rod), across: reaction(O/rod).x, falls: alpha(rod) < 0 rad/s^2}}
"""
SLOPE = """
title: Block on a rough slope
plane: vertical
symbols: {m: kg, beta: deg, mu: 1}
assume: [mu < tan(beta)]
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu}
instant: [at rest]
find: {a: a(A).mag, normal: N(A), state: mode(A)}
"""
ROCKET = """
title: Rocket
plane: vertical
symbols: {m0: kg, q: kg/s, u: m/s, T: s}
bodies: {rocket: {particle: [0, 0], mass: m0 - q*t}}
loads:
  - stream: {body: rocket, rate: q, leaves: {at: rocket, speed: u, angle: -90 deg}}
states: {0: [t = 0, at rest], 1: [t = T]}
find: {v: v(rocket).y @ 1}
"""


# --- comparison ------------------------------------------------------------------------------------------------------


def verdict(text: str, answer: str) -> Verdict:
    """The verdict on one answer of a file; `answer` may go on with further top-level keys."""
    problem, wrong = load_text(f"{text}answers:\n  {answer}\n")
    assert not wrong
    assert problem is not None
    (found,) = compare(solve_problem(problem))
    return found


@pytest.mark.parametrize(
    ("answer", "agrees"),
    [
        ("alpha: -4.905 rad/s^2", True),
        ("alpha: 4.905 rad/s^2 cw", True),
        ("alpha: 4.905 rad/s^2", False),
        ("alpha: -281.0358 deg/s^2", True),
        ("alpha: -3*(9.81 m/s^2)/(2*l)", True),
        ("alpha: -4.95 rad/s^2", True),
        ("alpha: -4.96 rad/s^2", False),
        ("alpha: {value: -4.96 rad/s^2, tolerance: 0.02}", True),
        ("alpha: {value: -4.91 rad/s^2, tolerance: 0.0001}", False),
        ("alpha: -4.91 rad/s^2\ntolerance: 0.0001", False),
        ("alpha: -4.96 rad/s^2\ntolerance: 0.02", True),
        ("pin: [0, 4.905 N]", True),
        ("pin: [0.04 N, 4.9 N]", True),
        ("pin: [0.1 N, 4.905 N]", False),
        ("pin: [4.905 N, 0]", False),
        ("pin: [0, 0.004905 kN]", True),
        ("across: 0", True),
        ("across: 0 N", True),
        ("across: 0.0000001 N", True),
        ("across: 0.01 N", False),
        ("falls: true", True),
        ("falls: false", False),
    ],
)
def test_numbers(answer: str, agrees: bool) -> None:
    assert verdict(ROD, answer).agrees is agrees


RIGHT = (
    "a: g*(sin(beta) - mu*cos(beta))",
    "a: g*sin(beta) - g*mu*cos(beta)",
    "a: 1.0001*g*(sin(beta) - mu*cos(beta))",
    "normal: m*g*cos(beta)",
    "state: slip",
)
WRONG = (
    "a: g*(sin(beta) + mu*cos(beta))",
    "a: 1.02*g*(sin(beta) - mu*cos(beta))",
    "normal: 101*m*g*cos(beta)/100",
    "state: stick",
)


@pytest.mark.parametrize("answer", RIGHT + WRONG)
def test_formulas_and_words(answer: str) -> None:
    found = verdict(SLOPE, answer)
    assert found.agrees is (answer in RIGHT)
    assert bool(found.message) is (answer in WRONG)


@pytest.mark.parametrize(
    ("answer", "agrees"),
    [
        ("v: u*log(m0/(m0 - q*T)) - g*T", True),
        ("v: u*log(m0) - T*g - u*log(m0 - T*q)", True),
        ("v: u*log(m0/(m0 - q*T)) + g*T", False),
    ],
)
def test_formulas_that_are_not_real_for_all_letters(answer: str, agrees: bool) -> None:
    assert verdict(ROCKET, answer).agrees is agrees


def test_a_message_says_how_far_off() -> None:
    found = verdict(ROD, "alpha: -5 rad/s^2")
    assert found.message == "alpha: the file states -5 rad/s^2, the solution gives -4.905 rad/s^2 (1.9 % off)"


def test_a_message_says_that_only_the_sense_is_another() -> None:
    solved = "alpha: the file states 4.905 rad/s^2, the solution gives -4.905 rad/s^2"
    assert verdict(ROD, "alpha: 4.905 rad/s^2").message == f"{solved} (the same size, the opposite sense)"
    assert verdict(ROD, "alpha: 5.3 rad/s^2").message.endswith(" % off)")


def test_a_verdict_tells_for_which_values_of_ranges_it_is() -> None:
    stone = """
plane: vertical
given: {m: {from: 2 kg, to: 4 kg, step: 1 kg}, h: {one_of: [20 m, 5 m]}, x: 1 m}
bodies: {stone: {particle: [x, h], mass: m}}
states: {1: [at rest], 2: [y(stone) = 0]}
find: {v: v(stone).mag @ 2}
"""
    told = "v: the file states 9.9 m/s, the solution gives 19.8091 m/s (100 % off); it is for m = 2 kg, h = 20 m"
    assert verdict(stone, "v: 9.9 m/s").message.startswith(told)


# --- supervisor ------------------------------------------------------------------------------------------------------


def misbehave(how: str) -> str:
    """A task that does what it is told."""
    if how == "hang":
        time.sleep(60)
    if how == "die":
        os._exit(7)
    if how == "raise":
        raise ValueError("as told")
    if how == "eat":
        return str(len(bytearray(8 * 1024**3)))
    return how.upper()


def test_tasks_end_as_they_must_and_in_order() -> None:
    told: list[int] = []
    items = ["a", "hang", "b", "die", "raise", "eat", "c"]
    ended = Supervisor(misbehave, 2, 1.5, told.append).run(items)
    assert [e.verdict for e in ended] == ["ok", "timeout", "ok", "crashed", "fault", "memory", "ok"]
    assert [e.result for e in ended if e.verdict == "ok"] == ["A", "B", "C"]
    assert ended[3].result == "the process ended with code 7"
    assert ended[4].result == "ValueError: as told"
    assert told == list(range(1, 8))


def test_tasks_without_a_limit() -> None:
    assert [e.result for e in Supervisor(misbehave, 2, 0, lambda done: None).run(["a", "b", "c"])] == ["A", "B", "C"]


def test_no_task_outlives_who_gave_it() -> None:
    """A task holds standard output open as long as it lives."""
    tasks = "Supervisor(print_and_hang, 1, 0, print).run([1])"
    code = f"from test_check_command import Supervisor, print_and_hang\nif __name__ == '__main__': {tasks}"
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, cwd=Path(__file__).parent) as process:
        assert process.stdout is not None
        assert process.stdout.read(2) == b"go"
        process.kill()
        assert process.stdout.read() == b""


def print_and_hang(task: int) -> None:
    """Tell that the task has begun, and go on for ever."""
    sys.stdout.write("go")
    sys.stdout.flush()
    while True:
        pass


def test_no_tasks() -> None:
    assert Supervisor(misbehave, 2, 1, lambda done: None).run([]) == []


# --- command ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "b-right.yaml").write_text(ROD + "answers: {alpha: 4.905 rad/s^2 cw, falls: true}\n")
    (tmp_path / "a-wrong.yaml").write_text(ROD + "answers: {alpha: 4.8 rad/s^2 cw}\n")
    (tmp_path / "c-bad.yaml").write_text("find: {x: x(A)}\n")
    return tmp_path


def test_table(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["check", str(folder), "--jobs", "2"]) == 2
    captured = capsys.readouterr()
    rows = [line.split() for line in captured.out.splitlines()]
    assert [Path(row[0]).stem for row in rows[:3]] == ["a-wrong", "b-right", "c-bad"]
    assert [row[1] for row in rows[:3]] == ["disagrees", "agrees", "bad"]
    assert captured.out.splitlines()[3].startswith("3 problems: 1 agrees, 1 disagrees, 1 bad file; 2 of 3 answers")
    assert "alpha: the file states -4.8 rad/s^2" in captured.err
    assert "c-bad.yaml:1:" in captured.err
    assert "checked" not in captured.err


def test_json(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "c-bad.yaml").unlink()
    assert cli.run(["check", str(folder), "--format", "json", "--jobs", "1"]) == 1
    data: Any = json.loads(capsys.readouterr().out)
    assert data["schema_version"] == 1
    assert [f["outcome"] for f in data["files"]] == ["disagrees", "agrees"]
    assert data["files"][0]["answers"][0]["find"] == "alpha"
    assert data["files"][0]["answers"][0]["relative_error"] == pytest.approx(0.021875)


def test_one_that_agrees(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["check", str(folder / "b-right.yaml")]) == 0
    assert capsys.readouterr().err == ""


def test_one_without_answers(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "d-none.yaml").write_text(ROD)
    assert cli.run(["check", str(folder / "d-none.yaml")]) == 0
    told = capsys.readouterr().out.splitlines()
    assert told[0].split()[1:3] == ["no", "answers"]
    assert told[1] == "1 problem: 1 no answers; nothing to compare"


def test_time_limit(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["check", str(folder / "b-right.yaml"), "--timeout", "0.001"]) == 3
    assert "undecided" in capsys.readouterr().out


@pytest.mark.parametrize("args", [["check"], ["check", "-"], ["check", "x.yaml", "--jobs", "0"]])
def test_wrong_usage(args: list[str]) -> None:
    assert cli.run(args) == 2
