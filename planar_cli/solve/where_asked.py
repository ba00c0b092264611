"""What is not decided is told with its place: where no line of the file is at fault, that of what is asked."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from planar_cli.errors import Mark, PlanarError, Undecided, undecided_at
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.in_either_plane import in_either_plane
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.static_alone import whatever_kinetic
from planar_cli.solve.wherever import wherever


def where_asked(solve: Callable[..., PartSolution], problem: Problem, case: str, *rest: Any) -> PartSolution:
    """One part, by `solve(problem, case, …)`, whatever the kinetic coefficients are. Undecided: always with a line of
    the file, and what it keeps open.
    """
    try:
        return whatever_kinetic(partial(in_either_plane, partial(wherever, solve)), problem, case, *rest)
    except Undecided as error:
        if has_place(error, problem.file):
            raise
        mark = problem.find[0].mark if problem.find else Mark(problem.file, 1, 1)
        asked = ", ".join(f"`{f.name}`" for f in problem.find)
        of = f" (case {case})" if case else ""
        raise undecided_at(mark, f"{asked}{of}: not decided, {error}") from error


def has_place(error: PlanarError, file: str) -> bool:
    """Does it say where in the file, by diagnostics or at the beginning of its words?"""
    return bool(getattr(error, "diagnostics", ())) or str(error).startswith(f"{file}:")
