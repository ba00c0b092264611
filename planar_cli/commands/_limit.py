"""A limit on the time that one problem may take."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from planar_cli.errors import Undecided

AGAIN = 1.0


class _TimeIsUp(BaseException):
    """Like KeyboardInterrupt it is no Exception: no road that looks for another way out may take it for a failure of
    its own, or what is printed would depend on the clock.
    """


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Undecided from the block as a whole after so many seconds; 0 is no limit.

    Works in the main thread where the system has interval timers. The timer repeats, lest a library's own bare
    `except` swallow the one shot.
    """
    if not seconds or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        raise _TimeIsUp

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
    try:
        yield
    except _TimeIsUp:
        raise Undecided(f"not decided within {seconds:g} s; --timeout allows more") from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
