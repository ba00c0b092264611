"""What comes of a problem file with one change: its answers and page beside those of the file itself."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass

from mutants import Mutant, mutated

from planar_cli.errors import Diagnostic, FileProblem, NoSolution, Undecided
from planar_cli.homework.checking.checking import solve_and_compare
from planar_cli.problem.nodes import nodes
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import problem_of
from planar_cli.registry import members
from planar_cli.report.page.json_document import answers_data
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.solve.where_asked import has_place

SOLVED, UNCHANGED, FAULT, UNDECIDED = "solved", "unchanged", "fault", "undecided"
ANOTHER = "another answer"


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a file or mutant. `answers`: to all digits, by name; `page`: all that is told."""

    kind: str
    detail: str = ""
    answers: str = ""
    page: str = ""


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
    try:
        solution, _ = solve_and_compare(problem)
    except (FileProblem, NoSolution) as error:
        return _failed("refused" if isinstance(error, FileProblem) else "no solution", error.diagnostics)
    except Undecided as error:
        return Outcome(UNDECIDED, ("" if has_place(error, problem.file) else "no place: ") + str(error))
    answers = json.dumps(answers_data(solution, 12), default=str, sort_keys=True)
    if base is not None and answers != base.answers:
        return Outcome(SOLVED, "", answers)
    page = members("formats")["markdown"]().render(narrate(solution, Voice(12)))
    return Outcome(SOLVED, "", answers, page)


def judged(mutant: Mutant, base: Outcome, outcome: Outcome) -> tuple[str, str]:
    """The outcome of a mutant in a word or two, and what more there is to say."""
    if outcome.kind != SOLVED:
        return outcome.kind, outcome.detail
    if outcome.answers != base.answers:
        return ANOTHER, ""
    if outcome.page != base.page:
        return "told", ""
    return mutant.reason or UNCHANGED, ""
