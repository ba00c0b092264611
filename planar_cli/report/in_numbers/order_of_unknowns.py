"""One order of the unknowns in all equations of a page that stand in numbers."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.solve.instant.algebra import Algebra


def places_of(algebra: Algebra, ledger: Ledger) -> dict[sp.Symbol, int]:
    """The places of the unknowns of a stage: as the problem names them, and an acceleration that stands for others
    behind the last body of which it holds one.
    """
    roles = {s: i for i, s in enumerate(ledger.roles)}
    last = {
        s: max((roles.get(x, 0) for x in e.free_symbols & algebra.unknowns), default=-1)
        for s, e in algebra.explicit.items()
    }
    order = sorted(last, key=lambda s: (last[s], roles.get(s, 0)))
    return {**roles, **{s: len(roles) + i for i, s in enumerate(order)}}


def in_order(
    terms: dict[sp.Expr, Decimal],
    unknowns: Collection[sp.Symbol],
    ledger: Ledger,
    places: Mapping[sp.Symbol, int] | None = None,
) -> dict[sp.Expr, Decimal]:
    """The terms with unknowns in the order of these, that of `places` or in which the problem names them, bodies first;
    so all equations of a page have one order. What is known stands before them where it begins positive, else behind
    them; all stays as it is where the sum would begin with a minus sign that it does not need.
    """
    known = ledger.values
    of = {m: [s for s in m.free_symbols if s in unknowns and s not in known] for m in terms}
    own = [m for m in terms if of[m]]
    if len({s for m in own for s in of[m]}) < 2:
        return terms
    places = {s: i for i, s in enumerate(ledger.roles)} if places is None else places
    last = len(places)
    own.sort(key=lambda m: sorted((places.get(s, last), s.name) for s in of[m]))
    rest = [m for m in terms if not of[m]]
    order = [*rest, *own] if rest and terms[rest[0]] > 0 else [*own, *rest]
    starts_badly = terms[order[0]] < 0 and any(c > 0 for c in terms.values())
    return terms if starts_badly else {m: terms[m] for m in order}
