"""An angle to the vertical stays the one that the exercise speaks of: g cos 10° where its file has the direction 80°.

The text says 10 degrees, the file 80 deg for it, and the page goes by the text: OP = R at 90° - 10°.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import fields, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Answer, Block, Equation, Math, Relation, Text, Value
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.notation.formula import is_canonical
from planar_cli.report.notation.numbers import significant

NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")
TO = re.compile(
    r"(?<![\w.])(\d+(?:\.\d+)?)\s?(?:°|deg\b|degrees?\b)[^.,;]{0,20}\b(?:vertical|local horizontal|normal)\b"
)
"""10 degrees to the vertical, 8 deg above the local horizontal: from another line than the x axis of the file."""
LINES = ("line", "sides", "lead", "note", "left", "right", "rows", "aside")
RIGHT, FIGURES = 90, 6
FUNCTIONS = {sp.sin: sp.cos, sp.cos: sp.sin}


def with_stated_angles(blocks: Sequence[Block], problem: Problem) -> list[Block]:
    """The blocks of a page with such angles; as they are where the text speaks of no angle but those of the file."""
    text = " ".join((problem.text or "").split())
    to = {sp.Rational(x) for x in TO.findall(text)}
    if not to:
        return list(blocks)
    said = {sp.Rational(x) for x in NUMBER.findall(text)}
    held = {
        f for b in blocks for p in pieces_of(b) if isinstance(p, Math) for f in p.expr.atoms(sp.sin, sp.cos, sp.tan)
    }
    turned = {f: f.args[0] * 180 / sp.pi for f in held if f.args[0].is_number}
    angles = {d for d in turned.values() if d.is_Rational and 45 < d < RIGHT and d not in said and RIGHT - d in to}
    angles -= {d for f, d in turned.items() if isinstance(f, sp.tan)}
    angles = {d for d in angles if not any(_tells(b, d) for b in blocks)}
    if not angles:
        return list(blocks)
    put = {f: FUNCTIONS[f.func]((RIGHT - d) * sp.pi / 180) for f, d in turned.items() if d in angles}
    return [_written(b, put, angles) for b in blocks]


def _tells(block: Block, degrees: sp.Rational) -> bool:
    """Is the angle itself a result, or a number put in?"""
    if isinstance(block, Equation | Answer):
        values = (p for p in pieces_of(block) if isinstance(p, Value) and p.unit == "deg")
        if any(abs(v.number - _decimal(degrees)) < Decimal("1e-9") for v in values):
            return True
    shown = f"{significant(_decimal(degrees), FIGURES)}°"
    return any(shown in (p.values or {}).values() for p in pieces_of(block) if isinstance(p, Math))


def _written(value: Any, put: dict[sp.Expr, sp.Expr], angles: set[sp.Rational]) -> Any:
    """A block, a line, or a piece of one with these angles."""
    match value:
        case Math(expr):
            return replace(value, expr=_put(expr, put))
        case Value(number, "deg"):
            own = next((d for d in angles if _decimal(d) == number), None)
            return value if own is None else Text(f"90° - {significant(_decimal(RIGHT - own), FIGURES)}°")
        case Text(text):
            for d in angles:
                shown = re.escape(significant(_decimal(d), FIGURES))
                text = re.sub(rf"(?<![\d.-]){shown}°", f"90° - {significant(_decimal(RIGHT - d), FIGURES)}°", text)
            return replace(value, text=text)
        case tuple():
            return tuple(_written(part, put, angles) for part in value)
    if not isinstance(value, Block | Relation):
        return value
    inside = {f.name: getattr(value, f.name) for f in fields(value) if f.name in LINES}
    return replace(value, **{name: _written(part, put, angles) for name, part in inside.items()})


def _put(expr: Any, put: dict[sp.Expr, sp.Expr]) -> Any:
    """A formula with these functions, arranged as it is."""
    if expr in put:
        return put[expr]
    args = [_put(a, put) for a in expr.args]
    if args == list(expr.args):
        return expr
    arranged = isinstance(expr, sp.Add | sp.Mul | sp.Pow) and not is_canonical(expr)
    return expr.func(*args, evaluate=False) if arranged else expr.func(*args)


def _decimal(angle: sp.Rational) -> Decimal:
    return Decimal(int(angle.p)) / Decimal(int(angle.q))
