"""What a file says that can be checked before anything is solved: sizes beside places, relations of known numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.system.setup import Earlier, Setup, first_unit
from planar_cli.equation.system.system import Statements
from planar_cli.equation.values.jets import Jet, constant
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.checks.unused import coordinates_behind, names_of, only_names
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import Name, Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.diagnosis.lengths import demand_lengths
from planar_cli.solve.diagnosis.stretched import demand_rigid
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.solve.instant.inequalities import holds
from planar_cli.units import parse_unit


def demand_stated(problem: Problem, earlier: Mapping[str, Earlier]) -> None:
    """NoSolution: a size does not fit, or a relation of `assume`, `motion` or a state is false of numbers that are
    given.
    """
    _demand_assumed(problem, earlier)
    demand_lengths(problem, earlier)
    demand_rigid(problem, earlier)
    names = {s.name for s in (*problem.given, *problem.symbols)}
    stated = [law.statement for law in problem.motion] + [r for state in problem.states for r in state.relations]
    known = [r for r in stated if isinstance(r, Relation) and only_names(r, names) is not None]
    placed = [r for r in stated if isinstance(r, Relation) and _points_apart(r, problem, names)]
    if not known and not placed:
        return
    setup = Setup(problem, Statements.of((), ()), earlier, True)
    relations = known + [r for r in placed if setup.scene.owners.keys().isdisjoint(_points_apart(r, problem, names))]
    wrong = [found for r in relations if (found := _false(setup, r)) is not None]
    if wrong:
        raise NoSolution(wrong)


def _demand_assumed(problem: Problem, earlier: Mapping[str, Earlier]) -> None:
    """Without its assumptions the file has numbers with which each of them can be held beside what is given."""
    names = {s.name for s in problem.given}
    relations = [r for r in problem.assume if isinstance(r, Relation) and only_names(r, names) is not None]
    if relations:
        setup = Setup(replace(problem, assume=()), Statements.of((), ()), earlier, True)
        wrong = [found for r in relations if (found := _false(setup, r)) is not None]
        if wrong:
            raise NoSolution(wrong)


def _points_apart(relation: Relation, problem: Problem, names: set[str]) -> tuple[str, ...]:
    """The points of whose places a relation speaks, if it speaks of nothing else that may move, no body has them, and
    no coordinate carries them; none where that is not so.
    """
    leaves = [n for n in walk(relation) if isinstance(n, Quantity | Name)]
    quantities = [n for n in leaves if isinstance(n, Quantity)]
    points = tuple(dict.fromkeys(name for q in quantities for name in q.things))
    apart = {p.name for p in problem.points} - names_of(problem.bodies)
    stand = all(q.word in ("x", "y") and len(q.things) == 1 and q.at is None for q in quantities)
    told = all(isinstance(n, Quantity) or n.name in names for n in leaves)
    still = stand and told and apart.issuperset(points) and not coordinates_behind(set(points), problem)
    return points if still else ()


def _false(setup: Setup, relation: Relation) -> Diagnostic | None:
    def placed(q: Quantity) -> Jet:
        place = setup.scene.point(q.things[0])
        return constant(place.x if q.word == "x" else place.y)

    evaluator = replace(setup.evaluator, quantity=placed)
    left, right = (sp.sympify(evaluator.value(s)) for s in (relation.left, relation.right))
    value = setup.scene.valuations[0]
    both = left - right
    letters = setup.ledger.symbolic and not value.is_zero(both) and not both.is_number
    if letters or setup.scene.rests_on_sought(both) or holds(relation.operator, both, value):
        return None
    written = first_unit(relation.left) or first_unit(relation.right)
    kind = dimension_of(relation.left, setup.lookup)
    unit = setup.unit_for(kind) if written is None else parse_unit(written)
    told = " and ".join(in_unit(value(side), unit, setup.ledger.us) for side in (left, right))
    text = f"`{relation.text}` does not hold: the sides are {told}"
    return Diagnostic(relation.mark, "PL616", text, "both sides are known: correct one, or declare it under `unknowns`")
