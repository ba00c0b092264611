"""Which velocity unknowns fix all others: the free speeds of a general position."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.displacement import Displacement
from planar_cli.solve.instant.study import Velocities


def independent_speeds(
    found: Velocities, there: Velocities, tree: tuple[sp.Symbol, ...], displacement: Displacement
) -> tuple[sp.Symbol, ...]:
    """As many velocity unknowns as there are freedoms, which fix all others: rates of the file's own coordinates first,
    then those of the coordinates that we made; of these angular speeds first, as slides stand still at dead centres.

    `there`: the velocities as drawn. Those that fix the others there too come before those that do not: two loads that
    hang from one rope go up and down together, whichever way they may sway.
    """
    vectors = [dict(v) for v in found.loose.values()]
    drawn = [dict(v) for v in there.loose.values()]
    columns = list(dict.fromkeys(x for v in vectors for x in v))
    ours = {c.speed: c.unit for c in displacement.coordinates}
    columns.sort(key=lambda x: (x in tree, x not in ours, ours.get(x) != "rad"))
    chosen: list[sp.Symbol] = []
    for column in columns:
        if _stands_out(column, vectors) is not None and _stands_out(column, drawn) is not None:
            vectors, drawn = _reduced(column, vectors), _reduced(column, drawn)
            chosen.append(column)
    for column in columns:
        if _stands_out(column, vectors) is not None:
            vectors = _reduced(column, vectors)
            chosen.append(column)
    return tuple(x for x in columns if x in chosen)


def _stands_out(column: sp.Symbol, vectors: Sequence[Mapping[sp.Symbol, Decimal]]) -> int | None:
    """The motion in which this speed is largest; None: it is none in all of them."""
    sizes = [abs(v.get(column, Decimal(0))) for v in vectors]
    most = max(range(len(sizes)), key=sizes.__getitem__, default=None)
    return None if most is None or sizes[most] < Decimal("1e-30") else most


def _reduced(column: sp.Symbol, vectors: list[dict[sp.Symbol, Decimal]]) -> list[dict[sp.Symbol, Decimal]]:
    """The motions in which this speed is zero."""
    at = _stands_out(column, vectors)
    assert at is not None
    pivot = vectors[at]
    found = []
    for v in (v for i, v in enumerate(vectors) if i != at):
        factor = v.get(column, Decimal(0)) / pivot[column]
        found.append({x: v.get(x, Decimal(0)) - factor * pivot.get(x, Decimal(0)) for x in {**v, **pivot}})
    return found
