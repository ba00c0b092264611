"""What a file assumes of its unknowns is a statement about the instant or the first state, which selects among roots;
and an equation that it assumes of a letter gives that letter.

`assume` bounds letters, which are known without a number; an unknown has a value, and an inequality tells which.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from planar_cli.problem.language.expression import Name, Relation, Side, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem, Symbol


def with_assumed(problem: Problem) -> Problem:
    """The problem with what is assumed of unknowns where it selects, of coordinates too, at the only instant; and with
    `l = 2*d` among the values that are given.
    """
    problem = _with_equations(problem)
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


def _with_equations(problem: Problem) -> Problem:
    """Each equation that tells one letter by others is the value of that letter."""
    letters = {s.name: s for s in problem.symbols}
    told: dict[str, Symbol] = {}
    left = []
    for statement in problem.assume:
        found = _value_of(statement, letters.keys() - told.keys())
        if found is None:
            left.append(statement)
        else:
            name, value = found
            told[name] = replace(letters[name], value=value, unit=None)
    symbols = tuple(s for s in problem.symbols if s.name not in told)
    return replace(problem, assume=tuple(left), symbols=symbols, given=(*problem.given, *told.values()))


def _value_of(statement: Statement, letters: Collection[str]) -> tuple[str, Side] | None:
    """The letter that an equation gives, and its value."""
    if isinstance(statement, Relation) and statement.operator == "=":
        for one, other in ((statement.left, statement.right), (statement.right, statement.left)):
            if isinstance(one, Name) and one.name in letters and not _names(other, (one.name,)):
                return one.name, other
    return None


def _names(statement: Statement | Side, names: Collection[str]) -> bool:
    return any(isinstance(node, Name) and node.name in names for node in walk(statement))
