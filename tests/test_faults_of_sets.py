"""A fault of planar while a set is made ready is told as one, not blamed on a file."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.cli import run
from planar_cli.errors import Fault
from planar_cli.homework import homework
from planar_cli.homework.homework import made_ready
from planar_cli.homework.sets.set_file import HomeworkSet, read_set
from planar_cli.homework.tasks.supervisor import Ended, Supervisor, demand_no_fault

POINT = """
given: {v: 2 m/s}
points: {A: [0, 0]}
bodies: {ball: {particle: A, mass: 1 kg}}
motion: [v(A).x = v, v(A).y = 0]
find: {K: T(ball)}
"""


@pytest.fixture
def path(tmp_path: Path) -> Path:
    (tmp_path / "ball.yaml").write_text(POINT)
    (tmp_path / "set.yaml").write_text("problems: [ball.yaml]")
    return tmp_path / "set.yaml"


def ended(verdict: str) -> object:
    result = "NameError: name 'x' is not defined"
    return lambda self, items: [Ended(verdict, result, 0.0) for _ in items]


@pytest.mark.parametrize("command", [["key"], ["check", "--false-matches", "--set"]])
@pytest.mark.parametrize("verdict", ["fault", "crashed"])
def test_a_fault_has_its_exit_status(
    command: list[str],
    verdict: str,
    path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(Supervisor, "run", ended(verdict))
    assert run([*command, str(path)]) == 4
    told = capfd.readouterr().err
    assert "a fault of planar itself: " in told
    assert "ball.yaml: NameError: name 'x' is not defined" in told
    assert "PL803" not in told


def test_a_limit_is_no_fault(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    demand_no_fault([("a.yaml", Ended("timeout", "60 s", 60.0)), ("b.yaml", Ended("ok", None, 0.0))])
    monkeypatch.setattr(Supervisor, "run", ended("timeout"))
    assert run(["key", str(path)]) == 3


def failing(*_: object) -> None:
    raise NameError("name 'y' is not defined")


def test_what_fails_in_a_worker_comes_back_as_a_fault(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(homework, "prepared", failing)
    monkeypatch.setattr(Supervisor, "run", here)
    with pytest.raises(Fault, match="name 'y' is not defined"):
        made_ready(homework_set(path), 1, 60, None, lambda *_: lambda _: None)


def here(self: Supervisor, items: list[object]) -> list[Ended]:
    """As a worker does it, in this process."""
    from planar_cli.homework.tasks.worker import _outcome

    return [Ended(*_outcome(None, homework._attempt, item, 0), 0.0) for item in items]


def homework_set(path: Path) -> HomeworkSet:
    return read_set(str(path))
