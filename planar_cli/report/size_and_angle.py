"""The size and the direction of a vector that an answer gives by its components, each with its line.

|a_B| = √(0.2282² + 0.1704²) = 0.2848 m/s²
direction of a_B = arctan(0.1704/0.2282) = 36.7°      below -x
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.ledger import display
from planar_cli.problem.expression import Quantity
from planar_cli.report.blocks import Block, Equation, Math, Name, Value, line
from planar_cli.report.enough_figures import figures_of
from planar_cli.report.numbers import significant
from planar_cli.report.ordering import NUMBER
from planar_cli.report.words import Phrases, told_unit
from planar_cli.solve.solution import Found

PLACES = ("IC", "r")
"""Of a place the answer gives its coordinates alone."""
OF_ANGLES = 3
"""Figures of a direction, as the answer has them."""


def size_and_angle(found: Found, phrases: Phrases, told: Sequence[Block] = ()) -> Iterator[Block]:
    """√(x² + y²) and arctan(y/x) with numbers; nothing of a vector in letters, of a place, or along an axis.
    `told`: the page before it, which may have the size.
    """
    what = found.find.found.what if found.find is not None else None
    place = isinstance(what, Quantity) and what.word in PLACES
    if found.kind != "vector" or found.values is None or found.word or found.curve is not None or place:
        return
    x, y = (display(v, found.unit, phrases.ledger.us) for v in found.values)
    if x.is_infinite() or y.is_infinite() or not x or not y:
        return
    name = Name(found.name)
    one, other = (sp.Symbol(f"{NUMBER}{axis}", positive=True) for axis in ("x", "y"))
    figures = figures_of((abs(x), abs(y)), _size, phrases.figures)
    texts = {one: significant(abs(x), figures), other: significant(abs(y), figures)}
    root = sp.sqrt(sp.Add(one**2, other**2, evaluate=False), evaluate=False)
    size = Value(_size((x, y)), told_unit(found.unit, found.energy), phrases.figures)
    own = line("|", name, "|")
    if not any(isinstance(b, Equation) and own in b.sides for b in told):
        yield Equation((own, Math(root, texts), size))
    steep = Value(Decimal(math.degrees(math.atan(abs(y) / abs(x)))), "deg", OF_ANGLES)
    where = f"{'above' if y > 0 else 'below'} {'+x' if x > 0 else '-x'}"
    quotient = line("arctan(", Math(other / one, texts), ")")
    yield Equation((line("direction of ", name), quotient, steep), None, note=line(where))


def _size(parts: Sequence[Decimal]) -> Decimal:
    x, y = parts
    return (x * x + y * y).sqrt()
