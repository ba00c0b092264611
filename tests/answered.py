"""Problem files that are written out in a test, solved within a limit of time."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.commands._limit import time_limit
from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found

SECONDS = 60
Answers = dict[str, Found]


def solve(text: str, seconds: float = SECONDS) -> Answers:
    """All finds of a file, by name; what keeps it from being solved is raised."""
    problem, wrong = load_text(text)
    if wrong or problem is None:
        raise FileProblem(wrong)
    with time_limit(seconds):
        return {f.name: f for part in solve_problem(problem).parts for f in part.found}


def number(found: Found) -> Decimal:
    """The only number of a find, in SI units."""
    assert found.values is not None, f"{found.name} has no value but {found.expressions or found.word}"
    (value,) = found.values
    return value


def assert_close(found: Found, truth: Decimal | float | str, digits: int = 12) -> None:
    """A find with this value, to so many digits of its size (or of 1, if it is smaller than a thousandth)."""
    value, want = number(found), Decimal(truth)
    scale = max(abs(want), Decimal("1e-3"))
    assert abs(value - want) <= Decimal(10) ** -digits * scale, f"{found.name} = {value}, and not {want}"
