"""The same batches on executors: a pool of processes, and a cluster of dask on this machine where it is installed."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from graders import grader

from planar_cli.errors import PlanarError, Undecided
from planar_cli.homework.submissions.batches import Ran, batches_of, grade_files, graded_by
from planar_cli.homework.submissions.grader import Grading, Piece
from planar_cli.homework.tasks.cluster import cluster
from planar_cli.homework.tasks.results import Line

GRADING = Grading(grader, "key", timeout=1.0)
ENDS = {"5 N": "ok", "hang": "timeout", "power": "timeout", "eat": "memory", "exit": "crashed", "6 N": "ok"}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "in").mkdir()
    for i, answer in enumerate(ENDS):
        (tmp_path / f"in/s{i}.yaml").write_text(f"answers: {{p.a: {answer}}}\n")
    for i in range(6, 200):
        (tmp_path / f"in/s{i}.yaml").write_text("answers: {p.a: 5 N}\n")
    return tmp_path


def grade_on(executor: Executor, folder: Path) -> None:
    """All end as they must, and what is done is not done again."""
    heard: list[Line] = []
    names, file = [str(folder / "in")], str(folder / "r")
    ran = grade_files(names, GRADING, 1, file, executor=executor, take=heard.append)
    assert ran == Ran(200, 0, {"crashed": 1, "memory": 1, "ok": 196, "timeout": 2}, ())
    found = {line.student: line.ended for line in heard}
    assert [found[f"s{i}"] for i in range(6)] == list(ENDS.values())
    assert grade_files(names, GRADING, 1, file, executor=executor).skipped == 200


def test_on_a_pool_of_processes(folder: Path) -> None:
    with ProcessPoolExecutor(2) as executor:
        grade_on(executor, folder)


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    if importlib.util.find_spec("distributed") is None:
        pytest.skip("dask.distributed is not installed: the extra `cluster` has it")
    distributed: Any = importlib.import_module("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as local:
        yield local.scheduler_address


def test_on_a_cluster(folder: Path, address: str) -> None:
    with cluster(address) as executor:
        grade_on(executor, folder)


def test_on_a_cluster_of_its_own(folder: Path, address: str) -> None:
    with cluster("local") as executor:
        grade_on(executor, folder)


def test_without_a_scheduler(monkeypatch: pytest.MonkeyPatch, address: str) -> None:
    monkeypatch.setattr("planar_cli.homework.tasks.cluster.LONGEST_WAIT", 0.2)
    with pytest.raises(PlanarError, match="there is no scheduler at"), cluster("tcp://127.0.0.1:9"):
        pass


class Failing(Executor):
    """A cluster that loses the first of its tasks, or all."""

    def __init__(self, always: bool) -> None:
        self.always, self.tasks = always, 0

    def submit(self, function: Any, /, *args: Any, **named: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self.tasks += 1
        if self.always or self.tasks == 1:
            future.set_exception(OSError("a machine is gone"))
        else:
            future.set_result(function(*args, **named))
        return future


def test_a_batch_that_a_cluster_loses_is_given_again(folder: Path) -> None:
    batches = list(batches_of([Piece(str(folder / f"in/s{i}.yaml")) for i in range(20, 24)], size=2))
    executor = Failing(always=False)
    found = [line.student for line in graded_by(executor, batches, GRADING)]
    assert sorted(found) == ["s20", "s21", "s22", "s23"]
    assert executor.tasks == 3
    with pytest.raises(Undecided, match="the cluster lost a batch twice: a machine is gone"):
        list(graded_by(Failing(always=True), batches, GRADING))
