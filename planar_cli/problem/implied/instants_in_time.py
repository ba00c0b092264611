"""An instant whose time follows from what it says is a state of the motion: `x(P) = 3 m`, where `motion` tells x(t)."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.expression import Equilibrium, Extreme, Grouped, Name, Quantity, Relation, Side, Word
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Find, Problem, State

STATE = "1"


def with_dated_instants(problem: Problem) -> Problem:
    """The problem, and its cases, with such an instant as the only state."""
    cases = tuple(replace(c, problem=_dated(c.problem)) for c in problem.cases)
    return replace(_dated(problem), cases=cases)


def _dated(problem: Problem) -> Problem:
    now = problem.instant or ()
    if not any(isinstance(s, Relation) and s.operator == "=" for s in now):
        return problem
    if any(isinstance(s, Extreme | Equilibrium) for s in now):
        return problem
    stated = [*now, *(f.found.what for f in problem.find)]
    # An inequality as `t > 0` does not tell the time, it chooses among the times that the equations leave.
    telling = [tree for tree in now if not (isinstance(tree, Relation) and tree.operator != "=")]
    if any(_is_time(node) for tree in telling for node in walk(tree)) or any(_is_told(f) for f in problem.find):
        return problem
    apart = {id(tree) for tree in stated}
    if not any(_is_time(n) for f in formulas(problem) if id(f.tree) not in apart for n in walk(f.tree)):
        return problem
    state = State(STATE, now, now[0].mark, dated=True)
    return replace(problem, instant=None, states=(state,), find=tuple(_at_it(f) for f in problem.find))


def _is_time(node: object) -> bool:
    return isinstance(node, Name) and node.name == "t"


def _is_told(find: Find) -> bool:
    """Does it hold all the time, as a curve does, or between states?"""
    what = find.found.what
    return isinstance(what, Quantity) and (what.word in ("path", "hodograph") or isinstance(what.at, tuple))


def _at_it(find: Find) -> Find:
    what = find.found.what
    if isinstance(what, Relation):
        there: Side | Relation = replace(what, left=_at(what.left), right=_at(what.right))
    else:
        there = _at(what)
    return replace(find, found=replace(find.found, what=there))


def _at(side: Side) -> Side:
    if isinstance(side, Quantity | Name):
        return replace(side, at=STATE)
    return side if isinstance(side, Word) else Grouped(side, STATE, side.mark)
