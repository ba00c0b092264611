"""What the worked solution of a problem costs, beside following its motion."""

from __future__ import annotations

import time
from dataclasses import dataclass

from planar_cli.errors import PlanarError
from planar_cli.problem.scene import Problem


@dataclass(frozen=True, slots=True)
class Solved:
    """One problem solved."""

    digits: int | None
    """To so many digits two independent roads agree; None where there is no solution."""
    seconds: float
    """With the import of what it needs."""
    why: str = ""
    """Why there is no solution."""

    @property
    def words(self) -> str:
        """As a sentence."""
        if self.digits is None:
            return f"`planar solve` gives no answer: {self.why}"
        return (
            f"`planar solve` takes {self.seconds:.2g} s and is certain of {self.digits} digits, however many are asked."
        )


def solved(problem: Problem) -> Solved:
    """Solve the problem and look at its checks."""
    began = time.perf_counter()
    try:
        from planar_cli.solve.run import solve_problem

        solution = solve_problem(problem)
    except PlanarError as error:
        return Solved(None, time.perf_counter() - began, str(error))
    digits = [instant.checks.get("digits") for part in solution.parts for instant in part.instants]
    known = [d for d in digits if d is not None]
    return Solved(min(known, default=None), time.perf_counter() - began, "" if known else "nothing was compared")
