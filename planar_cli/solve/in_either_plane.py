"""Bodies with mass in a file that names no plane, where motion alone is asked.

Where the motion is told as such, no mass has a part in it, and no weight. Else the answers must be the same with weight
and without it: so a momentum or a kinetic energy is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from planar_cli.errors import NoSolution, Undecided
from planar_cli.problem.checks.check_physics import ACCELERATIONS, OF_MOTION, is_told_as_motion, no_plane
from planar_cli.problem.language.expression import Law, Quantity, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Body, Composite, Problem
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.static_alone import same_answer

OF_MASSES = frozenset(("mass", "I", "KE", "momentum", "H"))


def in_either_plane(solve: Callable[..., PartSolution], problem: Problem, *rest: Any) -> PartSolution:
    """One part without weight. NoSolution: with it the answers would be others, so that the file must say which."""
    lacking = list(no_plane(problem)) if problem.plane is None and is_told_as_motion(problem) else []
    if not lacking:
        return solve(problem, *rest)
    lack: NoSolution | None = None
    if not asks_for_masses(problem):
        try:
            return solve(without_masses(problem), *rest)
        except NoSolution as error:
            lack = error
        except Undecided:
            # Masses have a part in it.
            pass
    for told in (problem, driven(problem)):
        try:
            part, other = (solve(p, *rest) for p in (told, replace(told, plane="vertical")))
        except (NoSolution, Undecided):
            continue
        if all(same_answer(one, two) for one, two in zip(part.found, other.found, strict=True)):
            return part
        raise NoSolution(lacking)
    raise NoSolution(lacking) if lack is None or _is_solved(solve, problem, *rest) else lack


def _is_solved(solve: Callable[..., PartSolution], problem: Problem, *rest: Any) -> bool:
    """Is the plane all that is lacking?"""
    try:
        solve(replace(problem, plane="vertical"), *rest)
    except (NoSolution, Undecided):
        return False
    return True


def driven(problem: Problem) -> Problem:
    """The problem in which something drives what its instant accelerates: whatever that is, the motion is the stated
    one.
    """
    stated = tuple(s for s in problem.instant or () if _accelerates(s))
    if not stated or problem.instant is None:
        return problem
    rest = tuple(s for s in problem.instant if s not in stated)
    return replace(problem, instant=rest, motion=(*problem.motion, *(Law(s, None) for s in stated)))


def _accelerates(statement: Statement) -> bool:
    """Is it an equation of accelerations, with nothing that only forces tell?"""
    if not isinstance(statement, Relation) or statement.operator != "=":
        return False
    words = {q.word for q in walk(statement) if isinstance(q, Quantity)}
    return bool(words & ACCELERATIONS) and words <= OF_MOTION


def asks_for_masses(problem: Problem) -> bool:
    """Is anything asked that masses are in?"""
    asked = (node for find in problem.find for node in walk(find.found.what))
    return any(isinstance(node, Quantity) and node.word in OF_MASSES for node in asked)


def without_masses(problem: Problem) -> Problem:
    """The problem with the masses of its bodies left out; that of a composite tells where its centre is."""
    bodies = tuple(b if isinstance(b.shape, Composite) else _light(b) for b in problem.bodies)
    return replace(problem, bodies=bodies)


def _light(body: Body) -> Body:
    return replace(body, mass=None, weight=None, any_mass=False, inertia=None, gyration=None, any_inertia=False)
