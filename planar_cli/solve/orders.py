"""In which order bodies lie that balance along one line, where no drawing tells it.

The length of a spring between two coordinates, |x_2 - x_1|, is written for one side. Of an equilibrium all that is
known of places is what the file says: each order is tried, the one in which the forces balance is told, and of several
the file has to choose.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from itertools import product

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.setup import Earlier, Setup
from planar_cli.equation.system.system import Statements
from planar_cli.errors import Diagnostic, FileProblem, NoSolution, PlanarError, Undecided
from planar_cli.problem.language.expression import Equilibrium, Relation, Statement
from planar_cli.problem.language.parser import parse_statement
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.diagnosis.words import in_unit, listed
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

PLACES = "PL630"
"""The diagnostic of positions of equilibrium: none, or several."""
MOST = 3
"""Places whose side is open; each doubles the orders."""
SAME = Decimal("1e-9")
"""Answers of two orders that differ by less of their size are the same."""


def in_each_order(
    problem: Problem, earlier: Mapping[str, Earlier], solve: Callable[[Problem], PartSolution]
) -> PartSolution:
    """The solution in the order in which there is one. NoSolution: there is none, or several differ."""
    sides = _open_sides(problem, earlier)
    if not sides:
        return solve(problem)
    found: list[tuple[PartSolution, tuple[Relation, ...]]] = []
    failure: PlanarError | None = None
    for order in product(*sides):
        try:
            part = solve(_ordered(problem, order))
        except (NoSolution, Undecided, FileProblem) as error:
            weaker = failure is None or _only_ruled_out(failure)
            failure = error if weaker or isinstance(error, Undecided) else failure
            continue
        if not any(_alike(part, other) for other, _ in found):
            found.append((part, order))
    if len(found) > 1:
        raise _several(problem, found)
    if found:
        return found[0][0]
    assert failure is not None
    raise failure


def _only_ruled_out(failure: PlanarError) -> bool:
    """Is it only that bodies cannot lie so: no numbers fit, or nothing balances? What is said of another order is
    rather the reason.
    """
    found = failure.diagnostics if isinstance(failure, NoSolution) else []
    return isinstance(failure, FileProblem) or any(d.code == PLACES for d in found)


def _open_sides(problem: Problem, earlier: Mapping[str, Earlier]) -> list[tuple[Relation, Relation]]:
    """Both orders of each two places that hang together by a distance along a line."""
    if len(problem.coordinates) < 2 or not _balances(problem):
        return []
    now = problem.instant or ()
    try:
        scene = Setup(problem, Statements.of((), now), earlier, False).scene
        places = dict.fromkeys(p for m in problem.loads for p in _between(scene, m))
    except PlanarError:
        # What keeps the scene from being read is told where it is solved.
        return []
    names = {s.name for s in (*problem.given, *problem.coordinates)}
    told = [p for p in places if {s.name for s in p.free_symbols} <= names and not _definite(scene, p)]
    if not any(len(_coordinates(scene, p)) > 1 for p in told) or len(told) > MOST:
        return []
    return [(_relation(problem, p), _relation(problem, -p)) for p in told]


def _balances(problem: Problem) -> bool:
    """Is equilibrium all that is spoken of? A motion tells the order in which it begins."""
    stated = [s.relations for s in problem.states] or [problem.instant or ()]
    return all(any(isinstance(r, Equilibrium) for r in said) for said in stated)


def _between(scene: Scene, member: object) -> Iterator[sp.Expr]:
    """The place of one end of a spring seen from the other, where both lie on one line."""
    ends: tuple[str, ...] = getattr(member, "between", ())
    if len(ends) != 2 or not all(e in scene.points or e in scene.bodies for e in ends):
        return
    reach = scene.point(ends[1]) - scene.point(ends[0])
    root = sp.sqrt(factored(expanded(reach.dot(reach))))
    for size in sorted(root.atoms(sp.Abs), key=sp.default_sort_key):
        place = expanded(size.args[0])
        yield -place if place.could_extract_minus_sign() else place


def _coordinates(scene: Scene, place: sp.Expr) -> set[sp.Symbol]:
    return set(scene.ledger.coordinates).intersection(scene.ledger.sought, place.free_symbols)


def _definite(scene: Scene, place: sp.Expr) -> bool:
    """Is it of one sign for coordinates that are positive, as they are taken to be where nothing else is said?"""
    return not _coordinates(scene, place) or len({t.could_extract_minus_sign() for t in sp.Add.make_args(place)}) == 1


def _relation(problem: Problem, positive: sp.Expr) -> Relation:
    """That it is positive, as one would write it: `x_2 > x_1`."""
    terms = sp.Add.make_args(positive)
    greater = [_written(problem, t) for t in terms if not t.could_extract_minus_sign()]
    less = [_written(problem, -t) for t in terms if t.could_extract_minus_sign()]
    left, right = (" + ".join(side) or "0" for side in (greater, less))
    text = (
        f"{right} < {left}"
        if all(t.is_number for t in terms if not t.could_extract_minus_sign())
        else f"{left} > {right}"
    )
    found = parse_statement(text, _said(problem)[0].mark)
    assert isinstance(found, Relation)
    return found


def _written(problem: Problem, term: sp.Expr) -> str:
    number = f"{float(term):.15g} {'ft' if problem.us else 'm'}" if term.is_number else ""
    return number or str(term).replace("**", "^")


def _said(problem: Problem) -> tuple[Statement, ...]:
    """What the only instant, or the first state, says."""
    return problem.states[0].relations if problem.states else problem.instant or ()


def _ordered(problem: Problem, order: tuple[Relation, ...]) -> Problem:
    """The problem in one order: assumed where numbers are drawn, and stated where roots are chosen."""
    assumed = replace(problem, assume=(*problem.assume, *order))
    if problem.instant is not None:
        return replace(assumed, instant=(*problem.instant, *order))
    states = tuple(replace(s, relations=(*s.relations, *order)) for s in problem.states)
    return replace(assumed, states=states)


def _alike(one: PartSolution, other: PartSolution) -> bool:
    """Have they the same answers?"""
    return all(a.word == b.word and _close(a, b) for a, b in zip(one.found, other.found, strict=True))


def _close(one: Found, other: Found) -> bool:
    pairs = zip(one.values or (), other.values or (), strict=True)
    return all(abs(x - y) <= SAME * max(abs(x), abs(y)) for x, y in pairs)


def _several(problem: Problem, found: list[tuple[PartSolution, tuple[Relation, ...]]]) -> NoSolution:
    """With the relations that choose."""
    places = []
    for part, order in found:
        values = [
            f"{f.name} = {', '.join(in_unit(v, f.unit, problem.us) for v in f.values)}"
            for f in part.found
            if f.kind in ("number", "list") and f.values
        ]
        places.append(f"{', '.join(values) or 'one'} where {_told(order)}")
    hint = f"say which is meant: {_told(found[-1][1])}"
    text = f"several positions of equilibrium: {'; '.join(places)}"
    return NoSolution([Diagnostic(_said(problem)[0].mark, PLACES, text, hint)])


def _told(order: tuple[Relation, ...]) -> str:
    return listed(f"`{r.text}`" for r in order)
