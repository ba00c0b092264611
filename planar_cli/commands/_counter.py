"""A counter on standard error for many things that are done one after another."""

from __future__ import annotations

import sys
from collections.abc import Callable

from planar_cli.streams import echo


def counter(total: int, what: str) -> Callable[[int], None]:
    """`3 of 8 problems checked`, if somebody looks at it."""

    def told(done: int) -> None:
        if sys.stderr.isatty():
            end = "\r\033[K" if done == total else ""
            echo(f"\r{done} of {total} {what}{end}", err=True, end="")

    return told
