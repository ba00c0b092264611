"""States that may never be reached: a motion is solved with them, and where that fails without them.

Only states that `reached(s)` asks about may be left out; of a state that is left out nothing else can be asked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations
from typing import TypeVar

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Find, Problem

UNREACHED = frozenset(("PL620", "PL621"))
Solved = TypeVar("Solved")


def reaching(problem: Problem, solve: Callable[[Problem], Solved]) -> Solved:
    """What `solve` makes of a problem, as few states left out as can be, the last ones first."""
    doubtful = [s.name for s in problem.states if s.name in asked_about(problem)]
    first: NoSolution | None = None
    for left_out in _choices(doubtful):
        try:
            return solve(_without(problem, left_out, first))
        except NoSolution as error:
            if not {d.code for d in error.diagnostics} & UNREACHED:
                raise
            first = first or error
    assert first is not None
    raise first


def _choices(doubtful: list[str]) -> Iterator[tuple[str, ...]]:
    for n in range(len(doubtful) + 1):
        yield from combinations(reversed(doubtful), n)


def asked_about(problem: Problem) -> set[str]:
    """States that reached(s) names."""
    return {
        node.things[0]
        for formula in formulas(problem)
        for node in walk(formula.tree)
        if isinstance(node, Quantity) and node.word == "reached"
    }


def _without(problem: Problem, left_out: tuple[str, ...], why: NoSolution | None) -> Problem:
    """The problem without some states. NoSolution: something else is asked about one of them."""
    if not left_out:
        return problem
    for find in problem.find:
        names = _states_of(find) & set(left_out)
        if names:
            name = min(names)
            text = f"{find.name}: state {name} is never reached, so there is nothing to tell of it"
            hint = f"ask only `reached({name})`, or put what needs it into a case where it is reached"
            assert why is not None
            raise NoSolution([*why.diagnostics, Diagnostic(find.mark, "PL621", text, hint)])
    return replace(problem, states=tuple(s for s in problem.states if s.name not in left_out))


def _states_of(find: Find) -> set[str]:
    """States at which something is asked (a truth about a state is not)."""
    found: set[str] = set()
    for node in walk(find.found.what):
        at = getattr(node, "at", None)
        if isinstance(node, Quantity | Name) and at is not None:
            found |= set(at) if isinstance(at, tuple) else {at}
        elif at is not None:
            found.add(at)
    return found
