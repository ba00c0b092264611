"""Several instants, each complete in itself: every find is put together from the states it names."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.setup import Earlier
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.jets import Jet, constant
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import (
    Binary,
    Found,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Quantity,
    Scaled,
    Side,
)
from planar_cli.problem.language.walk import children, names_of_states
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.records import record
from planar_cli.solve.solution import Found as Answered
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit

Solver = Callable[..., tuple[InstantSolution, list[Answered]]]


def stand_at_states(problem: Problem) -> bool:
    """Does every find consist of quantities at states of the file, joined by arithmetic, and does none of these speak
    of another? Places are drawn at the first
    state: of a later one nothing is known without coordinates but by the motion that leads there.
    """
    names = {s.name for s in (problem.states if problem.coordinates else problem.states[:1])}
    return all(_stands(find.found.what, names) for find in problem.find) and not any(
        names_of_states(r) for state in problem.states for r in state.relations
    )


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
    pieces = {find.name: tuple(_pieces(find)) for find in problem.find}
    solved: dict[Piece, Answered] = {}
    instants: list[InstantSolution] = []
    for state in problem.states:
        here = [piece for found in pieces.values() for piece in found if piece.state == state.name]
        if not here:
            continue
        asked = tuple(piece.find for piece in here)
        part = replace(problem, find=asked)
        solution, found = solver(part, always, state.relations, asked, units, earlier, False, state.name)
        instants.append(solution)
        solved |= dict(zip(here, found, strict=True))
    answers = [
        _joined(find, {p.side: solved[p] for p in pieces[find.name]}, units, instants[-1]) for find in problem.find
    ]
    made = {name: tuple((p.state, p.side, solved[p]) for p in found) for name, found in pieces.items()}
    return PartSolution(case, tuple(instants), tuple(answers), pieces=made if len(instants) > 1 else {})


@record
class Piece:
    """A part of a find that stands at a state."""

    state: str
    side: Side
    """As the find has it, without the state."""
    find: Find
    """What is asked in the state."""


def _pieces(find: Find) -> Iterator[Piece]:
    what = find.found.what
    for number, part in enumerate(_standing(what)):
        side = part.operand if isinstance(part, Grouped) else replace(part, at=None)
        alone = part is what
        found = Found(side, find.found.unit if alone else None, find.found.text, find.found.mark)
        yield Piece(str(part.at), side, Find(find.name if alone else f"{find.name}#{number}", found, find.mark))


def _standing(tree: Any) -> Iterator[Any]:
    if getattr(tree, "at", None) is not None:
        yield tree
        return
    for child in children(tree):
        yield from _standing(child)


def _joined(find: Find, solved: Mapping[Side, Answered], units: dict[str, str], last: InstantSolution) -> Answered:
    """The find from its pieces."""
    what, pieces = find.found.what, list(solved.values())
    assert isinstance(what, Side)
    if getattr(what, "at", None) is not None:
        return replace(pieces[0], find=find)
    vector = any(piece.kind == "vector" for piece in pieces)
    parts = tuple(combined(what, solved, i, last.instant.scene.ledger) for i in range(2 if vector else 1))
    setup = last.instant.setup
    written = find.found.unit or units.get(find.name)
    unit = parse_unit(written) if written else setup.unit_for(dimension_of(what, setup.lookup))
    open_ = any(p.free_symbols & set(setup.ledger.letters) for p in parts)
    values = None if open_ else tuple(last.value.settled(p, p) for p in parts)
    plain = tuple(simplified(p) for p in parts)
    return Answered(find.name, "vector" if vector else "number", unit, values, plain, "", find)


def combined(what: Side, solved: Mapping[Side, Answered], index: int, ledger: Ledger) -> sp.Expr:
    """The arithmetic of a find over solved pieces, by their values or else their formulas. `index`: the part of
    vectors, 0 for x.
    """

    def known(side: Side) -> Jet:
        found = solved[side]
        i = index if found.kind == "vector" else 0
        if found.values is not None:
            return constant(sp.Rational(str(found.values[i])))
        assert found.expressions is not None
        return constant(found.expressions[i])

    return Evaluator(ledger, {}, lambda q: known(replace(q, at=None)), lambda state: known).value(what)
