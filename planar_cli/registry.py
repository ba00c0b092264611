"""Shelves: a folder is the list of its members.

Every module of a shelf's folder except `base` (and names that begin with an underscore) holds members; a member is a
class with a `kind` of its own. Nothing is registered by hand.
"""

from __future__ import annotations

import importlib
import pkgutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pathlib import Path

SHELVES = ("joints", "loads", "principles", "integrators", "formats", "commands")


@cache
def modules(shelf: str) -> tuple[str, ...]:
    """The names of a shelf's modules, sorted, without importing any of them."""
    package = importlib.import_module(f"planar_cli.{shelf}")
    names = (info.name for info in pkgutil.iter_modules(package.__path__))
    return tuple(sorted(n for n in names if n != "base" and not n.startswith("_")))


@cache
def members(shelf: str) -> dict[str, type]:
    """All members of a shelf, `kind` to class. Two members of one kind are our own fault and raise ValueError."""
    found: dict[str, type] = {}
    for name in modules(shelf):
        for member in _members_in(importlib.import_module(f"planar_cli.{shelf}.{name}")):
            kind: str = member.__dict__["kind"]
            if kind in found:
                raise ValueError(f"{shelf}: {kind!r} is registered twice")
            found[kind] = member
    return found


@contextmanager
def extended(shelf: str, folder: Path) -> Iterator[None]:
    """For a while the modules of another folder stand on a shelf beside its own."""
    package = importlib.import_module(f"planar_cli.{shelf}")
    package.__path__.append(str(folder))
    importlib.invalidate_caches()
    _forget()
    try:
        yield
    finally:
        package.__path__.remove(str(folder))
        for path in folder.glob("*.py"):
            sys.modules.pop(f"planar_cli.{shelf}.{path.stem}", None)
        _forget()


def _forget() -> None:
    modules.cache_clear()
    members.cache_clear()


def member(shelf: str, kind: str) -> Any:
    """One member, of which only its own module is imported if that has its name. KeyError if there is none."""
    if kind in modules(shelf):
        for found in _members_in(importlib.import_module(f"planar_cli.{shelf}.{kind}")):
            if found.__dict__["kind"] == kind:
                return found
    return members(shelf)[kind]


def _members_in(module: ModuleType) -> list[type]:
    """The classes that this very module defines with a `kind`."""
    return [
        v
        for v in vars(module).values()
        if isinstance(v, type) and v.__module__ == module.__name__ and "kind" in v.__dict__
    ]
