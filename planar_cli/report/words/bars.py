"""A vector is one thing and its size another: where a page tells v_B = ω × r_B/O, its size is |v_B| = R ω."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Block, Equation, Math, Text, Value, line
from planar_cli.report.document.said import letter_of
from planar_cli.solve.solution import Found

VECTORS = ("v", "a")


def with_bars(blocks: Sequence[Block], found: Iterable[Found]) -> list[Block]:
    """The blocks of a part, with bars round the letter of a vector before what is told of its size. `found`: what is
    asked.
    """
    vectors = {_name(b) for b in blocks if isinstance(b, Equation) and _is_vector(b)} - {""}
    asked = {f.name for f in found if _is_size(f)}
    return [_barred(b, vectors, asked) if isinstance(b, Equation) else b for b in blocks]


def _name(equation: Equation) -> str:
    """The one letter on the left of an equation; "" of a formula."""
    first = equation.sides[0]
    return letter_of(tuple(p for p in first if p != Text("")) if isinstance(first, tuple) else first)


def _is_size(found: Found) -> bool:
    """Is the size of a velocity or an acceleration asked for?"""
    what = found.find.found.what if found.find is not None else None
    return isinstance(what, Quantity) and what.word in VECTORS and [p.kind for p in what.parts] == ["mag"]


def _is_vector(equation: Equation) -> bool:
    """Is a side a product of vectors, or a pair of components?"""
    return any(_begins_a_vector(side) for side in equation.sides[1:])


def _begins_a_vector(side: Any) -> bool:
    texts = [p.text for p in side if isinstance(p, Text)] if isinstance(side, tuple) else []
    return any(" × " in t for t in texts) or bool(texts and texts[0].startswith("["))


def _barred(equation: Equation, vectors: Collection[str], asked: Collection[str]) -> Equation:
    """|v_B| = R ω, of a size; what is told along a direction keeps its letter."""
    name = _name(equation)
    last = equation.sides[-1]
    if name not in vectors or _is_vector(equation) or not isinstance(last, Value) or last.number < 0:
        return equation
    root = any(isinstance(s, Math) and s.expr.is_Pow and s.expr.exp == sp.Rational(1, 2) for s in equation.sides[1:])
    if not root and name not in asked:
        return equation
    return replace(equation, sides=(line("|", equation.sides[0], "|"), *equation.sides[1:]))
