"""What is wrong with a homework set and with its problem files, as far as reading them tells; nothing is solved."""

from __future__ import annotations

import re
from collections.abc import Iterator

from planar_cli.errors import Diagnostic, FileProblem
from planar_cli.homework.sets.asked_words import asked_words
from planar_cli.homework.sets.printed_names import printed
from planar_cli.homework.sets.set_file import SetProblem, read_set
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import Problem
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
    warnings: tuple[str, ...] = ()
    """What hinders nothing."""


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
    said = [w for p, (problem, own, _) in read if problem is not None and not own for w in _said_to_nobody(p, problem)]
    yield Validated(path, tuple(unknown), source, tuple(said))
    for p, (_, own, text) in read:
        yield Validated(p.path, tuple(own), text)


def _unknown(own: SetProblem, problem: Problem) -> Iterator[Diagnostic]:
    """Points or words for finds that the problem does not have."""
    names = list(dict.fromkeys(f.name for one in (problem, *(c.problem for c in problem.cases)) for f in one.find))
    for name in dict.fromkeys((*own.points, *own.ask)):
        if name not in names:
            text = f"{own.path} has no find '{name}'"
            yield Diagnostic(own.mark, "PL802", text, f"there are {', '.join(names)}")


def _said_to_nobody(own: SetProblem, problem: Problem) -> Iterator[str]:
    """Finds of which the sheet asks by names that stand neither in the text nor in the figure, which has points and
    bodies: those of joints, loads and states.
    """
    finds = {f.name: (f, one) for one in (problem, *(c.problem for c in problem.cases)) for f in one.find}
    for name, (find, part) in finds.items():
        words, what = asked_words(find), find.found.what
        if name in own.ask or not isinstance(what, Quantity) or words == printed(name):
            continue
        seen = {p.name for p in part.points} | {b.name for b in part.bodies}
        at = what.at if isinstance(what.at, tuple) else (what.at or "",)
        states = [s for s in at if s and not _stands(f"state {s}", problem.text)]
        things = [n for t in what.things if t != "all" for n in t.split("/") if n not in seen]
        strange = [t for t in things if not _stands(t, problem.text)]
        if strange or states:
            told = ", ".join([*(f"'{t}'" for t in strange), *(f"state {s}" for s in states)])
            mend = f"say it in your words by `ask: {{{name}: …}}`"
            yield f"{own.name}.{name} asks for the {words}, and the text does not tell {told}; {mend}"


def _stands(words: str, text: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(words)}(?!\w)", text, re.IGNORECASE) is not None
