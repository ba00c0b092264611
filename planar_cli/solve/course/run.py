"""A motion over time from the problem to its answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from planar_cli.equation.exact import Valuation
from planar_cli.problem.expression import JustAfter, Name, Quantity, Relation
from planar_cli.problem.formulas import formulas
from planar_cli.problem.scene import Problem
from planar_cli.problem.walk import walk
from planar_cli.solve.course.chain import Branch
from planar_cli.solve.course.course import Course, first_plot, make_course
from planar_cli.solve.course.finds import Asked, FindReader
from planar_cli.solve.course.plot import Workshop
from planar_cli.solve.course.timeline import SPANNED
from planar_cli.solve.solution import PartSolution


@dataclass(frozen=True, slots=True)
class MotionSolution:
    """A course with the branch that happens, and numbers of all its letters."""

    course: Course
    branch: Branch
    value: Valuation
    asked: tuple[Asked, ...]


def runs_in_time(problem: Problem) -> bool:
    """Does the file speak of time, of spans, or of what only a motion tells?"""
    if not problem.states and not any(_says_time(s) for s in problem.instant or ()):
        return False
    if any(isinstance(s, JustAfter) for state in problem.states for s in state.relations):
        return True
    if any(law.during for law in problem.motion):
        return True
    return any(_timed(node) for formula in formulas(problem) for node in walk(formula.tree))


def _says_time(statement: Any) -> bool:
    return isinstance(statement, Relation) and any(
        isinstance(n, Name) and n.name == "t" for n in walk(statement)
    )


def _timed(node: Any) -> bool:
    if isinstance(node, Name):
        return node.name == "t"
    return isinstance(node, Quantity) and (isinstance(node.at, tuple) or node.word in SPANNED)


def solve_course(problem: Problem, case: str, units: dict[str, str], earlier: Mapping[str, Any]) -> PartSolution:
    """All finds of a problem whose states follow each other in time."""
    workshop = Workshop(earlier)
    course = make_course(problem, first_plot(problem, workshop), workshop)
    finds = FindReader(course, units)
    finds.read()
    course.read()
    branch = course.solve()
    value = course.base().extended(branch.values)
    found = tuple(finds.answer(a, branch, value) for a in finds.asked)
    instants = tuple(r.general.solution for r in course.distinct_regimes() if r.general.solution is not None)
    return PartSolution(case, instants, found, MotionSolution(course, branch, value, tuple(finds.asked)))
