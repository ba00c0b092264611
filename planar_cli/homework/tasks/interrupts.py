"""What ends a long run early: Ctrl-C and SIGTERM, both as KeyboardInterrupt that tells which it was."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


@contextmanager
def terminated() -> Iterator[None]:
    """SIGTERM ends the block as Ctrl-C does."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        raise KeyboardInterrupt(number)

    before = signal.signal(signal.SIGTERM, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def number_of(stop: KeyboardInterrupt) -> int:
    """The number of the signal."""
    return stop.args[0] if stop.args else int(signal.SIGINT)
