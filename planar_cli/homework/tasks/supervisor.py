"""Many tasks on all cores, each with a limit of time and memory that holds whatever the task does.

A timer inside a process cannot stop a library that never looks at it, so every task runs in a worker process that is
killed at its deadline and replaced; so is one that dies of itself. The other tasks never notice.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from multiprocessing.connection import wait
from typing import Any

from planar_cli.errors import Fault
from planar_cli.homework.tasks.memory import MEMORY
from planar_cli.homework.tasks.worker import FAULT, MEMORY_OUT, PART, READY, Worker, start
from planar_cli.records import record

LONGEST_START = 120.0
NEVER = float("inf")
FAULTS = FAULT, "crashed"
"""How a task ends that planar fails at."""


@record
class Ended:
    """How one task ended: `verdict` is ok, fault, timeout, memory or crashed; `result` is a value or a message."""

    verdict: str
    result: Any
    seconds: float


def demand_no_fault(tasks: Iterable[tuple[str, Ended]]) -> None:
    """Fault where planar failed at a task: that is not to be mended in its file. `tasks`: with the names of files."""
    failed = dict.fromkeys(f"{name}: {end.result}" for name, end in tasks if end.verdict in FAULTS)
    if failed:
        raise Fault("; ".join(failed))


@record
class Heard:
    """What was heard of a task: a part of its result, or how it ended, with the task as it was given."""

    item: Any
    verdict: str
    """part, or one of Ended."""
    result: Any
    seconds: float


class Supervisor:
    """Runs a function on items in worker processes; `told` hears how many are done.

    The function is `function` itself, or without one what `make` gives when it is called in each worker; both cross
    processes by pickling. A function that gives its result in parts is a generator: `timeout` [s] is then the longest
    time to the next part, else to the result; 0 is no limit. `memory` [bytes] is a worker's, beside what it takes
    before.
    """

    def __init__(
        self,
        function: Callable[[Any], Any] | None,
        jobs: int,
        timeout: float,
        told: Callable[[int], None] = lambda done: None,
        make: Callable[[], Callable[[Any], Any]] | None = None,
        memory: int = MEMORY,
    ) -> None:
        self.jobs, self.timeout, self.told = jobs, timeout, told
        made = make if function is None else partial(_itself, function)
        assert made is not None
        self._start = partial(start, made, memory)
        self._again: deque[Any] = deque()
        self._workers: list[Worker] = []

    def run(self, items: Sequence[Any]) -> list[Ended]:
        """How each item ended, in the order of the items."""
        ended: dict[int, Ended] = {}
        try:
            for number, heard in self._stream(enumerate(items)):
                if heard.verdict != PART:
                    ended[number] = Ended(heard.verdict, heard.result, heard.seconds)
                    self.told(len(ended))
        finally:
            self.close()
        return [ended[i] for i in range(len(items))]

    def stream(self, items: Iterable[Any]) -> Iterator[Heard]:
        """What is heard of all items, as it is heard; they are taken one by one, as workers come free.

        Between two of them `again` may give further items. The workers stay for another stream until `close`.
        """
        for _, heard in self._stream((0, item) for item in items):
            yield heard

    def again(self, item: Any) -> None:
        """One more item for the stream that runs; it is the next to be worked on."""
        self._again.append((0, item))

    def close(self) -> None:
        """No worker is left behind."""
        for worker in self._workers:
            worker.process.kill()
        for worker in self._workers:
            worker.process.join()
            worker.pipe.close()
        self._workers.clear()
        self._again.clear()

    # --- the loop ----------------------------------------------------------------------------------------------------

    def _stream(self, items: Iterator[tuple[int, Any]]) -> Iterator[tuple[int, Heard]]:
        waiting = _Waiting(self._again, items)
        while True:
            self._give(waiting)
            if not waiting and not any(w.task for w in self._workers):
                return
            yield from self._step()

    def _give(self, waiting: _Waiting) -> None:
        """Something to do for every worker that has nothing, and more workers while there is more to do."""
        for worker in [w for w in self._workers if w.ready and w.task is None]:
            if not waiting:
                return
            worker.task, worker.started = waiting.next(), time.monotonic()
            worker.deadline = worker.started + (self.timeout or NEVER)
            try:
                worker.pipe.send(worker.task[1])
            except OSError:
                # It ended while it had nothing to do: that is no fault of the task.
                self._again.append(worker.task)
                self._drop(worker)
        starting = sum(not w.ready for w in self._workers)
        while len(self._workers) < self.jobs and waiting.more_than(starting):
            self._workers.append(self._start(time.monotonic() + LONGEST_START))
            starting += 1

    def _step(self) -> Iterator[tuple[int, Heard]]:
        """Wait until something happens, and see to every worker that it happened to."""
        soonest = min(w.deadline for w in self._workers)
        left = None if soonest == NEVER else max(0.0, soonest - time.monotonic())
        # A closed pipe counts as ready, so a worker that dies is heard at once.
        ready = wait([w.pipe for w in self._workers], left)
        for worker in list(self._workers):
            if worker.pipe in ready:
                yield from self._hear(worker)
            elif time.monotonic() >= worker.deadline:
                yield from self._lose(worker, "timeout", f"not decided within {self.timeout:g} s")

    def _hear(self, worker: Worker) -> Iterator[tuple[int, Heard]]:
        try:
            verdict, result = worker.pipe.recv()
        except (EOFError, OSError):
            worker.process.join()
            yield from self._lose(worker, "crashed", f"the process ended with code {worker.process.exitcode}")
            return
        now = time.monotonic()
        if verdict == READY:
            worker.ready, worker.deadline = True, NEVER
        elif worker.task is None:
            yield from self._lose(worker, FAULT, result)
        else:
            number, item = worker.task
            worker.deadline = now + (self.timeout or NEVER)
            if verdict != PART:
                worker.task, worker.deadline = None, NEVER
            if verdict == MEMORY_OUT:
                # What took it may hold it still.
                self._drop(worker)
            yield number, Heard(item, verdict, result, now - worker.started)

    def _lose(self, worker: Worker, verdict: str, message: str) -> Iterator[tuple[int, Heard]]:
        """The worker is gone, or goes now; its task has ended with it."""
        self._drop(worker)
        if worker.task is not None:
            number, item = worker.task
            yield number, Heard(item, verdict, message, time.monotonic() - worker.started)
        elif not worker.ready:
            raise RuntimeError(f"a worker process could not be started: {message}")

    def _drop(self, worker: Worker) -> None:
        worker.process.kill()
        worker.process.join()
        worker.pipe.close()
        # By identity: a worker that is equal is another one.
        self._workers = [w for w in self._workers if w is not worker]


class _Waiting:
    """The items that nobody works on: those given again, and then those still to be taken."""

    def __init__(self, again: deque[Any], items: Iterator[tuple[int, Any]]) -> None:
        self.again, self.items = again, items
        self.taken: deque[tuple[int, Any]] = deque()

    def more_than(self, number: int) -> bool:
        """Are there more than so many?"""
        while len(self.again) + len(self.taken) <= number:
            try:
                self.taken.append(next(self.items))
            except StopIteration:
                return False
        return True

    def __bool__(self) -> bool:
        return self.more_than(0)

    def next(self) -> tuple[int, Any]:
        """The next one; there must be one."""
        if self.again:
            given: tuple[int, Any] = self.again.popleft()
            return given
        return self.taken.popleft() if self.taken else next(self.items)


def _itself(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    return function
