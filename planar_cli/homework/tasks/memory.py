"""How much memory one problem may take, where the system can be told so."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from contextlib import contextmanager

MEMORY = 2 * 1024**3
"""Bytes beside what the process has taken before."""


def too_much(most: int = MEMORY) -> str:
    """What is told of a problem that takes more than so many bytes."""
    return f"more than {most / 1024**3:.3g} GB of memory"


@contextmanager
def memory_limit(most: int = MEMORY) -> Iterator[None]:
    """MemoryError from the block where it takes more than `most` bytes; Windows knows no such limit."""
    # Linear algebra sets room aside for each of its threads: on a large machine more than there is to be had.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        import resource
    except ImportError:
        yield
        return
    before = resource.getrlimit(resource.RLIMIT_AS)
    limits = [limit for limit in (_taken() + most, *before) if limit != resource.RLIM_INFINITY]
    with contextlib.suppress(OSError, ValueError):  # Some systems know the limit and do not let it be set.
        resource.setrlimit(resource.RLIMIT_AS, (min(limits), before[1]))
    try:
        yield
    finally:
        with contextlib.suppress(OSError, ValueError):
            resource.setrlimit(resource.RLIMIT_AS, before)


def _taken() -> int:
    """Bytes that this process has taken, as the limit counts them; 0 where that is not told."""
    import resource

    try:
        with open("/proc/self/statm", encoding="ascii") as told:
            return int(told.read().split()[0]) * resource.getpagesize()
    except (OSError, ValueError, IndexError):
        return 0
