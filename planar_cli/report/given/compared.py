"""Whether a relation holds that is asked of states of a motion: the values of both its sides, compared."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Sample
from planar_cli.problem.language.expression import Relation
from planar_cli.report.document.blocks import Block, Equation, Line, Name, line
from planar_cli.report.notation.clean import common_dimension
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.units import Dimension

SIGNS = {"<": "<", ">": ">", "<=": "≤", ">=": "≥", "=": "="}
OTHERWISE = {"<": "≥", ">": "≤", "<=": ">", ">=": "<", "=": "≠"}


def compared_sides(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """For each relation that is asked: left = value > right = value, with the sign that is true."""
    for asked in found.requests:
        what = asked.find.found.what
        if not isinstance(what, Relation) or len(asked.parts) != 1 or phrases.symbolic:
            continue
        terms = sp.Add.make_args(asked.parts[0])
        left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
        right = left - asked.parts[0]
        dimension = common_dimension(phrases.ledger, *(s for s in (left, right) if not s.is_number))
        # What has no number, such as a mass that cancels, was drawn: a value with it is nobody's.
        told = phrases.value.without(phrases.value.drawn) if isinstance(phrases.value, Sample) else phrases.value
        if dimension is None or any(told.known(p) is None for p in (left, right)):
            continue
        holds = _holds(phrases, what.operator, left - right)
        sign = (SIGNS if holds else OTHERWISE)[what.operator]
        sides = (_with_value(phrases, left, dimension), line(f"{sign} "), _with_value(phrases, right, dimension))
        yield Equation((line(*sides[0], " ", *sides[1], *sides[2]),), None, line(Name(asked.find.name), ":"))


def _holds(phrases: Phrases, operator: str, difference: sp.Expr) -> bool:
    sign = phrases.certain(difference)
    return {"<": sign < 0, ">": sign > 0, "<=": sign <= 0, ">=": sign >= 0, "=": sign == 0}[operator]


def _with_value(phrases: Phrases, side: sp.Expr, dimension: Dimension) -> Line:
    """formula = value, of a number its value alone."""
    value: Any = phrases.of_dimension(phrases.certain(side), dimension)
    return line(value) if side.is_number else line(phrases.math(side), " = ", value)
