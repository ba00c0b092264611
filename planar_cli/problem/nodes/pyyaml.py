"""PyYAML, with regular expressions that are compiled when they are first used.

It compiles a dozen as it is loaded, a fiftieth of what a short page takes, and who reads events with libyaml uses none
of them. Other modules take `yaml` from here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def compiled_when_used() -> Iterator[None]:
    """What is loaded meanwhile compiles its regular expressions when it first uses them. It may call their methods, but
    not hand them to functions of `re`.
    """
    at_once = re.compile
    vars(re)["compile"] = _Pattern
    try:
        yield
    finally:
        vars(re)["compile"] = at_once


class _Pattern:
    """A regular expression that waits."""

    def __init__(self, pattern: str, flags: int = 0) -> None:
        self._source = pattern, flags

    def __getattr__(self, name: str) -> Any:
        return getattr(re.compile(*self._source), name)


with compiled_when_used():
    import yaml

__all__ = ["compiled_when_used", "yaml"]
