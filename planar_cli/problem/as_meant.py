"""A problem with what its statements mean written out: rates of what is largest at a given place, balances of knots."""

from __future__ import annotations

from planar_cli.problem.extreme_and_given import with_rates
from planar_cli.problem.knots import with_balanced_knots
from planar_cli.problem.scene import Problem


def as_meant(problem: Problem) -> Problem:
    """The problem and its cases so; the same object where nothing is to be written out."""
    return with_balanced_knots(with_rates(problem))
