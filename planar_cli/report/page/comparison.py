"""Methods side by side: how many equations each needs, and which answers it reaches."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Protocol

from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Document, Table, line

HEADER = ("Method", "Equations", "Largest block", "Answers", "Objection")


class MethodRow(Protocol):
    """One method: `answers` are the finds it reaches; `objection` says why it does not reach the others."""

    @property
    def method(self) -> str: ...
    @property
    def equations(self) -> int: ...
    @property
    def largest_block(self) -> int: ...
    @property
    def answers(self) -> Sequence[str]: ...
    @property
    def objection(self) -> str: ...


def comparison_document(problem: Problem, rows: Iterable[MethodRow]) -> Document:
    """A table with one row for each method."""
    cells = tuple(
        tuple(
            line(text)
            for text in (
                row.method,
                str(row.equations) if row.answers else "-",
                str(row.largest_block) if row.answers else "-",
                ", ".join(row.answers) or "-",
                row.objection or "-",
            )
        )
        for row in rows
    )
    table = Table(tuple(line(word) for word in HEADER), cells)
    return Document(problem.title or problem.file, (table,))


def comparison_data(problem: Problem, rows: Iterable[MethodRow]) -> dict[str, Any]:
    """The same for programs."""
    methods = [
        {
            "method": row.method,
            "equations": row.equations,
            "largest_block": row.largest_block,
            "answers": list(row.answers),
            "objection": row.objection,
        }
        for row in rows
    ]
    return {"schema_version": 1, "problem": problem.title or problem.file, "methods": methods}
