"""How wide a stream is, and whether it has more letters than ASCII."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

from planar_cli.plain_letters import in_plain, is_poor

PIPE_WIDTH, ANY_WIDTH = 110, 10_000
SMALLEST_WIDTH, LARGEST_WIDTH = 20, 120


def width_of(stream: TextIO) -> int:
    """The columns of a terminal; of anything else those that COLUMNS says, else `PIPE_WIDTH`."""
    if not _is_told(stream):
        return PIPE_WIDTH
    return max(min(shutil.get_terminal_size().columns, LARGEST_WIDTH), SMALLEST_WIDTH)


@contextmanager
def shown_on(stream: TextIO, output: str | None) -> Iterator[int]:
    """Its width, and its letters while something is laid out; a file `output` has all letters, and lines of any length,
    and so has a pipe of which nobody tells the width.
    """
    on_screen = output in (None, "-")
    with in_plain(on_screen and is_poor(stream)):
        yield width_of(stream) if on_screen and _is_told(stream) else ANY_WIDTH


def _is_told(stream: TextIO) -> bool:
    """Has it a width: as a terminal, or because COLUMNS says so?"""
    told = os.environ.get("COLUMNS", "")
    return stream.isatty() or (told.isdecimal() and int(told) > 0)
