"""One letter for one thing: where the file calls a number x_B, the place of B is x_B′; where it gives v_G, vectors have
arrows, so that the velocity of G is another letter.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import fields, replace
from typing import Any

from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Text, Value
from planar_cli.report.document.mentioned import pieces_of

PRIME, ARROW = "′", "vec"
STATE = "__"
VECTORS = ("v", "a", "r")
"""Stems of vectors."""
SQUARE = "²"
WITHOUT = " has no component"
"""What a sentence says of a vector."""


def with_letters_apart(blocks: Sequence[Block], problem: Problem) -> list[Block]:
    """The blocks of a page with other names for quantities and vectors that are called as letters of the file are."""
    letters = {
        s.name
        for part in (problem, *(case.problem for case in problem.cases))
        for s in (*part.given, *part.symbols, *part.unknowns)
    }
    taken = {n for n in letters if "_" in n}
    vectors = {_first(b) for b in blocks if _is_vectorial(b)} if taken else set()
    arrows = not vectors.isdisjoint(taken)
    told = vectors - taken
    return [_apart(b, taken, arrows, arrows and (_is_vectorial(b) or _first(b) in told)) for b in blocks]


def _is_vectorial(block: Block) -> bool:
    """Is an equation what a vector is: v_G = ω × r_G/C, v_O = [1, 0] m/s, v_G = v_O?"""
    if not isinstance(block, Equation):
        return False
    texts = [p.text for side in block.sides for p in pieces_of(side) if isinstance(p, Text)]
    pieces = [p for side in block.sides for p in pieces_of(side)]
    return any(" × " in t or t.startswith("[") for t in texts) or (
        len(pieces) > 1 and all(isinstance(p, Name) and _is_vector(p.name) for p in pieces)
    )


def _is_vector(name: str) -> bool:
    return name.split("_", maxsplit=1)[0] in VECTORS and "_" in name and SQUARE not in name


def _first(block: Block) -> str:
    """The name that is the whole first side."""
    match block.sides[0] if isinstance(block, Equation) else ():
        case Name(name) | (Name(name),):
            return name
    return ""


def _apart(value: Any, taken: Collection[str], arrows: bool, vectorial: bool) -> Any:
    """A block, a line or a piece of one. `arrows`: have vectors arrows? `vectorial`: do vectors stand here?"""
    match value:
        case Name(name, of_thing):
            letter, at, state = name.partition(STATE)
            if vectorial and _is_vector(name):
                return replace(value, name=f"{name}_{ARROW}")
            return replace(value, name=f"{letter}{PRIME}{at}{state}") if of_thing and letter in taken else value
        case tuple():
            ends = [isinstance(p, Text) and p.text.startswith(WITHOUT) for p in (*value[1:], None)]
            told = zip(value, ends, strict=False)
            return tuple(_apart(part, taken, arrows, vectorial or (arrows and end)) for part, end in told)
        case Math() | Value() | Text():
            return value
    if isinstance(value, str) or not hasattr(value, "__slots__"):
        return value
    own = {f.name: _apart(getattr(value, f.name), taken, arrows, vectorial) for f in fields(value) if f.init}
    return replace(value, **own)
