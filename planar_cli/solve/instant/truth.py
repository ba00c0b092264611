"""Whether a relation that is asked holds; with letters, whatever numbers they have."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Sample, Valuation
from planar_cli.errors import NoValue, Undecided
from planar_cli.problem.scene.scene import Find


def holds(
    find: Find,
    operator: str,
    parts: Sequence[sp.Expr],
    closed: Sequence[sp.Expr],
    value: Valuation,
    draws: Iterable[Valuation],
) -> bool:
    """Does left - right, one part or two, compare with zero as the operator says? `closed`: the same as formulas, which
    are looked at for all `draws` where the letters have no numbers. Undecided: it holds only for some.
    """
    if not isinstance(value, Sample):
        return _compared(operator, parts, value)
    truths = {truth for draw in draws if (truth := _told(operator, closed, draw)) is not None}
    if len(truths) != 1:
        letters = ", ".join(sorted(s.name for s in set().union(*(c.free_symbols for c in closed)) & value.drawn))
        place = f"{find.mark.file}:{find.mark.line}:"
        raise Undecided(f"{place} whether `{find.name}` holds depends on {letters}, which have no numbers")
    return truths.pop()


def signed_alike(side: sp.Expr, drawn: Iterable[sp.Symbol]) -> sp.Expr:
    """The same without factors that are powers of positive letters without numbers, such as a mass: it compares with
    zero alike.
    """
    letters = {s for s in drawn if s.is_positive}
    own = [f for f in sp.Mul.make_args(sp.factor_terms(side)) if not _is_power(f, letters)]
    return sp.Mul(*own)


def _is_power(factor: sp.Expr, letters: set[sp.Symbol]) -> bool:
    base, _ = factor.as_base_exp()
    return base in letters


def _told(operator: str, closed: Sequence[sp.Expr], draw: Valuation) -> bool | None:
    """None: with these numbers there is no such motion."""
    try:
        return _compared(operator, closed, draw)
    except NoValue:
        return None


def _compared(operator: str, parts: Sequence[sp.Expr], value: Valuation) -> bool:
    number, *more = (Decimal(0) if value.is_zero(p) else value(p) for p in parts)
    same = not number and not any(more)
    return {"<": number < 0, ">": number > 0, "<=": number <= 0, ">=": number >= 0, "=": same}[operator]
