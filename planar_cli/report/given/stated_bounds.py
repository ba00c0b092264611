"""Inequalities of a state about its time, `t > 3 s`, where they are what rules out the other roots."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.problem.language.expression import Name, Relation
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.given.compared import SIGNS
from planar_cli.report.words.sides import AS_WRITTEN, number_of, said
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.units import parse_unit

TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}


def stated_bound(found: MotionTrace, time: sp.Symbol, state: str, others: list[Decimal]) -> Line:
    """t > 3 s, of the inequalities of a state those that rule out other times [s]; nothing where some are left."""
    left, told = list(others), []
    for sign, bound, words in _bounds(found, state):
        kept = [v for v in left if (v > bound if sign.startswith(">") else v < bound) or (v == bound and "=" in sign)]
        if len(kept) < len(left):
            told.append(line(Math(time), f" {SIGNS[sign]} ", *words))
            left = kept
    if left or not told:
        return ()
    return line(*told[0], *(part for more in told[1:] for part in (" and ", *more)))


def _bounds(found: MotionTrace, state: str) -> Iterator[tuple[str, Decimal, Line]]:
    """The sign, the number [s] and the words of each bound of the time of a state that is one number."""
    for relation in (r for s in found.problem.states if s.name == state for r in s.relations):
        if not isinstance(relation, Relation) or relation.operator == "=":
            continue
        for own, bound, sign in (
            (relation.left, relation.right, relation.operator),
            (relation.right, relation.left, TURNED[relation.operator]),
        ):
            number, words = number_of(bound), said(bound, AS_WRITTEN)
            if isinstance(own, Name) and own.name == "t" and own.at is None and number is not None and words:
                factor = parse_unit(number[1]).factor
                yield sign, number[0] * factor.numerator / factor.denominator, words
