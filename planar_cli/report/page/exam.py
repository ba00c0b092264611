"""A page as short as the key of an exam: the principle, the equations on which the answers rest, and the results.

What stays is what a marker compares: equations with the numbers that they have on the page for students, the energies
and the work of a balance, and each line that gives an answer or leads to it, with formula, numbers and value; beside
them what was assumed, and the test of it, and of two roots which one it is. Other words, diagrams and what no answer
rests on go. Where an answer has no line of its own all numbered equations stay; of a motion that is followed in
numbers, how and with which table.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from planar_cli.problem.scene.scene import Particle, Problem
from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Bullet,
    Check,
    Equation,
    Heading,
    Line,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Value,
    line,
)
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.equations.left_out import ROOT
from planar_cli.report.equations.results import told_by_others
from planar_cli.report.page.rests_on import rests_on

KEPT = ("CASE", "STATE")
"""Headings that say of what the equations are."""
NOTES = ("Assume", "Fails", "Instead", "Disagrees")
GIVEN = "given:"
ROW = line("row")
"""Begins the table of a system of equations."""
TESTS = ("≤", "<", ">", "≥")
"""A check with one of these tests an assumption."""


def key_blocks(blocks: Sequence[Block], before: Collection[Block], problem: Problem | None = None) -> list[Block]:
    """The key of one part of a page. `before`: what the keys of earlier parts tell; `problem`: says which point each
    particle is.
    """
    shapes = {b.name: b.shape for b in problem.bodies} if problem is not None else {}
    places = {n: s.place for n, s in shapes.items() if isinstance(s, Particle) and isinstance(s.place, str)}
    kept = rests_on(blocks, places)
    if kept is None:
        kept = _in_place(blocks)
    kept = _last_forms(blocks, kept) | _rows_of_systems(blocks)
    told = [_bare(b) for i, b in enumerate(blocks) if (i in kept and not _is_datum(b)) or _stays(b)]
    return list(_without_empty([b for b in told if not (isinstance(b, Equation | Paragraph | Table) and b in before)]))


def _in_place(blocks: Sequence[Block]) -> frozenset[int]:
    """What stands in place of lines that give the answers: the numbered equations; without any all equations; without
    any the words and tables of a motion that is followed in numbers.
    """
    lines = [i for i, b in enumerate(blocks) if isinstance(b, Equation)]
    numbered = [i for i in lines if _number(blocks[i]) is not None]
    return frozenset(
        numbered or lines or [i for i, b in enumerate(blocks) if isinstance(b, Paragraph | Table | Bullet)]
    )


def _rows_of_systems(blocks: Sequence[Block]) -> frozenset[int]:
    """The equations whose rows are solved together in a table."""
    rows = {row[0] for b in blocks if isinstance(b, Table) and b.header[0] == ROW for row in b.rows}
    return frozenset(i for i, b in enumerate(blocks) if rows and line(f"({_number(b)})") in rows)


def _number(block: Block) -> int | None:
    return block.number if isinstance(block, Equation) else None


def _last_forms(blocks: Sequence[Block], kept: frozenset[int]) -> frozenset[int]:
    """Without lines that solve for a letter on the way, where a later line has its value."""
    rows = [(i, b) for i in sorted(kept) if isinstance(b := blocks[i], Equation) and b.number is None and b.lead]
    valued = {str(b.sides[0]): i for i, b in rows if isinstance(b.sides[-1], Value)}
    return kept - {i for i, b in rows if len(b.sides) == 2 and valued.get(str(b.sides[0]), i) > i and not _ends(b)}


def _ends(block: Equation) -> bool:
    """Does a line end in a value?"""
    return isinstance(block.sides[-1], Value)


def _stays(block: Block) -> bool:
    if isinstance(block, Heading):
        return block.label in KEPT
    if isinstance(block, Check):
        return any(sign in p.text for p in pieces_of(block.line) if isinstance(p, Text) for sign in TESTS)
    if isinstance(block, Table):
        return block.header[0] == ROW
    return bool(told_by_others(block)) or isinstance(block, Answer) or (isinstance(block, Note) and block.kind in NOTES)


def _without_empty(blocks: Sequence[Block]) -> Iterator[Block]:
    """Without headings under which nothing stands."""
    for i, block in enumerate(blocks):
        follows = blocks[i + 1] if i + 1 < len(blocks) else None
        if isinstance(block, Heading) and block.label == "STATE" and not isinstance(follows, Equation | Result):
            continue
        yield block


def _bare(block: Block) -> Block:
    """An equation without the notes that explain its arms."""
    return replace(block, note=_kept(block.note)) if isinstance(block, Equation) else block


def _kept(note: Line) -> Line:
    """The unit of numbers beside unknowns, and which of two roots it is; no other words."""
    first = note[0].text if note and isinstance(note[0], Text) else ""
    return note if ROOT in first or (first.startswith("in ") and len(note) == 1) else ()


def _is_datum(block: Block) -> bool:
    """Does it only repeat a number that the file gives?"""
    given = isinstance(block, Equation) and any(isinstance(p, Text) and GIVEN in p.text for p in block.lead)
    return given and isinstance(block, Equation) and len(block.sides) == 2
