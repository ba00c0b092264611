"""Relations of `motion` about places: they hold in every position, `theta(crank) = w*t`, and tell places over time."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.scene.curves import direction_of
from planar_cli.equation.system.conditions import POSITION, order, vector_or_jet
from planar_cli.equation.system.setup import Setup
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import Part, Quantity, Relation
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.regimes.constraints import Constraint


def held_places(setup: Setup, quantities: Quantities, varying: Collection[sp.Symbol]) -> tuple[Constraint, ...]:
    """Every relation about places that holds all the time, as a residual in coordinates and t.

    `varying`: coordinates and where they start. NoSolution: a relation has none of them, and does not hold.
    """
    names = {s.name for s in setup.ledger.coordinates}
    relations = [
        r
        for r, always in setup.statements.relations
        if always and r not in setup.settled and order(r, names) == POSITION
    ]
    found: list[Constraint] = []
    for relation, text, residual in place_residuals(relations, quantities):
        expr = simplified(residual)
        if expr != 0 and expr.free_symbols:
            if expr.free_symbols.isdisjoint(varying):
                raise _cannot_vary(relation)
            found.append(Constraint(expr, text, "", "motion"))
    return tuple(found)


def place_residuals(relations: Sequence[Relation], quantities: Quantities) -> Iterator[tuple[Relation, str, sp.Expr]]:
    """What vanishes by relations about places, each with its relation and what the file says."""
    sizes = {key: r for r in relations if (key := _part_of(r, "mag")) is not None}
    for relation in relations:
        turned = _part_of(relation, "angle")
        if turned in sizes and _part_of(relation, "mag") is None:
            continue
        paired = next((r for r in relations if _part_of(relation, "mag") == _part_of(r, "angle") is not None), None)
        text = relation.text if paired is None else f"{relation.text}, {paired.text}"
        for residual in _residuals(relation, paired, quantities):
            yield relation, text, residual


def _cannot_vary(relation: Relation) -> NoSolution:
    """A relation between what the joints keep as it is drawn."""
    text = f"`{relation.text}` can not hold all the time: what it names can not move so"
    return NoSolution([Diagnostic(relation.mark, "PL607", text, "leave it out, or name what the joints let move")])


def _part_of(relation: Relation, kind: str) -> tuple[str, tuple[str, ...]] | None:
    """Of which vector the left side is this part."""
    q = relation.left
    if isinstance(q, Quantity) and q.at is None and [p.kind for p in q.parts] == [kind]:
        return q.word, q.things
    return None


def _whole(relation: Relation, quantities: Quantities) -> Vec:
    """The vector of which the left side is a part, as values."""
    assert isinstance(relation.left, Quantity)
    found = quantities.any(replace(relation.left, parts=tuple[Part, ...]()))
    assert isinstance(found, Vec)
    return Vec(found.x.value, found.y.value)


def _residuals(relation: Relation, paired: Relation | None, quantities: Quantities) -> Iterator[sp.Expr]:
    """Size and direction together give both components; a direction alone leaves the part across it zero."""
    right = vector_or_jet(relation.right, quantities, quantities.evaluator)
    if paired is not None:
        angle = quantities.evaluator.value(paired.right)
        vector = _whole(relation, quantities)
        yield vector.x - right.value * sp.cos(angle)
        yield vector.y - right.value * sp.sin(angle)
    elif _part_of(relation, "angle") is not None:
        vector = _whole(relation, quantities)
        angle = direction_of(vector, quantities.scene.sign)
        # Where the place is written with its direction, that is meant, and not the opposite one.
        across = vector.y * sp.cos(right.value) - vector.x * sp.sin(right.value)
        yield across if angle.has(sp.atan2) else angle - right.value
    else:
        left = vector_or_jet(relation.left, quantities, quantities.evaluator)
        difference = left - right
        for part in (difference.x, difference.y) if isinstance(difference, Vec) else (difference,):
            yield part.value
