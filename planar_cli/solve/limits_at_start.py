"""A constant that is largest or smallest in the first state of a motion, `start: [at rest, mode(C) = stick, mu is
smallest]`: only what is only just so there bounds it, and nothing that follows.

So the start is an instant that is complete in itself, as a case of its own would be. What is found there is given to
the motion.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from itertools import chain, count
from typing import Any

from planar_cli.problem.language.expression import Equilibrium, Extreme, Found, Name, Relation, Statement, Word
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.scene.scene import Case, Find, Problem
from planar_cli.solve.states import stand_at_states

START, MOTION = "at_{}", "from_{}_on"
"""What the two parts are called, by the name of the first state; a page writes them as words."""


def with_limits_at_start(problem: Problem) -> Problem:
    """The problem with the start and the motion of every such file or case as two cases, one after the other; the same
    object where nothing of the kind is asked.
    """
    called = {case.name for case in problem.cases}
    own = list(_parted(problem, "", called))
    cases = [part for c in problem.cases for part in (_parted(c.problem, c.name, called) or (c,))]
    if not own and len(cases) == len(problem.cases):
        return problem
    return replace(problem, find=() if own else problem.find, cases=(*own, *cases))


def _parted(problem: Problem, case: str, called: Collection[str]) -> tuple[Case, ...]:
    """The start and the motion of the file, or of a case; nothing: no constant is chosen at its start. `called`: the
    names of the cases of the file.
    """
    extreme = _chosen(problem)
    if extreme is None or not isinstance(extreme.side, Name):
        return ()
    first, *others = problem.states
    name, mark = extreme.side.name, extreme.mark
    start = _unlike(f"{case}_{START.format(first.name)}" if case else START.format(first.name), called)
    asked = [f for f in problem.find if isinstance(f.found.what, Name) and f.found.what.name == name]
    finds = tuple(asked) or (_find(problem, name, extreme),)
    instant = replace(
        problem,
        instant=first.relations,
        states=(),
        find=finds,
        cases=(),
        motion=tuple(replace(law, during=None) for law in problem.motion if problem.holds_at_first(law.during)),
        joints=tuple(_acting(problem, problem.joints)),
        loads=tuple(_acting(problem, problem.loads)),
    )
    sought = next(s for s in problem.unknowns if s.name == name)
    known = replace(sought, value=Name(f"{start}.{finds[0].name}", None, mark), unit=None)
    motion = replace(
        problem,
        given=(*problem.given, known),
        unknowns=tuple(s for s in problem.unknowns if s.name != name),
        states=(replace(first, relations=tuple(r for r in first.relations if r is not extreme)), *others),
        find=tuple(f for f in problem.find if f not in asked),
        cases=(),
    )
    later = case or _unlike(MOTION.format(first.name), called)
    return (Case(start, instant, mark), Case(later, motion, mark))


def _chosen(problem: Problem) -> Extreme | None:
    """The constant that is largest or smallest as the motion begins, where a mode or an inequality can bound it."""
    if not problem.states[1:] or problem.states[0].before:
        return None
    said = problem.states[0].relations
    sought = {s.name for s in problem.unknowns}
    found = [r for r in said if isinstance(r, Extreme) and isinstance(r.side, Name) and r.side.name in sought]
    if len(found) != 1 or any(isinstance(r, Equilibrium) for r in said) or not any(map(_bounds, said)):
        return None
    return None if _asks_of_it_alone(problem) else found[0]


def _asks_of_it_alone(problem: Problem) -> bool:
    """Is all that is asked about the first state, which then stands as an instant as it is?"""
    first = problem.states[0].name
    there = all(name == first for f in problem.find for name in names_of_states(f.found.what))
    return there and stand_at_states(problem)


def _bounds(statement: Statement) -> bool:
    """Is it a mode, or an inequality, which may cease to hold?"""
    if not isinstance(statement, Relation):
        return False
    return statement.operator != "=" or any(isinstance(node, Word) for node in walk(statement))


def _acting(problem: Problem, members: tuple[Any, ...]) -> Iterator[Any]:
    """What acts as the motion begins, for as long as an instant lasts; no impulse does."""
    for member in members:
        if problem.holds_at_first(member.during) and not member.strikes:
            yield replace(member, during=None)


def _find(problem: Problem, name: str, extreme: Extreme) -> Find:
    """That constant, asked for by its own name, unless something else that is asked has it."""
    asked = {f.name for f in problem.find} | {f.name for case in problem.cases for f in case.problem.find}
    what = Found(Name(name, None, extreme.mark), None, name, extreme.mark)
    return Find(_unlike(name, asked), what, extreme.mark)


def _unlike(name: str, taken: Collection[str]) -> str:
    """The name, with a number where it is taken."""
    return next(n for n in chain((name,), (f"{name}_{i}" for i in count(2))) if n not in taken)
