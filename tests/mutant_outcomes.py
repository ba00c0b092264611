"""What comes of a problem file with one change: its answers and page beside those of the file itself."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any
from unittest import mock

from mutants import Mutant, mutated

from planar_cli.errors import Diagnostic, FileProblem, NoSolution, Undecided
from planar_cli.homework.checking import solve_and_compare
from planar_cli.problem import nodes
from planar_cli.problem.scene import Problem
from planar_cli.problem.structure import problem_of
from planar_cli.registry import members
from planar_cli.report.json_document import answers_data
from planar_cli.report.narrate import Voice, narrate
from planar_cli.solve import run as run_of_files
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.where_asked import has_place

SOLVED, UNCHANGED, FAULT, UNDECIDED = "solved", "unchanged", "fault", "undecided"
ANOTHER = "another answer"
ALIKE = 1e-9
"""Numbers that differ by less of their size are compared as they are printed."""
Numbers = dict[str, tuple[float, ...] | None]


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a file or mutant. `answers`: to all digits, by name; `page`: all that is told."""

    kind: str
    detail: str = ""
    answers: str = ""
    page: str = ""
    parts: Mapping[str, Numbers] = field(default_factory=dict)
    """The numbers that are found, by case and name."""


class Differs(BaseException):
    """A part has other numbers than that of the file: no more need be worked out. No handler takes it."""


def read(file: str, root: nodes.Node, mutant: Mutant | None) -> Problem | Outcome:
    """The problem of a file as it stands, or with one change; or the refusal."""
    tree = root if mutant is None else mutated(root, mutant.at, mutant)
    assert tree is not None
    problem, found = problem_of(file, tree, [])
    return _failed("refused", found) if found or problem is None else problem


def _failed(kind: str, diagnostics: Sequence[Diagnostic]) -> Outcome:
    place = "" if diagnostics and diagnostics[0].mark.line else "no place: "
    return Outcome(kind, place + ", ".join(sorted({d.code for d in diagnostics})))


def solved(problem: Problem, base: Outcome | None = None) -> Outcome:
    """A problem worked out; its page only where the answers are those of `base`."""
    parts: dict[str, Numbers] = {}
    try:
        with _seeing_parts(parts, {} if base is None else base.parts):
            solution, _ = solve_and_compare(problem)
    except Differs:
        return Outcome(SOLVED)
    except (FileProblem, NoSolution) as error:
        return _failed("refused" if isinstance(error, FileProblem) else "no solution", error.diagnostics)
    except Undecided as error:
        return Outcome(UNDECIDED, ("" if has_place(error, problem.file) else "no place: ") + str(error))
    answers = json.dumps(answers_data(solution, 12), default=str, sort_keys=True)
    if base is not None and answers != base.answers:
        return Outcome(SOLVED, "", answers)
    page = members("formats")["markdown"]().render(narrate(solution, Voice(12)))
    return Outcome(SOLVED, "", answers, page, parts)


@contextmanager
def _seeing_parts(parts: dict[str, Numbers], base: Mapping[str, Numbers]) -> Iterator[None]:
    """Each part that is solved meanwhile goes to `parts` by its case. Differs: it has other numbers than in `base`."""
    solve_part = run_of_files.where_asked

    def seen(solve: Callable[..., PartSolution], problem: Problem, case: str, *rest: Any) -> PartSolution:
        part = solve_part(solve, problem, case, *rest)
        parts[case] = {f.name: f.values and tuple(map(float, f.values)) for f in part.found}
        if case in base and _differ(parts[case], base[case]):
            raise Differs
        return part

    with mock.patch.object(run_of_files, "where_asked", seen):
        yield


def _differ(some: Numbers, others: Numbers) -> bool:
    """Do two parts have different numbers for what they both ask?"""
    pairs = [(some[name], others[name]) for name in some.keys() & others.keys()]
    both = [(a, b) for a, b in pairs if a is not None and b is not None]
    return any(
        len(a) != len(b) or any(abs(x - y) > ALIKE * max(abs(x), abs(y)) for x, y in zip(a, b, strict=True))
        for a, b in both
    )


def judged(mutant: Mutant, base: Outcome, outcome: Outcome) -> tuple[str, str]:
    """The outcome of a mutant in a word or two, and what more there is to say."""
    if outcome.kind != SOLVED:
        return outcome.kind, outcome.detail
    if outcome.answers != base.answers:
        return ANOTHER, ""
    if outcome.page != base.page:
        return "told", ""
    return mutant.reason or UNCHANGED, ""
