"""Coordinates that nothing tells, and on which nothing that is asked rests: where a cart begins on its rails.

The laws of motion hold in every place. So the problem is solved with the body in one place, and in others that have
nothing in common with it; where all answers are the same, they are told, and that these were the places tried.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from planar_cli.equation.system.setup import names_in
from planar_cli.errors import NoSolution, PlanarError
from planar_cli.problem.language.expression import Name, Number, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.ordinary import scales_of
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.static_alone import same_answer
from planar_cli.units import parse_unit

OPEN = frozenset(("PL606", "PL623"))
"""The diagnostics of what nothing tells."""
NATURAL = (Fraction(0), Fraction(1))
"""Places to be told on the page, in parts of an ordinary length, or of a radian: the first that can be."""
ELSEWHERE = (Fraction(6317, 10000), Fraction(-13729, 10000), Fraction(27183, 10000))
"""Others, on both sides; some of them the scene may not allow."""
ENOUGH = 2
"""In so many of them at least the answers must be the same."""


def wherever(solve: Callable[..., PartSolution], problem: Problem, *rest: Any) -> PartSolution:
    """One part; where it rests on no coordinate that the file leaves open, with those put anywhere. NoSolution: it does
    rest on one, or something else is open.
    """
    try:
        return solve(problem, *rest)
    except NoSolution as error:
        untold = _untold(problem) if any(d.code in OPEN for d in error.diagnostics) else []
        # Of one that is asked for, as the angle at which a pendulum hangs on a cart that is driven, the laws may tell.
        asked = {n.name for f in problem.find for n in walk(f.found.what) if isinstance(n, Name)}
        others = [c for c in untold if c.name not in asked]
        for group in [untold] if others == untold else [untold, others]:
            part = _anywhere(solve, problem, group, rest) if group else None
            if part is not None:
                return part
        raise


def _untold(problem: Problem) -> list[Symbol]:
    """The coordinates that no statement of the instant, or of the first state, speaks of, nor any law."""
    first = problem.instant if problem.instant is not None else problem.states[0].relations if problem.states else None
    if first is None:
        return []
    stated = [*first, *(law.statement for law in problem.motion), *problem.assume]
    named = {n for r in stated if isinstance(r, Relation) for side in (r.left, r.right) for n in names_in(side)}
    return [c for c in problem.coordinates if c.name not in named]


def _anywhere(
    solve: Callable[..., PartSolution], problem: Problem, untold: list[Symbol], rest: tuple[Any, ...]
) -> PartSolution | None:
    """The part with these coordinates put somewhere; None: an answer is another one elsewhere, or there is none."""
    told = next((p for share in NATURAL if (p := _solved(solve, problem, untold, share, rest)) is not None), None)
    # A formula in which such a coordinate stands is another number wherever it is put.
    placed = {symbol.name for symbol in untold}
    if told is None or any(s.name in placed for f in told.found for e in f.expressions or () for s in e.free_symbols):
        return None
    others = [p for share in ELSEWHERE if (p := _solved(solve, problem, untold, share, rest)) is not None]
    alike = all(same_answer(a, b) for p in others for a, b in zip(told.found, p.found, strict=True))
    return told if len(others) >= ENOUGH and alike else None


def _solved(
    solve: Callable[..., PartSolution], problem: Problem, untold: list[Symbol], share: Fraction, rest: tuple[Any, ...]
) -> PartSolution | None:
    """The part with every one of these coordinates at another such place; None: it cannot be there."""
    try:
        return solve(_put(problem, untold, share), *rest)
    except PlanarError:
        return None


def _put(problem: Problem, untold: list[Symbol], share: Fraction) -> Problem:
    """The problem with places for these coordinates where it begins."""
    scales = scales_of(problem)
    stated: list[Statement] = []
    for k, symbol in enumerate(untold):
        unit = parse_unit(symbol.unit or "1")
        size = Fraction(1) if unit.angle else Fraction(str(scales.exact(unit.dimension)))
        base = "rad" if unit.angle else ("ft" if problem.us else "m")
        number = Number(size * share * (k + 1), base, 1, symbol.mark)
        stated.append(Relation(Name(symbol.name, None, symbol.mark), "=", number, symbol.name, symbol.mark))
    placed = tuple(s.name for s in untold)
    if problem.instant is not None:
        return replace(problem, instant=(*problem.instant, *stated), placed=placed)
    first = problem.states[0]
    states = (replace(first, relations=(*first.relations, *stated)), *problem.states[1:])
    return replace(problem, states=states, placed=placed)
