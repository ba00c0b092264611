"""Of which names and words a page speaks."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import pairwise

from planar_cli.records import record
from planar_cli.report.document import blocks
from planar_cli.report.document.blocks import Block, Check, Equation, Forces, Inline, Line, Math, Paragraph, Text, Value
from planar_cli.report.document.blocks import Relation as Related
from planar_cli.report.notation.ordering import HELD

FOR_EVERY_BODY = "Newton's law for every body"
"""So begins what a page says of a motion that is integrated in numbers: it rests on all masses."""

MOMENTA = ("in N·s", "in lbf·s", "in kg·m²/s", "in lbf·ft·s")
"""What stands behind a balance of momenta in numbers, in which masses are."""


@record
class Mentioned:
    """What a page speaks of. `words`: all its names and their pieces; `kinetic`: does it tell energies, momenta in
    numbers, or forces that accelerate something? `counted`: the names for which it puts numbers into formulas.
    `letters`: names in formulas, which units are not. `energies`: it tells energies.
    """

    words: frozenset[str]
    kinetic: bool
    counted: frozenset[str] = frozenset()
    letters: frozenset[str] = frozenset()
    energies: bool = False
    numeric: bool = False
    """Are numbers put into formulas?"""
    built: frozenset[str] = frozenset()
    """Points of which the page says how they are constructed."""
    valued: frozenset[str] = frozenset()
    """The names in formulas that a value follows: a = -g = -32.19 ft/s²."""
    summed: bool = False
    """Does a sum of forces, moments or energies stand in numbers, among which its weights are?"""
    integrated: bool = False
    """Is Newton's law integrated in numbers, for every body with its weight?"""


def mentioned(page: Iterable[Block]) -> Mentioned:
    """All pieces of names and words on a page."""
    found: set[str] = set()
    letters: set[str] = set()
    built: set[str] = set()
    counted: set[str] = set()
    valued: set[str] = set()
    kinetic = energies = summed = integrated = False
    for block in page:
        built.add(_built(block))
        valued |= _valued(block)
        summed |= isinstance(block, Equation) and _is_of_forces(block.note)
        kinetic |= isinstance(block, Forces) and block.right != (Text("0"),)
        kinetic |= isinstance(block, Equation) and _told_in(block.note) in MOMENTA
        for piece in pieces_of(block):
            match piece:
                case Text(text):
                    integrated |= text.startswith(FOR_EVERY_BODY)
                    found |= set(re.findall(r"\w+", text))
                case blocks.Name(name):
                    letters |= _names_in(name)
                    energies |= name.startswith(("T_", "E_k_"))
                case Math(expr):
                    letters |= {p for s in expr.free_symbols for p in _names_in(s.name)}
                    counted |= {s.name for s in piece.values or () if s.name != HELD}
    words = frozenset(found | letters)
    return Mentioned(
        words=words,
        kinetic=kinetic or energies or integrated,
        counted=frozenset(counted),
        letters=frozenset(letters),
        energies=energies or integrated,
        numeric=bool(counted),
        built=frozenset(built),
        summed=summed,
        valued=frozenset(valued),
        integrated=integrated,
    )


def _valued(block: Block) -> set[str]:
    """The names in a formula of an equation, or of a check, that a value follows."""
    if isinstance(block, Check):
        told = [piece for piece in block.line if piece != Text(" = ")]
        after = [one for one, other in pairwise(told) if isinstance(other, Value)]
        return {s.name for piece in after if isinstance(piece, Math) for s in piece.expr.free_symbols}
    if not isinstance(block, Equation) or block.relation != "=":
        return set()
    before = [one for one, other in pairwise(block.sides[1:]) if isinstance(other, Value)]
    return {s.name for side in before if isinstance(side, Math) for s in side.expr.free_symbols}


def _names_in(name: str) -> set[str]:
    """A name, that without its state, and its subscripts; g_0 is no g."""
    own = name.partition("__")[0]
    return {name, own, *name.split("_")[1:]}


def _built(block: Block) -> str:
    """The point of which an equation says where it lies: `C is 0.5 m from B and 0.4 m from D: C = …`; or a sentence, as
    that of a wheel which rolls from x = 0.
    """
    if isinstance(block, Paragraph):
        advances = re.search(
            r" so that (\w+) has advanced from x = 0 by its", "".join(p.text for p in block.line if isinstance(p, Text))
        )
        return advances[1] if advances else ""
    lead = block.lead[0] if isinstance(block, Equation) and block.lead else None
    found = re.match(r"(\w+) is ", lead.text) if isinstance(lead, Text) else None
    return found[1] if found else ""


def _is_of_forces(note: Line) -> bool:
    """Is an equation in numbers one of forces, moments or energies?"""
    return _told_in(note).startswith(("in N", "in lbf", "in J"))


def _told_in(note: Line) -> str:
    return "".join(p.text for p in note if isinstance(p, Text))


def pieces_of(value: object) -> Iterator[Inline]:
    """All pieces of the lines of a block."""
    match value:
        case Text() | blocks.Name() | Math() | Value():
            yield value
        case Related():
            yield from (value.left, value.right)
        case tuple():
            for part in value:
                yield from pieces_of(part)
        case _:
            for slot in getattr(value, "__slots__", ()):
                yield from pieces_of(getattr(value, slot))


def names_in(value: object) -> Iterator[str]:
    """The names of a block or a part of it, as its formulas have them; one that stands twice, twice."""
    for piece in pieces_of(value):
        if isinstance(piece, blocks.Name):
            yield piece.name
        elif isinstance(piece, Math):
            yield from (s.name for s in piece.expr.free_symbols)
