"""What a worked solution costs: how many digits are certain, and the time that it takes."""

from __future__ import annotations

import time

from planar_cli.errors import PlanarError
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.solving import Solved
from planar_cli.solve.run import solve_problem


def solved(problem: Problem) -> Solved:
    """Solve the problem and look at its checks."""
    began = time.perf_counter()
    try:
        solution = solve_problem(problem)
    except PlanarError as error:
        return Solved(None, time.perf_counter() - began, str(error))
    digits = [instant.checks.get("digits") for part in solution.parts for instant in part.instants]
    known = [d for d in digits if d is not None]
    read_off = any(part.followed is not None for part in solution.parts)
    why = "it reads them off a motion that is followed" if read_off else "nothing was compared"
    return Solved(min(known, default=None), time.perf_counter() - began, "" if known else why)
