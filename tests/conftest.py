"""What several tests share."""

from __future__ import annotations

import gc
import os
import re
from functools import cache
from pathlib import Path

import pytest

from planar_cli.later import CLUTTER, defer

ROOT = Path(__file__).parent.parent
PROBLEMS = sorted(p for p in (ROOT / "problems").rglob("*.yaml") if p.parent.name != "hard")
"""All files with a printed page that is kept; those in `hard` are held by their answers alone."""

# As on the command line, before any test loads SymPy.
gc.set_threshold(CLUTTER, 20, 20)
defer()

# What is printed into a pipe keeps to these where they are set, as by those who run tests on several workers.
for name in ("COLUMNS", "LC_ALL"):
    os.environ.pop(name, None)

HELD: set[Path] = set()
"""The problem files whose printed page this run compares with the golden file, on one worker or another."""


def pytest_collection_finish(session: pytest.Session) -> None:
    """Each worker collects all tests of the run."""
    for item in session.items:
        if isinstance(item, pytest.Function) and item.originalname == "test_printed_solution":
            path = item.callspec.params["path"]
            assert isinstance(path, Path)
            HELD.add(path)


@cache
def solves_problems(file: str) -> bool:
    """Does a file of tests look at solutions of the files of problems/?"""
    return bool(re.search(r"^from worked import .*\bworked\b", (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: object) -> object:
    """As `--dist loadfile` shares out a run, but all files that look at solved problems go to one worker, which solves
    each of these once.
    """
    from xdist.scheduler import LoadFileScheduling

    class Together(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            file = super()._split_scope(nodeid)
            return "solved problems" if solves_problems(file) else file

    return Together(config, log) if config.getvalue("dist") == "loadfile" else None
