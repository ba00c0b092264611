"""Which files a command is about: files as named, and all problem files of folders."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from planar_cli.errors import PlanarError

SUFFIXES = (".yaml", ".yml")


def problem_files(names: Iterable[str]) -> Iterator[str]:
    """The names as given, each folder replaced by the problem files below it, sorted; links are not followed.

    Raises PlanarError for a folder without any.
    """
    for name in names:
        path = Path(name)
        if name == "-" or not path.is_dir():
            yield name
            continue
        found = sorted(p for p in path.rglob("*") if p.suffix in SUFFIXES and p.is_file() and not p.is_symlink())
        if not found:
            raise PlanarError(f"the folder {name} has no problem files (*.yaml)")
        yield from (str(p) for p in found)
