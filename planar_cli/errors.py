"""Where something stands in a file, what is wrong with it, and the exceptions that carry it to the user.

PlanarError                 anything that a user can mend; never shown as a traceback
├── FileProblem             a bad file: one or several located diagnostics          exit status 2
├── NoSolution              the problem has no solution, or several                 exit status 1
└── Undecided               within the limits it could not be decided               exit status 3
"""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.records import record


@record
class Mark:
    """A place in a file: line and column count from 1."""

    file: str
    line: int
    column: int

    def __lt__(self, other: Mark) -> bool:
        return (self.file, self.line, self.column) < (other.file, other.line, other.column)

    def shifted(self, columns: int) -> Mark:
        """The place `columns` further right on the same line."""
        return Mark(self.file, self.line, self.column + columns)


NOWHERE = Mark("", 0, 0)


@record
class Diagnostic:
    """One thing that is wrong: `code` (PL101 …), a sentence, the place, and a hint that says what to write."""

    mark: Mark
    code: str
    message: str
    hint: str = ""


class PlanarError(Exception):
    """Something that the user can mend."""


class FileProblem(PlanarError):
    """A problem file that cannot be used; carries every diagnostic found, sorted by place."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(sorted(diagnostics, key=lambda d: (d.mark, d.code, d.message)))
        super().__init__("; ".join(d.message for d in self.diagnostics))


def refuse(mark: Mark, code: str, message: str, hint: str = "") -> FileProblem:
    """The located error of one place."""
    return FileProblem([Diagnostic(mark, code, message, hint)])


class NoSolution(PlanarError):
    """The scene contradicts itself, leaves something open, or has no consistent case; located diagnostics say which."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("; ".join(d.message for d in self.diagnostics))


class Fault(Exception):
    """Planar itself failed at one of several tasks: which, and how."""


class NoValue(ArithmeticError):
    """A formula has no real number at a place: 1/0, the root of a negative number, an integral that does not exist."""


class NotReached(NoValue):
    """A numerical method stops before its goal; the message says where."""


class Undecided(PlanarError):
    """Not decided within the limits; the message says what was tried."""


class Unplanned(Undecided):
    """What is determined, but by no equations that can be solved in turn; located diagnostics say what helps."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("; ".join(d.message for d in self.diagnostics))


class UndecidedFiles(Undecided):
    """Of several files one at least was not decided; located diagnostics tell of all with which something is wrong."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("; ".join(d.message for d in self.diagnostics))


class TimeIsUp(BaseException):
    """Like KeyboardInterrupt it is no Exception: no road that looks for another way out may take it for a failure of
    its own, or what is printed would depend on the clock.
    """


def undecided_at(mark: Mark, text: str) -> Undecided:
    """The same with the line of the file that it is about."""
    return Undecided(f"{mark.file}:{mark.line}: {text}")
