"""A limit on the time that one problem may take."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from planar_cli.errors import Undecided

AGAIN = 1.0


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise Undecided inside the block after so many seconds; 0 is no limit.

    Works in the main thread where the system has interval timers. The timer repeats, lest a library's own
    `except Exception` swallow the one shot.
    """
    if not seconds or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        raise Undecided(f"not decided within {seconds:g} s; --timeout allows more")

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
