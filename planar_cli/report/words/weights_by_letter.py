"""A weight that the file gives is its letter in diagrams and equations, W and not m g with m = W/g; where nothing but
weight is asked of the body its mass is not worked out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import sympy as sp

from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Relation, Text
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.notation.formula import is_canonical
from planar_cli.report.notation.ordering import NUMBER

MASS = "mass of "
LINES = ("line", "sides", "lead", "note", "left", "right", "rows", "aside")


@record
class _Weight:
    """A weight by its letter, and the mass and g that make it; its number as the page has it, "" in letters."""

    mass: sp.Symbol
    gravity: sp.Symbol
    weight: sp.Symbol
    number: str


def with_weights_by_letter(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part with such weights; a mass that stands nowhere else loses its line."""
    defined = [(b, w) for b in blocks if (w := _defined(b)) is not None]
    if not defined:
        return list(blocks)
    weights = {w.mass: w for _, w in defined}
    lines = [b for b, _ in defined]
    found = list(_once((b, b if b in lines else _written(b, weights)) for b in blocks))
    used = {s.name for b in found if b not in lines for s in _letters(b)}
    idle = [b for b, w in defined if w.mass.name not in used]
    return [b for b in found if b not in idle]


def _once(blocks: Iterable[tuple[Block, Block]]) -> Iterator[Block]:
    """Blocks as they are written now, without an equation that has become one before it: S = m g, and S = W."""
    told: list[tuple[Equation, Equation]] = []
    for before, now in blocks:
        if isinstance(before, Equation) and isinstance(now, Equation):
            bare = not (now.lead or now.note or now.number)
            if bare and any(now.sides == own.sides and before.sides != first.sides for first, own in told):
                continue
            told.append((before, now))
        yield now


def _defined(block: Block) -> _Weight | None:
    """What a line `mass of A: m_A = W_A/g = 10/9.81 = 1.019 kg` defines; None: it is another line."""
    if not isinstance(block, Equation) or len(block.sides) < 2 or not _is_of_mass(block):
        return None
    own, formula, *rest = block.sides
    if not isinstance(own, Math) or not isinstance(formula, Math) or not own.expr.is_Symbol:
        return None
    above, below = sp.fraction(formula.expr)
    # A weight that the file writes as a number has no letter.
    if not above.is_Symbol or above.name.startswith(NUMBER) or not below.is_Symbol or below.name != "g":
        return None
    number = next((s.values[above] for s in rest if isinstance(s, Math) and s.values and above in s.values), "")
    return _Weight(own.expr, below, above, number)


def _is_of_mass(equation: Equation) -> bool:
    first = equation.lead[0] if equation.lead else None
    return isinstance(first, Text | Name) and (first.text if isinstance(first, Text) else first.name).startswith(MASS)


def _letters(block: Block) -> Iterator[sp.Symbol]:
    for piece in pieces_of(block):
        if isinstance(piece, Math):
            yield from piece.expr.free_symbols
        elif isinstance(piece, Name):
            yield sp.Symbol(piece.name)


def _written(value: Any, weights: Mapping[sp.Symbol, _Weight]) -> Any:
    """A block, a line, or a piece of one with these weights."""
    match value:
        case Math():
            return _math(value, weights)
        case tuple():
            return tuple(_written(part, weights) for part in value)
    if not isinstance(value, Block | Relation):
        return value
    inside = {f.name: getattr(value, f.name) for f in fields(value) if f.name in LINES}
    return replace(value, **{name: _written(part, weights) for name, part in inside.items()})


def _math(math: Math, weights: Mapping[sp.Symbol, _Weight]) -> Math:
    own = {w.weight: w for m, w in weights.items() if m in math.expr.free_symbols and (not math.values or w.number)}
    if not own:
        return math
    expr = _put(math.expr, {w.mass: w for w in own.values()})
    if expr == math.expr or not math.values:
        return replace(math, expr=expr)
    texts = {**math.values, **{s: w.number for s, w in own.items()}}
    return replace(math, expr=expr, values={s: text for s, text in texts.items() if s in expr.free_symbols})


def _put(expr: Any, weights: Mapping[sp.Symbol, _Weight]) -> Any:
    """A formula with W for each product m g, arranged as it is."""
    if not expr.args or not expr.free_symbols & weights.keys():
        return expr
    if expr.is_Mul:
        for mass, w in weights.items():
            if mass in expr.args and w.gravity in expr.args:
                rest = [w.weight if a == mass else a for a in expr.args if a != w.gravity]
                return _made(expr, rest, weights)
        if (both := next((a for a in expr.args if a.is_Add and weights.keys() >= set(a.args)), None)) is not None:
            gravity = weights[both.args[0]].gravity
            if gravity in expr.args:
                whole = sp.Add(*(weights[m].weight for m in both.args))
                return _made(expr, [whole if a == both else a for a in expr.args if a != gravity], weights)
    return _made(expr, list(expr.args), weights)


def _made(expr: Any, args: list[Any], weights: Mapping[sp.Symbol, _Weight]) -> Any:
    args = [_put(a, weights) for a in args]
    if args == list(expr.args):
        return expr
    if len(args) == 1 and expr.is_Mul:
        return args[0]
    arranged = isinstance(expr, sp.Add | sp.Mul | sp.Pow) and not is_canonical(expr)
    return expr.func(*args, evaluate=False) if arranged else expr.func(*args)
