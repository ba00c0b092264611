"""A problem of a homework read and solved, with the parts of accelerations marked."""

from __future__ import annotations

from planar_cli.equation.values.parts_of_accelerations import marked
from planar_cli.errors import FileProblem, PlanarError
from planar_cli.problem.nodes.nodes import Node
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import problem_of
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution


def plainly_read(path: str, node: Node) -> Problem:
    """The problem of a tree as `planar solve` has it."""
    problem, wrong = problem_of(path, node, [])
    if problem is None or wrong:
        raise FileProblem(wrong)
    return problem


def marked_solution(problem: Problem) -> Solution:
    """The solution with the parts of accelerations marked in its equations, where it can be had so."""
    if has_letters(problem):
        return solve_problem(problem, problem.method)
    try:
        with marked():
            return solve_problem(problem, problem.method)
    except (PlanarError, Disagreement):
        return solve_problem(problem, problem.method)


def has_letters(problem: Problem) -> bool:
    """Are there letters without numbers, in the file or in a case?"""
    return bool(problem.symbols or any(c.problem.symbols for c in problem.cases))
