"""Comparison of curves: equations in x and y say the same when their residuals differ by a constant factor."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.sample import generator
from planar_cli.errors import NOWHERE
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.language.parser import parse_statement

SAME = Decimal("1e-5")
"""Stated curves carry rounded coefficients."""
POINTS = 4
HODOGRAPH = ("vx", "vy")
"""Axes of a hodograph; an answer may also call them x and y."""
POLAR = ("r", "theta")


def same_curve(stated: str, solved: tuple[Any, ...], evaluator: Evaluator, valuations: Iterable[Valuation]) -> bool:
    """Is the stated equation the solved one, at random points of the plane and for every draw of the letters?"""
    relation = parse_statement(stated, NOWHERE)
    if len(solved) != 1 or not isinstance(relation, Relation):
        return False
    ours = solved[0].lhs - solved[0].rhs if isinstance(solved[0], sp.Eq) else solved[0]
    named = {s.name: s for s in ours.free_symbols if s.name in ("x", "y", *HODOGRAPH, *POLAR)}
    axes = {name: named.get(name, sp.Symbol(name, real=True)) for name in ("x", "y", *HODOGRAPH)}
    if set(named) & set(HODOGRAPH):
        axes |= {"x": axes["vx"], "y": axes["vy"]}
    if named and set(named) <= set(POLAR):
        axes |= {name: named.get(name, sp.Symbol(name, real=True)) for name in POLAR}
    axes |= {name: sp.Symbol(name, real=True) for name in POLAR if name not in {**evaluator.ledger.symbols, **axes}}
    ledger = replace(evaluator.ledger, symbols={**evaluator.ledger.symbols, **axes})
    plane = replace(evaluator, ledger=ledger)
    theirs = plane.value(relation.left) - plane.value(relation.right)
    return all(_constant_ratio(ours, theirs, draw, list(dict.fromkeys(axes.values()))) for draw in valuations)


def _constant_ratio(ours: sp.Expr, theirs: sp.Expr, draw: Valuation, axes: list[sp.Symbol]) -> bool:
    rng = generator(3)
    ratios: list[Decimal] = []
    for _ in range(POINTS):
        point = draw.extended({axis: Decimal(rng.randrange(1, 10**12)) / 10**12 for axis in axes})
        one, other = point.known(ours), point.known(theirs)
        if one is None or not other:
            return False
        ratios.append(one / other)
    return all(abs(r - ratios[0]) <= SAME * abs(ratios[0]) for r in ratios) and ratios[0] != 0
