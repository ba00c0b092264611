"""A child process that does one thing after another, each within a limit of processor time; what ends it is told."""

from __future__ import annotations

import gc
import os
import pickle
import resource
import select
import signal
import struct
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

WAITING = 20
"""A child that gets little of the processor has so many times its limit."""
MEMORY = 2 * 1024**3
LARGE = 600 * 1024
"""A child that holds more [KiB] does no more."""
RARELY = (50_000, 20, 20)
"""Little of what is worked out goes in circles."""

Work = Callable[[Any], tuple[Any, bool]]
"""What is to be done with a task; with it, is the child fit for another?"""


@dataclass(frozen=True, slots=True)
class Told:
    """What came of a task: its answer, or None with the status with which the child ended. `seconds`: of the child."""

    answer: Any
    seconds: float
    ended: bool
    status: int = 0
    too_long: bool = False


class Child:
    """A process that is forked off as it is made."""

    def __init__(self, work: Work, limit: float) -> None:
        self.limit = limit
        asked, self._ask = os.pipe()
        self._told, tell = os.pipe()
        self._known = 0.0
        """Processor time of the tasks that are done."""
        self._process = os.fork()
        if self._process == 0:
            os.close(self._ask)
            os.close(self._told)
            _serve(asked, tell, work, limit)
        os.close(asked)
        os.close(tell)

    def ask(self, task: Any) -> Told:
        """Have a task done."""
        _write(self._ask, pickle.dumps(task))
        data = _read(self._told, time.monotonic() + WAITING * self.limit)
        if data:
            answer, seconds, fit = pickle.loads(data)
            self._known += seconds
            if not fit:
                self.end()
            return Told(answer, seconds, not fit)
        if data is None:
            os.kill(self._process, signal.SIGKILL)
        status, seconds = self.end()
        too_long = os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL)
        return Told(None, seconds - self._known, True, status, too_long)

    def end(self) -> tuple[int, float]:
        """It goes; its status and all its processor time."""
        os.close(self._ask)
        os.close(self._told)
        _, status, used = os.wait4(self._process, 0)
        return status, used.ru_utime + used.ru_stime


def _serve(asked: int, tell: int, work: Work, limit: float) -> None:
    """The life of the child."""
    status = 1
    try:
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY if most == resource.RLIM_INFINITY else min(MEMORY, most), most))
        gc.set_threshold(*RARELY)
        fit = True
        while fit and (data := _read(asked, None)):
            before = time.process_time()
            resource.setrlimit(resource.RLIMIT_CPU, (max(1, round(before + limit)), resource.RLIM_INFINITY))
            answer, fit = work(pickle.loads(data))
            fit = fit and resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < LARGE
            _write(tell, pickle.dumps((answer, time.process_time() - before, fit)))
        status = 0
    finally:
        os._exit(status)


def _write(pipe: int, data: bytes) -> None:
    data = struct.pack("!I", len(data)) + data
    while data:
        data = data[os.write(pipe, data) :]


def _read(pipe: int, end: float | None) -> bytes | None:
    """What is written next; empty: the other side is gone; None: nothing until `end`."""
    data, wanted = b"", 4
    while len(data) < wanted:
        if end is not None and not select.select([pipe], [], [], max(0.0, end - time.monotonic()))[0]:
            return None
        part = os.read(pipe, wanted - len(data))
        if not part:
            return b""
        data += part
        if len(data) == 4 == wanted:
            wanted += struct.unpack("!I", data)[0]
    return data[4:]
