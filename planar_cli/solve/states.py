"""Several instants, each complete in itself: every find is put together from the states it names."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.plain import simplified
from planar_cli.equation.setup import Earlier
from planar_cli.problem.expression import (
    Binary,
    Found,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Quantity,
    Relation,
    Scaled,
    Side,
)
from planar_cli.problem.scene import Find, Problem
from planar_cli.solve.solution import Found as Answered
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import Unit

Solver = Callable[..., tuple[InstantSolution, list[Answered]]]


def stand_at_states(problem: Problem) -> bool:
    """Does every find consist of quantities at states of the file, joined by arithmetic?"""
    names = {s.name for s in problem.states}
    return all(_stands(find.found.what, names) for find in problem.find)


def _stands(what: Any, states: set[str]) -> bool:
    match what:
        case Number():
            return True
        case Name() if what.at is None:
            return what.name == "pi"
        case Quantity() | Name() | Grouped():
            return what.at in states
        case Function():
            return what.at in states if what.at is not None else _stands(what.argument, states)
        case Negate() | Scaled():
            return _stands(what.operand, states)
        case Binary():
            return _stands(what.left, states) and _stands(what.right, states)
    return False


def solve_states(
    problem: Problem,
    case: str,
    always: tuple[Any, ...],
    units: dict[str, str],
    earlier: dict[str, Earlier],
    solver: Solver,
) -> PartSolution:
    """Solve each state that is asked about for the pieces of all finds in it, then put the finds together."""
    pieces: dict[str, list[Find]] = {s.name: [] for s in problem.states}
    rebuilt: dict[str, tuple[Find, Side | Relation]] = {}
    for find in problem.find:
        rebuilt[find.name] = (find, _split(find, find.found.what, pieces, problem))
    solved: dict[str, Answered] = {}
    instants: list[InstantSolution] = []
    for state in problem.states:
        if not pieces[state.name]:
            continue
        part = replace(problem, find=tuple(pieces[state.name]))
        solution, found = solver(
            part, always, state.relations, tuple(pieces[state.name]), units, earlier, False, state.name
        )
        instants.append(solution)
        solved.update({f.name: f for f in found})
    answers = [_joined(find, what, solved, units, instants) for find, what in rebuilt.values()]
    return PartSolution(case, tuple(instants), tuple(answers))


def _split(find: Find, what: Any, pieces: dict[str, list[Find]], problem: Problem) -> Any:
    """Replace each part that stands at a state by the name of a piece asked there."""

    def piece(side: Side, state: str) -> Name:
        name = f"{find.name}#{len(pieces[state])}"
        pieces[state].append(Find(name, Found(side, find.found.unit, find.found.text, find.found.mark), find.mark))
        return Name(name, None, find.mark)

    match what:
        case Quantity():
            return piece(replace(what, at=None), str(what.at))
        case Name() if what.at is not None:
            return piece(replace(what, at=None), what.at)
        case Grouped():
            return piece(what.operand, what.at)
        case Function() if what.at is not None:
            return piece(replace(what, at=None), what.at)
        case Negate() | Scaled():
            return replace(what, operand=_split(find, what.operand, pieces, problem))
        case Function():
            return replace(what, argument=_split(find, what.argument, pieces, problem))
        case Binary() | Relation():
            return replace(
                what, left=_split(find, what.left, pieces, problem), right=_split(find, what.right, pieces, problem)
            )
    return what


def _joined(
    find: Find, what: Any, solved: dict[str, Answered], units: dict[str, str], instants: list[InstantSolution]
) -> Answered:
    """The find from its pieces."""
    if isinstance(what, Name) and what.name in solved:
        return replace(solved[what.name], name=find.name, find=find)
    vectors = any(solved[n].kind == "vector" for n in _names(what) if n in solved)
    parts = [_combine(what, solved, i) for i in range(2 if vectors else 1)]
    sample = next(solved[n] for n in _names(what) if n in solved)
    unit: Unit = sample.unit
    numbers = instants[-1].value
    values = (
        tuple(numbers.settled(p, p) for p in parts)
        if not any(p.free_symbols & set(instants[-1].instant.scene.ledger.letters) for p in parts)
        else None
    )
    return Answered(
        find.name, "vector" if vectors else "number", unit, values, tuple(simplified(p) for p in parts), "", find
    )


def _names(what: Any) -> list[str]:
    match what:
        case Name():
            return [what.name]
        case Negate() | Scaled():
            return _names(what.operand)
        case Function():
            return _names(what.argument)
        case Binary() | Relation():
            return _names(what.left) + _names(what.right)
    return []


def _combine(what: Any, solved: dict[str, Answered], index: int) -> sp.Expr:
    """The arithmetic of a find over solved pieces."""
    from fractions import Fraction

    from planar_cli.equation.evaluate import FUNCTIONS
    from planar_cli.equation.ledger import exact
    from planar_cli.units import parse_unit

    match what:
        case Name() if what.name in solved:
            found = solved[what.name]
            at = index if found.kind == "vector" else 0
            if found.values is not None:
                return sp.Rational(str(found.values[at]))
            assert found.expressions is not None
            return found.expressions[at]
        case Number():
            return what.sense * exact(what.value, parse_unit(what.unit) if what.unit else None)
        case Name() if what.name == "pi":
            return sp.pi
        case Negate():
            return -_combine(what.operand, solved, index)
        case Scaled():
            return _combine(what.operand, solved, index) * what.sense * exact(Fraction(1), parse_unit(what.unit))
        case Function():
            return FUNCTIONS[what.name](_combine(what.argument, solved, index))
        case Binary():
            a, b = _combine(what.left, solved, index), _combine(what.right, solved, index)
            return {
                "+": a + b,
                "-": a - b,
                "*": a * b,
                "/": a / b if b != 0 else sp.nan,
                "^": a**b if what.operator == "^" else a,
            }[what.operator]
    raise TypeError(f"{what} is no arithmetic over quantities at states")
