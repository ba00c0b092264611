"""Speeds that `motion` prescribes without their sense: with one of two senses a motion begins, and with the other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from planar_cli.equation.setup import Earlier, numbers_of
from planar_cli.errors import NoSolution, PlanarError
from planar_cli.problem.expression import Quantity
from planar_cli.problem.scene import Problem
from planar_cli.problem.walk import walk

BOTH_WAYS = "PL618"
HINT = "prescribe a component, which has a sign, as `v(P).x = -2 m/s`"


def demand_sense(problem: Problem, earlier: Mapping[str, Earlier]) -> None:
    """NoSolution: what is said of the start holds both ways. Of letters without numbers nothing is asked."""
    sizes = (node for law in problem.motion for node in walk(law.statement) if _is_size(node))
    if problem.symbols or problem.unknowns or next(sizes, None) is None:
        return
    from planar_cli.simulate.run import prepared

    try:
        prepared(problem, numbers_of(earlier))
    except NoSolution as error:
        wrong = [replace(d, hint=HINT) for d in error.diagnostics if d.code == BOTH_WAYS]
        if wrong:
            raise NoSolution(wrong) from error
    except PlanarError:
        # What keeps the motion from being followed is told where it is followed.
        return


def _is_size(node: object) -> bool:
    """Is it the size of a velocity?"""
    return isinstance(node, Quantity) and node.word == "v" and [p.kind for p in node.parts] == ["mag"]
