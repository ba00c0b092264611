"""The life of a worker process: it makes its function once, does one task after the other, and never outlives whoever
started it.
"""

from __future__ import annotations

import contextlib
import gc
import inspect
import multiprocessing
import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any

from planar_cli.homework.tasks.memory import memory_limit, too_much
from planar_cli.later import CLUTTER
from planar_cli.records import changing

READY, PART, OK, FAULT, MEMORY_OUT = "ready", "part", "ok", "fault", "memory"
LONGEST_IDLE = 60.0
"""Seconds without a task after which a worker ends: one that is kept for later tasks costs nobody memory for ever."""
KILL_WITH_PARENT = 1
"""PR_SET_PDEATHSIG of Linux."""


@changing
class Worker:
    """A process, our end of its pipe, the task that it is at, with its number, and when it must be done."""

    process: BaseProcess
    pipe: Connection
    deadline: float
    ready: bool = False
    task: tuple[int, Any] | None = None
    started: float = 0.0


def start(make: Callable[[], Callable[[Any], Any]], memory: int, deadline: float) -> Worker:
    """A new worker, which will tell when it is ready."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    # Children of this process inherit one thread for linear algebra: the cores are taken already.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    process = context.Process(target=_serve, args=(theirs, make, memory, os.getpid()), daemon=True)
    with _may_have_children(), _deaf_children():
        process.start()
    theirs.close()
    return Worker(process, ours, deadline)


@contextmanager
def _may_have_children() -> Iterator[None]:
    """Workers of a cluster are daemons, which may start no process lest it outlive them: ours never does."""
    current = multiprocessing.current_process()
    before = current.daemon
    if before:
        current.daemon = False
    try:
        yield
    finally:
        if before:
            current.daemon = True


@contextmanager
def _deaf_children() -> Iterator[None]:
    """Ctrl-C goes to all processes of a terminal: a child started here does not hear it, and is ended by us."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # Else it would be started below, and what it blocks itself meanwhile be let through afterwards.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(pipe: Connection, make: Callable[[], Callable[[Any], Any]], memory: int, parent: int) -> None:
    """One item after the other until the pipe closes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.set_threshold(CLUTTER, 20, 20)
    _end_with(parent)
    with memory_limit(memory):
        try:
            function = make()
        except Exception as error:
            pipe.send((FAULT, _told(error)))
            return
        pipe.send((READY, None))
        while True:
            try:
                if not pipe.poll(LONGEST_IDLE):
                    return
                item = pipe.recv()
            except (EOFError, OSError):
                return
            pipe.send(_outcome(pipe, function, item, memory))


def _outcome(pipe: Connection, function: Callable[[Any], Any], item: Any, memory: int) -> tuple[str, Any]:
    try:
        result = function(item)
        if not inspect.isgenerator(result):
            return OK, result
        for part in result:
            pipe.send((PART, part))
        return OK, None
    except MemoryError:
        return MEMORY_OUT, too_much(memory)
    except Exception as error:
        return FAULT, _told(error)


def _told(error: Exception) -> str:
    """What failed; with PLANAR_DEBUG also where."""
    where = "".join(traceback.format_exception(error)) if os.environ.get("PLANAR_DEBUG") else ""
    return f"{type(error).__name__}: {error}" + (f"\n{where}" if where else "")


def _end_with(parent: int) -> None:
    """However the process ends that started this one: nobody is left to end it at its deadline."""
    threading.Thread(target=_watch, daemon=True).start()
    if sys.platform == "linux":
        # A thread cannot run while a library holds the interpreter; the system needs no thread.
        import ctypes

        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(KILL_WITH_PARENT, signal.SIGKILL)
        if os.getppid() != parent:
            os._exit(1)


def _watch() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
