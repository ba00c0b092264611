"""Names that a file declares and that nothing uses: what stands in a file takes part, or is told not to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from planar_cli.errors import Diagnostic
from planar_cli.problem.language.expression import Name, Quantity, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem, Symbol

UNNAMED = frozenset(("mark", "text", "unit"))
"""Fields that hold no name."""


def check_unknowns(problem: Problem) -> Iterator[Diagnostic]:
    """An unknown that nothing uses but the relation which states it."""
    parts = [problem, *(case.problem for case in problem.cases)]
    used = set().union(*(used_names(part) for part in parts))
    seen: dict[str, Symbol] = {s.name: s for part in reversed(parts) for s in part.unknowns}
    for name, symbol in seen.items():
        if name not in used and symbol.unit is not None:
            text = f"nothing uses the unknown {name}"
            hint = f"say what it is, such as `x(P) = {name}`, or ask for it under `find`; else leave it out"
            yield Diagnostic(symbol.mark, "PL459", text, hint)


def unused(problem: Problem) -> list[str]:
    """The names of `given` and `symbols` on which neither the scene nor a find of any part rests. A surface is no
    datum: something may lie or roll on it by the way in which it is placed.
    """
    parts = [problem, *(case.problem for case in problem.cases)]
    used = set().union(*(used_names(part) for part in parts))
    return [s.name for s in (*problem.given, *problem.symbols) if s.name not in used]


def used_names(problem: Problem) -> set[str]:
    """Every name that bodies, joints, loads, statements or finds rest on, directly or by other names."""
    known = {s.name for s in (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)}
    stated = [*problem.assume, *(law.statement for law in problem.motion), *(problem.instant or ())]
    stated += [s for state in problem.states for s in state.relations]
    ties = [names for s in stated if (names := only_names(s, known)) is not None]
    scene = (problem.bodies, problem.joints, problem.loads, [s for s in stated if only_names(s, known) is None])
    roots = names_of(scene) | names_of([f.found.what for f in problem.find])
    # Weight and the friction of what lies on a table rest on g without naming it.
    return _reached(roots, _rests(problem), ties) | {"g"}


def idle_coordinates(problem: Problem) -> list[str]:
    """The coordinates with which nothing of the scene moves, and of whose motion no law tells either."""
    roots = names_of((problem.bodies, problem.joints, problem.loads, [law.statement for law in problem.motion]))
    used = coordinates_behind(roots, problem)
    return [c.name for c in problem.coordinates if c.name not in used]


def coordinates_behind(names: set[str], problem: Problem) -> set[str]:
    """The coordinates with which numbers, points or surfaces are written, directly or by others."""
    return _reached(names, _rests(problem), []) & {c.name for c in problem.coordinates}


def _rests(problem: Problem) -> dict[str, set[str]]:
    """The names on which a number, a point or a surface rests directly."""
    rests: dict[str, set[str]] = {s.name: names_of(s.value) for s in problem.given}
    rests.update({p.name: names_of(p.place) for p in problem.points})
    rests.update({s.name: names_of((s.shape, s.speed, s.body)) for s in problem.surfaces})
    return rests


def _reached(roots: set[str], rests: Mapping[str, set[str]], ties: list[set[str]]) -> set[str]:
    """All names to which these lead. `ties`: the names of a relation, of which one leads to the others."""
    found: set[str] = set()
    left = set(roots)
    while left:
        found |= left
        further = set().union(*(rests.get(name, set()) for name in left), *(t for t in ties if t & found))
        left = further - found
    return found


def only_names(statement: Statement, known: set[str]) -> set[str] | None:
    """The names of a relation between numbers of the file alone; None: it says more."""
    if not isinstance(statement, Relation):
        return None
    nodes = [*walk(statement.left), *walk(statement.right)]
    names = {n.name for n in nodes if isinstance(n, Name)}
    return names if names <= known and not any(isinstance(n, Quantity) for n in nodes) else None


def names_of(value: Any) -> set[str]:
    """All words in a value: names, and what may be one."""
    if isinstance(value, str):
        return {value}
    if isinstance(value, tuple | list | frozenset):
        return set().union(*(names_of(v) for v in value))
    slots = [s for kind in type(value).__mro__ for s in getattr(kind, "__slots__", ()) if s not in UNNAMED]
    return set().union(*(names_of(getattr(value, s)) for s in slots))
