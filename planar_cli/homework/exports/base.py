"""The contract of an export: papers or results in, files of one course system out.

An export is a class with a `kind` (its name on the command line) whose docstring is its manual page. It writes nothing:
it returns file names and bytes, the same for the same input. What a system cannot take is told, never dropped silently.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import ClassVar

from planar_cli.homework.sets.paper import Paper, Result
from planar_cli.records import record


@record
class Exported:
    """What an export made."""

    files: Mapping[str, bytes]
    """Relative names, their parts joined by `/` and safe on every system, with the contents."""
    left_out: tuple[str, ...] = ()
    """Sentences: what the system cannot take, and where."""


class PaperExport(ABC):
    """An export of questions with their answers: made before the homework is handed out."""

    takes: ClassVar[str] = "papers"
    kind: ClassVar[str]

    @abstractmethod
    def export(self, papers: Sequence[Paper], title: str, seed: int) -> Exported:
        """The files of all variants. `title`: of the homework; `seed`: with which the variants were drawn."""


class ResultExport(ABC):
    """An export of what was graded."""

    takes: ClassVar[str] = "results"
    kind: ClassVar[str]

    @abstractmethod
    def export(self, results: Sequence[Result], title: str, excel: bool = False) -> Exported:
        """The files of a class. `excel`: tables begin with a byte order mark, by which Excel knows UTF-8."""
