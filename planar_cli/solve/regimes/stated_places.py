"""The positions in which states are, as far as the file tells them by places: theta(AB) = 180 deg."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.system.conditions import POSITION, order
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NotReached, NoValue, PlanarError
from planar_cli.problem.language.expression import Name, Relation
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.scene.scene import State
from planar_cli.solve.regimes.constraints import Constraint, project
from planar_cli.solve.regimes.places import place_residuals


def stated_places(
    states: Sequence[State],
    quantities: Quantities,
    coordinates: Sequence[Coordinate],
    constraints: tuple[Constraint, ...],
    drawn: Valuation,
) -> Iterator[Valuation]:
    """The positions of all states that places tell, near the one that is drawn; what they leave open is as drawn.

    `drawn`: numbers of the position as drawn. A state that is told by later states, by the time or by velocities has
    no position yet, nor has one that Newton's method does not find.
    """
    symbols = {c.symbol for c in coordinates}
    names = {s.name for s in quantities.scene.ledger.coordinates}
    for state in states:
        relations = [r for r in state.relations if isinstance(r, Relation) and _tells_place(r, names)]
        stated = tuple(c for c in _read(relations, quantities) if c.residual.free_symbols & symbols)
        every = (*constraints, *stated)
        inside = {s for c in every for s in c.residual.free_symbols}
        if not stated or any(drawn.known(c.residual) is None for c in every):
            continue
        unknowns = tuple(c.symbol for c in coordinates if c.symbol in inside)
        found = _projected(every, unknowns, drawn)
        if found is not None:
            yield drawn.extended(found)


def _tells_place(relation: Relation, coordinates: set[str]) -> bool:
    over_time = any(isinstance(n, Name) and n.name in ("t", "infinity") for n in walk(relation))
    alone = not over_time and not names_of_states(relation)
    return alone and relation.operator == "=" and order(relation, coordinates) == POSITION


def _read(relations: Sequence[Relation], quantities: Quantities) -> tuple[Constraint, ...]:
    """The relations as residuals; none where they can not be read in a general position."""
    try:
        found = list(place_residuals(relations, quantities))
    except (PlanarError, NoValue):
        return ()
    return tuple(Constraint(sp.sympify(residual), text, "", "given") for _, text, residual in found)


def _projected(
    constraints: tuple[Constraint, ...], unknowns: tuple[sp.Symbol, ...], drawn: Valuation
) -> dict[sp.Symbol, Decimal] | None:
    try:
        return project(constraints, unknowns, drawn)
    except (NotReached, NoValue):
        return None
