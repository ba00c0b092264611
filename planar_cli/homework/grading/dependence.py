"""Which finds rest on which in the equations: into them the student's own values of those are carried."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import sympy as sp

    from planar_cli.homework.variants.worked_problem import Part, WorkedProblem
    from planar_cli.replay.equations import Equations

Behind = tuple[tuple[str, tuple[str, ...]], ...]
"""By find, where there are any: the finds on which it rests."""


def behind_each(problem: WorkedProblem) -> Behind:
    """The finds on which each find rests. Of two that rest on each other, as those of one system of equations do, the
    later in the file rests on the earlier.
    """
    order = [found.name for _, found in problem.finds]
    rests: dict[str, set[str]] = {name: set() for name in order}
    for later, earlier in _pairs(problem):
        rests[later].add(earlier)
    for k, name in enumerate(order):
        rests[name] -= {other for other in order[k + 1 :] if name in rests[other]}
    return tuple((name, tuple(n for n in order if n in rests[name])) for name in order if rests[name])


def together_each(problem: WorkedProblem) -> Behind:
    """By find: those that simultaneous equations give only together with what it is made of, as two tensions and the
    acceleration that makes its velocity.
    """
    found = []
    for part, one in problem.finds:
        equations = None if part.replay is None else part.replay.equations
        if equations is None or one.name not in equations.asked:
            continue
        rests = equations.rests_on(equations.asked[one.name].parts)
        names = []
        for name in equations.asked:
            unknown = only_unknown(equations, name)
            others = {s for step in equations.steps if unknown in step.unknowns for s in step.unknowns} - {unknown}
            if name != one.name and not rests.isdisjoint(others):
                names.append(name)
        if names:
            found.append((one.name, tuple(names)))
    return tuple(found)


def _pairs(problem: WorkedProblem) -> Iterator[tuple[str, str]]:
    """A find, and one on which it rests."""
    from planar_cli.homework.grading.followed_again import rests_on

    yield from rests_on(problem)
    for part, found in problem.finds:
        for other in problem.parts:
            if other.replay is None:
                continue
            equations, symbols = _held(part, found.name, other)
            for name, asked in equations.asked.items():
                if name != found.name and not symbols.isdisjoint(equations.rests_on(asked.parts)):
                    yield name, found.name


def _held(part: Part, find: str, other: Part) -> tuple[Equations, frozenset[sp.Symbol]]:
    """The equations of `other` as an own value of the find is put into them, and the symbols that have it."""
    from planar_cli.homework.grading.own_vectors import own_component, with_own

    assert other.replay is not None
    equations = other.replay.equations
    if other is not part:
        link = equations.inputs.get(f"{part.solution.case}.{find}")
        return equations, frozenset() if link is None else frozenset((link,))
    if find not in equations.asked:
        return equations, frozenset()
    parts = equations.asked[find].parts
    if len(parts) != 2:
        unknown = only_unknown(equations, find)
        return equations, frozenset() if unknown is None else frozenset((unknown,))
    letters = (own_component(find, place) for place in range(len(parts)))
    return with_own(other.replay, (find,)), frozenset((*letters, *(p for p in parts if p.is_Symbol)))


def only_unknown(equations: Equations, find: str) -> sp.Symbol | None:
    """The one unknown of which a find is made; None: there are more, or it is one that others define."""
    asked = equations.asked.get(find)
    if asked is None or len(asked.parts) != 1:
        return None
    given = set(equations.inputs.values())
    unknowns = [s for s in asked.parts[0].free_symbols if s not in given]
    return unknowns[0] if len(unknowns) == 1 and unknowns[0] not in equations.defined else None


def in_turn(names: Sequence[str], behind: Mapping[str, Sequence[str]]) -> Iterator[int]:
    """The places of finds, each behind those on which it rests, else in the order of the file."""
    left = dict(enumerate(names))
    while left:
        waiting = set(left.values())
        place = next((k for k, n in left.items() if waiting.isdisjoint(behind.get(n, ()))), next(iter(left)))
        del left[place]
        yield place
