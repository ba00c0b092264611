"""What a file assumes of its unknowns is a statement about the instant or the first state, which selects among roots.

`assume` bounds letters, which are known without a number; an unknown has a value, and an inequality tells which.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from planar_cli.problem.expression import Name, Relation, Statement
from planar_cli.problem.scene import Problem
from planar_cli.problem.walk import walk


def with_assumed(problem: Problem) -> Problem:
    """The problem with what is assumed of unknowns where it selects; of coordinates too, at the only instant."""
    if problem.instant is None and not problem.states:
        return problem
    open_names = {s.name for s in problem.unknowns}
    open_names |= {s.name for s in problem.coordinates} if problem.instant is not None else set()
    moved = tuple(s for s in problem.assume if isinstance(s, Relation) and _names(s, open_names))
    if not moved:
        return problem
    left = tuple(s for s in problem.assume if s not in moved)
    if problem.instant is not None:
        return replace(problem, assume=left, instant=(*problem.instant, *moved))
    first, *others = problem.states
    return replace(problem, assume=left, states=(replace(first, relations=(*first.relations, *moved)), *others))


def _names(statement: Statement, names: Collection[str]) -> bool:
    return any(isinstance(node, Name) and node.name in names for node in walk(statement))
