"""One file checked: read, solved, and compared with the answers that it states; plain data that crosses processes."""

from __future__ import annotations

from planar_cli.errors import Diagnostic, FileProblem, NoSolution, PlanarError
from planar_cli.homework.checking.answers import compare
from planar_cli.homework.checking.verdict import Verdict
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load
from planar_cli.records import record
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

AGREES, DISAGREES, NO_SOLUTION, BAD, UNDECIDED, FAULT = (
    "agrees",
    "disagrees",
    "no solution",
    "bad file",
    "undecided",
    "fault",
)


@record
class Checked:
    """What came of one file: one of the outcomes above, a verdict for each stated answer, and what went wrong."""

    path: str
    title: str
    outcome: str
    verdicts: tuple[Verdict, ...] = ()
    message: str = ""
    diagnostics: tuple[Diagnostic, ...] = ()
    seconds: float = 0.0


def read(path: str) -> Problem:
    """The problem of a file; FileProblem with everything that is wrong with it."""
    problem, wrong, _ = load(path)
    if wrong or problem is None:
        raise FileProblem(wrong)
    return problem


def solve_and_compare(problem: Problem, method: str | None = None) -> tuple[Solution, tuple[Verdict, ...]]:
    """The solution, by the file's own method unless another is named, and a verdict for each stated answer."""
    solution = solve_problem(problem, method or problem.method)
    return solution, compare(solution)


def check_file(path: str) -> Checked:
    """Solve one file and compare; only a fault of our own is raised."""
    title = ""
    try:
        problem = read(path)
        title = problem.title
        _, verdicts = solve_and_compare(problem)
    except PlanarError as error:
        return _failed(path, title, error)
    outcome = AGREES if all(v.agrees for v in verdicts) else DISAGREES
    return Checked(path, title, outcome, verdicts)


def _failed(path: str, title: str, error: PlanarError) -> Checked:
    match error:
        case NoSolution():
            return Checked(path, title, NO_SOLUTION, (), str(error), error.diagnostics)
        case FileProblem():
            return Checked(path, title, BAD, (), str(error), error.diagnostics)
    return Checked(path, title, UNDECIDED, (), str(error))
