"""A set and its problems made ready: plain data with everything that grading and handing out need."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.homework.sets.paper import Paper, Task
from planar_cli.homework.sets.rules import Rules
from planar_cli.records import record

RULES = Rules()
Values = tuple[tuple[str, str], ...]
"""The given names of a variant with their values, as a file writes them."""


@record
class Prepared:
    """One problem of a set, ready: its tasks by variant (0: the file itself), and what carrying errors needs (pickled,
    as only a wrong answer needs it). `warnings`: of its variants.
    """

    name: str
    tasks: tuple[Task, ...]
    carrying: bytes
    warnings: tuple[str, ...] = ()
    tried: int = 0
    taken: int = 0
    rejected: tuple[tuple[str, int], ...] = ()
    values: tuple[Values, ...] = ()
    """Of each task."""


@record
class Homework:
    """A set with everything that grading and handing out need."""

    title: str
    text: str
    papers: Mapping[int, Paper]
    carrying: Mapping[str, bytes]
    digest: str
    """Of all that is right: results of another key do not fit."""
    warnings: tuple[str, ...] = ()
    rules: Rules = RULES
    students: tuple[tuple[str, int], ...] = ()
    """Those that the set lists, with their variants."""
