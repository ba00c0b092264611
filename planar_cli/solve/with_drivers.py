"""What keeps a prescribed motion going takes part only where the bodies do not move so by themselves."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_cli.errors import NoSolution
from planar_cli.solve.instant.instant import Instant
from planar_cli.solve.solution import InstantSolution

Solved = tuple[InstantSolution, list[Any]]


def with_drivers(instant: Instant, solve: Callable[[], Solved]) -> Solved:
    """What `solve` makes of an instant, with what drives its prescribed motions if it has no solution without."""
    if not (instant.drives_at_will and instant.add_drivers()):
        try:
            solved = solve()
        except NoSolution:
            if not instant.add_drivers():
                raise
        else:
            if not _lacks_a_driver(solved[0]) or not instant.add_drivers():
                return solved
    return solve()


def _lacks_a_driver(solution: InstantSolution) -> bool:
    """Did more natural modes fail for nothing but that their equations contradict each other? With what drives a
    prescribed motion they may hold: a light wedge is kept going against what presses on it.
    """
    departs = sum(map(bool, solution.trial.choice))
    return any(t.objection == "contradiction" and sum(map(bool, t.choice)) < departs for t in solution.rejected)
