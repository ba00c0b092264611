"""Which velocity unknowns fix all others: the free speeds of a general position."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.displacement import Displacement
from planar_cli.equation.values.exact import ZERO
from planar_cli.solve.instant.study import Velocities

NOTHING = Decimal("1e-30")
"""A smaller ratio of two speeds is none."""

Motions = Mapping[sp.Symbol, Mapping[sp.Symbol, Decimal]]
"""By a speed that is free, all that goes with it when it is 1."""


def independent_speeds(
    found: Velocities,
    drawn: Velocities,
    stated: Callable[[], Sequence[Velocities]],
    tree: tuple[sp.Symbol, ...],
    displacement: Displacement,
) -> tuple[sp.Symbol, ...]:
    """As many velocity unknowns as there are freedoms, which fix all others: rates of the file's own coordinates first,
    then those of the coordinates that we made; of these angular speeds first, as slides stand still at dead centres.

    `drawn`: the velocities as drawn. Those that fix the others there too come before those that do not: two loads that
    hang from one rope go up and down together, whichever way they may sway. `stated`: the velocities where states are.
    Those that fix the others there too come first of all: a ladder that lies on the floor still turns, and its foot
    stands still.
    """
    columns = list(dict.fromkeys(x for v in found.loose.values() for x in v))
    ours = {c.speed: c.unit for c in displacement.coordinates}
    columns.sort(key=lambda x: (x in tree, x not in ours, ours.get(x) != "rad"))
    choice = len(columns) > len(found.loose)
    # What keeps its ratio from the one position to the other keeps it everywhere.
    places = [found, drawn, *(stated() if choice and _differ(found.loose, drawn.loose) else ())]
    motions = [[dict(v) for v in place.loose.values()] for place in places]
    chosen: list[sp.Symbol] = []
    for looked_at in range(len(places), 0, -1) if choice else (1,):
        for column in columns:
            if all(_stands_out(column, vectors) is not None for vectors in motions[:looked_at]):
                motions = [_reduced(column, vectors) for vectors in motions[:looked_at]]
                chosen.append(column)
    return tuple(x for x in columns if x in chosen)


def _differ(one: Motions, other: Motions) -> bool:
    """Do the velocities go together otherwise in the one position than in the other?"""
    pairs = [(u, x) for motions in (one, other) for u, v in motions.items() for x in v]
    none: Mapping[sp.Symbol, Decimal] = {}
    return any(abs(one.get(u, none).get(x, ZERO) - other.get(u, none).get(x, ZERO)) > NOTHING for u, x in pairs)


def _stands_out(column: sp.Symbol, vectors: Sequence[Mapping[sp.Symbol, Decimal]]) -> int | None:
    """The motion in which this speed is largest; None: it is none in all of them."""
    sizes = [abs(v.get(column, ZERO)) for v in vectors]
    most = max(range(len(sizes)), key=sizes.__getitem__, default=None)
    return None if most is None or sizes[most] < NOTHING else most


def _reduced(column: sp.Symbol, vectors: list[dict[sp.Symbol, Decimal]]) -> list[dict[sp.Symbol, Decimal]]:
    """The motions in which this speed is zero."""
    at = _stands_out(column, vectors)
    assert at is not None
    pivot = vectors[at]
    found = []
    for v in (v for i, v in enumerate(vectors) if i != at):
        factor = v.get(column, ZERO) / pivot[column]
        found.append({x: v.get(x, ZERO) - factor * pivot.get(x, ZERO) for x in {**v, **pivot}})
    return found
