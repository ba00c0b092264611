"""What is wrong with a homework set and with its problem files, as far as reading them tells; nothing is solved."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.errors import Diagnostic, FileProblem
from planar_cli.homework.set_file import SetProblem, read_set
from planar_cli.problem.scene import Problem
from planar_cli.problem.structure import load
from planar_cli.records import record

IS_SET = "PL345"
"""What is told of a set where a problem file is asked for."""


@record
class Validated:
    """A file that was read, what is wrong with it, and its text."""

    path: str
    wrong: tuple[Diagnostic, ...]
    source: str


def validated(path: str) -> Iterator[Validated]:
    """A problem file; of a set the set file itself, and every problem file that it lists and that is there."""
    _, wrong, source = load(path)
    if all(d.code != IS_SET for d in wrong):
        yield Validated(path, tuple(wrong), source)
        return
    try:
        homework_set = read_set(path)
    except FileProblem as error:
        yield Validated(path, tuple(error.diagnostics), source)
        return
    read = [(p, load(p.path)) for p in homework_set.problems]
    unknown = [d for p, (problem, own, _) in read if problem is not None and not own for d in _unknown(p, problem)]
    yield Validated(path, tuple(unknown), source)
    for p, (_, own, text) in read:
        yield Validated(p.path, tuple(own), text)


def _unknown(own: SetProblem, problem: Problem) -> Iterator[Diagnostic]:
    """Points or words for finds that the problem does not have."""
    names = list(dict.fromkeys(f.name for one in (problem, *(c.problem for c in problem.cases)) for f in one.find))
    for name in dict.fromkeys((*own.points, *own.ask)):
        if name not in names:
            text = f"{own.path} has no find '{name}'"
            yield Diagnostic(own.mark, "PL802", text, f"there are {', '.join(names)}")
