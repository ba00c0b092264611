"""A problem with what its statements mean written out: rates of what is largest at a given place, balances of knots,
the mass of a body in the law of a force on it.
"""

from __future__ import annotations

from planar_cli.problem.implied.extreme_and_given import with_rates
from planar_cli.problem.implied.knots import with_balanced_knots
from planar_cli.problem.implied.own_masses import with_own_masses
from planar_cli.problem.scene.scene import Problem


def as_meant(problem: Problem) -> Problem:
    """The problem and its cases so; the same object where nothing is to be written out."""
    return with_own_masses(with_balanced_knots(with_rates(problem)))
