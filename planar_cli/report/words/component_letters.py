"""The components of a vector that is asked by the letters of its point, whatever the file calls it: v_Bx,2 and x_B,2
where it asks for v_B_at_2s and r_B_at_2s.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import Any

from planar_cli.problem.language.expression import Quantity
from planar_cli.records import record
from planar_cli.report.document.blocks import Answer, Block, Equation, Name, Text, line
from planar_cli.report.document.mentioned import mentioned
from planar_cli.report.notation.names import plain_name
from planar_cli.solve.solution import Found

PLACE, WORDS = "r", ("r", "v", "a")
"""What a point has: its place, whose components are its coordinates, its velocity and its acceleration."""
SIZES = ("|", "direction of ")
"""What stands before the name of a vector of which the size or the direction is told."""
_POINT = re.compile(r"[A-Z]\d*")


@record
class _Vector:
    """A vector that is asked: its name in the file, and the letters of itself and of its components."""

    name: str
    whole: str
    parts: tuple[str, str]


def with_component_letters(blocks: Sequence[Block], found: Iterable[Found]) -> list[Block]:
    """The blocks of a part. Letters that stand there for something else keep their place."""
    told = list(blocks)
    used = mentioned(told).letters
    for one in found:
        vector = _vector(one, used)
        if vector is not None and any(_has_part(b, vector) for b in told):
            told = [_lettered(b, vector) for b in told]
    return told


def _vector(found: Found, used: Collection[str]) -> _Vector | None:
    """None: it is no place, velocity or acceleration of one point, or its letters are taken."""
    what = found.find.found.what if found.find is not None else None
    if found.kind != "vector" or not isinstance(what, Quantity) or what.word not in WORDS or what.parts:
        return None
    if len(what.things) != 1 or not (what.at is None or isinstance(what.at, str)):
        return None
    (thing,) = what.things
    state = f"__{what.at}" if what.at else ""
    between = "" if _POINT.fullmatch(thing) else "_"
    if what.word == PLACE:
        parts = (f"x_{thing}{state}", f"y_{thing}{state}")
    else:
        parts = (f"{what.word}_{thing}{between}x{state}", f"{what.word}_{thing}{between}y{state}")
    return None if set(parts) & set(used) else _Vector(found.name, f"{what.word}_{thing}{state}", parts)


def _has_part(block: Block, vector: _Vector) -> bool:
    """Does a line give a component by the name of the file?"""
    if not isinstance(block, Equation):
        return False
    match _pieces(block.sides[0]):
        case [Name(name), Text(", x" | ", y")]:
            return name == vector.name
    return False


def _pieces(side: Any) -> list[Any]:
    return [p for p in side if p != Text("")] if isinstance(side, tuple) else [side]


def _lettered(block: Block, vector: _Vector) -> Block:
    """A block with the letters; an answer says which of them it is, where the file calls it otherwise:
    a_B is as good a name as a_B,2.
    """
    if isinstance(block, Answer) and block.name == vector.name and block.relation == "=":
        own, _, state = vector.whole.partition("__")
        same = plain_name(vector.name) in map(plain_name, (vector.whole, own, f"{own}_{state}"))
        return block if same else replace(block, line=line(Name(vector.whole), " = ", *block.line))
    if not isinstance(block, Equation):
        return block
    if _has_part(block, vector):
        own = vector.parts[0 if _pieces(block.sides[0])[1] == Text(", x") else 1]
        return replace(block, sides=(line(Name(own)), *block.sides[1:]))
    named = tuple(_named(side, vector) for side in block.sides)
    return replace(block, sides=named, note=_named(block.note, vector))


def _named(side: Any, vector: _Vector) -> Any:
    """A side in which the vector has its letter where its size or its direction is told; its formula in general has
    the letter of every instant.
    """
    if not isinstance(side, tuple) or not any(isinstance(p, Text) and p.text in SIZES for p in side):
        return side
    return tuple(Name(vector.whole) if isinstance(p, Name) and p.name == vector.name else p for p in side)
