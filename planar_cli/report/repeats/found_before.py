"""A case that only asks more of the same instant goes on from what an earlier one has found: this is not solved for a
second time, be it by other equations.

STEP 3  Solving the equations                           (3) to (6), 4 unknowns: B_x, B_y, A_n, O_x
  As before: α_AB = 116.9 rad/s², A_t = 45.60 N.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TypeGuard

from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.report.document.as_printed import as_text, read_alike
from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Math, Paragraph, Text, Value, line
from planar_cli.report.document.said import letter_of
from planar_cli.report.equations.one_motion import ANALYSIS, STEP
from planar_cli.report.equations.results import numbered
from planar_cli.report.equations.steps import SOLVING
from planar_cli.report.repeats.idle_symmetry import renumbered

NUMBER, RUN = re.compile(r"\((\d+)\)"), re.compile(r"\((\d+)\) to \((\d+)\)")
COUNTED = re.compile(r"(.*), \d+ unknowns: ")
"""The aside of the step that solves, up to its first unknown."""
COLLECTED = "collected:"
LINES = (Equation, Paragraph)


def asks_more(problem: Problem) -> bool:
    """Do the cases of a file differ in nothing but what they ask, of one instant?"""
    own = _unasked(problem)
    return not problem.states and all(_unasked(case.problem) == own for case in problem.cases)


def _unasked(problem: Problem) -> Problem:
    return replace(problem, find=(), cases=(), answers=())


def goes_on(blocks: Sequence[Block], before: Sequence[Block]) -> list[Block]:
    """The blocks of a case. `before`: those of earlier ones of the same instant. As they are, where all is found there,
    or nothing.
    """
    start = next((i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == SOLVING), len(blocks))
    stop = next((i for i in range(start + 1, len(blocks)) if not isinstance(blocks[i], Equation)), len(blocks))
    values = {letter_of(b.sides[0]): read_alike(b.sides[-1]) for b in before if _is_result(b)}
    groups = list(_groups([b for b in blocks[start + 1 : stop] if isinstance(b, Equation)]))
    known = [g for g in groups if g.letter and values.get(g.letter) == read_alike(g.lines[-1].sides[-1])]
    kept = [g for g in groups if g not in known]
    if not known or not any(g.letter for g in kept):
        return list(blocks)
    others = [*blocks[:start], *(b for g in kept for b in g.lines), *blocks[stop:]]
    idle = _cited(b for g in known for b in g.lines) - _cited(others)
    gone = [n for n in idle if _stands_alone(blocks[:start], n, before)]
    heading = blocks[start]
    assert isinstance(heading, Heading)
    headed = _counted(heading, idle, gone, {g.letter for g in known})
    if headed is None:
        return list(blocks)
    told = [p for g in known for p in (", ", g.lines[-1].sides[0], " = ", g.lines[-1].sides[-1])][1:]
    above = _without(blocks[:start], gone)
    own = _renumbered([b for g in kept for b in g.lines], gone)
    page = [*_renumbered(above, gone), *headed, Paragraph(line("As before: ", *told, ".")), *own, *blocks[stop:]]
    return _without_told_step(page, before)


def _without_told_step(blocks: list[Block], before: Sequence[Block]) -> list[Block]:
    """Blocks without a first step of kinematics that an earlier case has told, and of which no later line names an
    equation.
    """
    heads = [i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.label.startswith(STEP)]
    start, stop = (*heads, 0, 0)[:2]
    first = blocks[start]
    if start >= stop or not isinstance(first, Heading) or first.text != ANALYSIS:
        return blocks
    own, said = blocks[start:stop], {read_alike(b) for b in before}
    numbers = {b.number for b in own if isinstance(b, Equation)}
    if numbers & _cited(blocks[stop:]) or not all(read_alike(b) in said for b in own):
        return blocks
    kept = [*blocks[:start], *blocks[stop:]]
    for count, i in enumerate(heads[1:], 1):
        head = blocks[i]
        assert isinstance(head, Heading)
        kept[i - (stop - start)] = replace(head, label=f"{STEP} {count}")
    return kept


@record
class _Group:
    """The lines by which equations give one letter; other lines without a letter."""

    lines: tuple[Equation, ...]
    letter: str = ""


def _groups(lines: Sequence[Equation]) -> Iterator[_Group]:
    """`(5): A_t = …` alone; `(1) in (2): 0.17 ω_AB = -0.8` with the line below it, which gives ω_AB."""
    start = 0
    while start < len(lines):
        stop = start + 1
        if _cited(lines[start : start + 1]) and not _is_result(lines[start]):
            while stop < len(lines) and not lines[stop].lead and not _is_result(lines[stop - 1]):
                stop += 1
        led = bool(_cited(lines[start : start + 1])) and _is_result(lines[stop - 1])
        yield _Group(tuple(lines[start:stop]), letter_of(lines[stop - 1].sides[0]) if led else "")
        start = stop


def _is_result(block: Block) -> TypeGuard[Equation]:
    """Is it a line that ends with the value of a letter?"""
    if not isinstance(block, Equation) or block.number is not None or len(block.sides) < 2:
        return False
    return isinstance(block.sides[-1], Value) and bool(letter_of(block.sides[0]))


def _cited(blocks: Iterable[Block]) -> set[int]:
    """The numbers of equations that lines and sentences name."""
    parts = (b.line if isinstance(b, Paragraph) else (*b.lead, *b.note) for b in blocks if isinstance(b, LINES))
    said = " ".join(p.text for line_of in parts for p in line_of if isinstance(p, Text))
    return {int(n) for n in NUMBER.findall(said)} | {
        n for first, last in RUN.findall(said) for n in range(int(first), int(last) + 1)
    }


def _end(blocks: Sequence[Block], i: int) -> int:
    """Where the lines of an equation end: behind what it is when its numbers are collected."""
    after = blocks[i + 1] if i + 1 < len(blocks) else None
    return i + 1 + (isinstance(after, Equation) and as_text(after.lead).strip() == COLLECTED)


def _stands_alone(blocks: Sequence[Block], number: int, before: Sequence[Block]) -> bool:
    """Is it an equation of forces that no earlier case has, and on which no line below it goes on?"""
    i = next((i for i, b in enumerate(blocks) if isinstance(b, Equation) and b.number == number), None)
    if i is None or not any(isinstance(b, Forces) for b in blocks[:i]):
        return False
    own = blocks[i]
    assert isinstance(own, Equation)
    if any(isinstance(b, Equation) and b.lead == own.lead and b.sides == own.sides for b in before):
        return False
    below = blocks[end] if (end := _end(blocks, i)) < len(blocks) else None
    return not isinstance(below, Equation) or below.number is not None


def _without(blocks: Sequence[Block], gone: Collection[int]) -> list[Block]:
    """Blocks without these equations, and without the words that lead to nothing else."""
    kept = list(blocks)
    for i in reversed(range(len(kept))):
        block = kept[i]
        if not isinstance(block, Equation) or block.number not in gone:
            continue
        end = _end(kept, i)
        below = kept[end] if end < len(kept) else None
        led = i > 0 and isinstance(kept[i - 1], Paragraph) and not isinstance(below, Equation)
        del kept[i - led : end]
    return kept


def _renumbered(blocks: Sequence[Block], gone: Iterable[int]) -> list[Block]:
    kept = list(blocks)
    for number in sorted(gone, reverse=True):
        kept = [renumbered(b, number) for b in kept]
    return kept


def _counted(
    heading: Heading, idle: Collection[int], gone: Collection[int], found: Collection[str]
) -> Sequence[Heading] | None:
    """The heading of the step that solves the other equations for the other unknowns; nothing over the solution of a
    single one; None: it says more than which these are.
    """
    aside = line(heading.aside) if isinstance(heading.aside, str) else heading.aside
    counted = COUNTED.fullmatch(aside[0].text) if aside and isinstance(aside[0], Text) else None
    letters = [p for p in aside[1:] if isinstance(p, Math)]
    if counted is None or any(isinstance(p, Text) and p.text not in ("", ", ") for p in aside[1:]):
        return None
    said = Paragraph(line(counted[1]))
    numbers = _cited([said]) or set(range(1, 1 + int(counted[1].split()[0])))
    unknown = [p for p in letters if letter_of(p) not in found]
    left = sorted(n - sum(g < n for g in gone) for n in numbers - set(idle))
    if len(left) != len(unknown):
        return None
    if len(left) == 1:
        return ()
    parts = [x for p in unknown for x in (", ", p)][1:]
    return (replace(heading, aside=line(f"{numbered(left)}, {len(left)} unknowns: ", *parts)),)
