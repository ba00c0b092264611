"""The gaps that open where joints have parted: what a joint kept while it held, as a formula that grows from zero."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.plain import derivative
from planar_cli.records import record
from planar_cli.solve.regimes.general import General

DRAW = Decimal("0.61803")


@record
class Gap:
    """What opens where a joint has parted."""

    joint: str
    words: str
    expr: sp.Expr
    """A formula of the general position."""
    senses: tuple[tuple[int, int], ...]
    """By the index of the mode in which it held, 1 where the formula grows as it opens, else -1."""

    def opening(self, held: int | None) -> sp.Expr:
        """What is positive where it is open. `held`: the mode in which it held before (None: the first that may be)."""
        senses = dict(self.senses)
        return senses.get(-1 if held is None else held, self.senses[0][1]) * self.expr


def gaps_of(
    general: General, rates: Mapping[sp.Symbol, sp.Expr], closed: Callable[[sp.Expr], sp.Expr]
) -> Iterator[Gap]:
    """The gaps of one choice of modes, each with the sense in which it opens. `rates`: of the coordinates; `closed`: an
    expression of the instant as a formula in t, coordinates and free speeds.
    """
    base = general.instant.scene.valuations[0]
    drawn = {c.symbol: c.drawn for c in general.coordinates if c.drawn is not None}
    numbers = {general.time: Decimal(0), **{s: base(e) for s, e in drawn.items()}}
    ordinary = general.instant.scene.ledger.natural
    numbers |= {u: (DRAW + Decimal(i) / 7) * ordinary(u) for i, u in enumerate(general.free)}
    value = base.extended(numbers)
    for parted in general.parted:
        # What stands between bars keeps its sign until the gap has closed again.
        bars = {a: a.args[0] if value(a.args[0]) >= 0 else -a.args[0] for a in parted.residual.atoms(sp.Abs)}
        kept = parted.residual.xreplace(bars)
        rate = derivative(kept, general.time)
        rate += sum(derivative(kept, q) * r for q, r in rates.items())
        senses = []
        for index, opening in parted.openings:
            grows = value.known(rate * closed(opening))
            if grows:
                senses.append((index, 1 if grows > 0 else -1))
        if senses:
            yield Gap(parted.joint, parted.words, kept, tuple(senses))
