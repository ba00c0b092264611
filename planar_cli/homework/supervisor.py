"""Many tasks on all cores, each with a limit of time and memory that holds whatever the task does.

A timer inside a process cannot stop a library that never looks at it, so every task runs in a worker process that is
killed at its deadline and replaced; so is one that dies of itself. The other tasks never notice.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Any

from planar_cli.homework.memory import memory_limit, too_much
from planar_cli.records import changing, record

READY = "ready"
LONGEST_START = 120.0
NEVER = float("inf")


@record
class Ended:
    """How one task ended: `verdict` is ok, fault, timeout, memory or crashed; `result` is a value or a message."""

    verdict: str
    result: Any
    seconds: float


@changing
class _Worker:
    """A process, our end of its pipe, the task it is at (None: none yet) and when that must be done."""

    process: BaseProcess
    pipe: Connection
    task: int | None = None
    started: float = 0.0
    deadline: float = 0.0


class Supervisor:
    """Runs `function` on items in worker processes; `told` hears how many are done."""

    def __init__(self, function: Callable[[Any], Any], jobs: int, timeout: float, told: Callable[[int], None]) -> None:
        self.function, self.jobs, self.timeout, self.told = function, jobs, timeout, told
        self._context = multiprocessing.get_context("spawn")
        self._ended: dict[int, Ended] = {}
        self._waiting: list[int] = []
        self._workers: list[_Worker] = []

    def run(self, items: Sequence[Any]) -> list[Ended]:
        """How each item ended, in the order of the items."""
        self._waiting = list(reversed(range(len(items))))
        try:
            for _ in range(min(self.jobs, len(items))):
                self._start()
            while len(self._ended) < len(items):
                self._step(items)
        finally:
            for worker in self._workers:
                worker.process.kill()
        return [self._ended[i] for i in range(len(items))]

    def _start(self) -> None:
        ours, theirs = self._context.Pipe()
        # Children of this process inherit one thread for linear algebra: the cores are taken already.
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
        process = self._context.Process(target=_serve, args=(theirs, self.function), daemon=True)
        with _deaf_to_ctrl_c():
            process.start()
        theirs.close()
        self._workers.append(_Worker(process, ours, deadline=time.monotonic() + LONGEST_START))

    def _step(self, items: Sequence[Any]) -> None:
        """Wait until something happens, and see to every worker that it happened to."""
        soonest = min(w.deadline for w in self._workers)
        left = None if soonest == NEVER else max(0.0, soonest - time.monotonic())
        # A closed pipe counts as ready, so a worker that dies is heard at once.
        ready = wait([w.pipe for w in self._workers], left)
        for worker in list(self._workers):
            if worker.pipe in ready:
                self._hear(worker, items)
            elif time.monotonic() >= worker.deadline:
                self._replace(worker, "timeout", f"not decided within {self.timeout:g} s")

    def _hear(self, worker: _Worker, items: Sequence[Any]) -> None:
        try:
            verdict, result = worker.pipe.recv()
        except (EOFError, OSError):
            worker.process.join()
            self._replace(worker, "crashed", f"the process ended with code {worker.process.exitcode}")
            return
        if verdict != READY:
            self._end(worker, verdict, result)
        self._give(worker, items)

    def _give(self, worker: _Worker, items: Sequence[Any]) -> None:
        if not self._waiting:
            worker.process.kill()
            self._workers.remove(worker)
            return
        worker.task = self._waiting.pop()
        worker.started = time.monotonic()
        worker.deadline = worker.started + (self.timeout or NEVER)
        worker.pipe.send(items[worker.task])

    def _end(self, worker: _Worker, verdict: str, result: Any) -> None:
        assert worker.task is not None
        self._ended[worker.task] = Ended(verdict, result, time.monotonic() - worker.started)
        worker.task = None
        self.told(len(self._ended))

    def _replace(self, worker: _Worker, verdict: str, message: str) -> None:
        """The worker is gone, or goes now; its task has ended with it."""
        worker.process.kill()
        worker.process.join()
        worker.pipe.close()
        self._workers.remove(worker)
        if worker.task is None:
            raise RuntimeError(f"a worker process could not be started: {message}")
        self._end(worker, verdict, message)
        if self._waiting:
            self._start()


@contextmanager
def _deaf_to_ctrl_c() -> Iterator[None]:
    """What is started here never hears Ctrl-C, not even while it loads its modules: this process hears it, if only
    afterwards, and ends it as well.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # The first start would start this one as well, which lets the signal through again.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(pipe: Connection, function: Callable[[Any], Any]) -> None:
    """The life of a worker: one item after the other until the pipe closes."""
    threading.Thread(target=_end_with_parent, daemon=True).start()
    with memory_limit():
        pipe.send((READY, None))
        while True:
            try:
                item = pipe.recv()
            except (EOFError, KeyboardInterrupt):
                return
            pipe.send(_outcome(function, item))


def _end_with_parent() -> None:
    """However the process ends that started this one: nobody is left to end it at its deadline."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _outcome(function: Callable[[Any], Any], item: Any) -> tuple[str, Any]:
    try:
        return "ok", function(item)
    except MemoryError:
        return "memory", too_much()
    except Exception as error:
        return "fault", f"{type(error).__name__}: {error}"
