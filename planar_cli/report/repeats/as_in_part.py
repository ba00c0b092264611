"""A case that is derived word for word as an earlier part, with other numbers, refers to it and tells its results.

As in the first part, by (1) and (2):
     v_B,2 = (…)/(m_A + m_B) = (1 · 6 (4 - 1) + 6 · 4 + 4 · 1)/(6 + 4) = 4.6 m/s
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Math, Paragraph, Value, line
from planar_cli.report.equations.results import numbered
from planar_cli.report.repeats.equation_of_case import parts_of_page, with_equation_above
from planar_cli.report.repeats.found_before import asks_more, goes_on
from planar_cli.report.repeats.unused_numbers import without_unused_numbers
from planar_cli.solve.solved_problem import PartSolution

LEAST = 3
"""So many lines at least must be spared."""


def as_in_part(blocks: list[Block], before: Sequence[Block], problem: Problem, part: PartSolution) -> list[Block]:
    """The blocks of a case, which is `part`. `before`: those of the first part and of earlier cases."""
    blocks = without_unused_numbers(with_equation_above(blocks, before, part), before)
    if before and problem.cases and asks_more(problem):
        blocks = goes_on(blocks, before)
    earlier = list(parts_of_page(before))
    found: list[Block] = []
    start = 0
    while start < len(blocks):
        stop = _end(blocks, start + 1)
        section = blocks[start:stop]
        found += _referred(section, earlier) if earlier and isinstance(blocks[start], Heading) else section
        start = stop
    return found


def _end(blocks: Sequence[Block], start: int) -> int:
    """Where the lines of a step end."""
    told = (Paragraph, Equation, Forces)
    return next((i for i in range(start, len(blocks)) if not isinstance(blocks[i], told)), max(start, len(blocks)))


def _referred(section: Sequence[Block], earlier: Sequence[tuple[str, Sequence[Block]]]) -> list[Block]:
    """A step by what it has of its own; itself, where no earlier part derived it so."""
    heading, *lines = section
    assert isinstance(heading, Heading)
    for place, part in earlier:
        starts = [i for i, b in enumerate(part) if isinstance(b, Heading) and b.text == heading.text]
        for start in starts:
            old = list(part[start + 1 : _end(part, start + 1)])
            shared = _shared(lines, old)
            if (own := _own(lines[:shared], lines[shared:], old)) is not None:
                numbers = [b.number for b in lines[:shared] if isinstance(b, Equation) and b.number is not None]
                return [heading, Paragraph(line(f"As {place}, by {numbered(numbers)}:")), *own, *lines[shared:]]
    return list(section)


def _own(shared: Sequence[Block], rest: Sequence[Block], old: Sequence[Block]) -> list[Block] | None:
    """The results that are new among lines that stood there; None: there are none, nothing is to be spared, or the rest
    has equations of its own.
    """
    if any(isinstance(b, Equation) and b.number is not None for b in rest):
        return None
    fresh = (b for b in shared if b not in old)
    results = [replace(b, lead=()) for b in fresh if isinstance(b, Equation) and _is_result(b)]
    spared = len(shared) - len(results)
    numbers = [b for b in shared if isinstance(b, Equation) and b.number is not None]
    return None if not results or not numbers or spared < LEAST else list(results)


def _shared(lines: Sequence[Block], old: Sequence[Block]) -> int:
    """How many lines at the beginning stood there in this order, whatever their numbers are."""
    keys = map(_key, old)
    # What is searched is used up, so that each line is looked for below the one before it.
    return next((n for n, block in enumerate(lines) if _key(block) not in keys), len(lines))


def _is_result(block: Equation) -> bool:
    return block.number is None and isinstance(block.sides[-1], Value) and len(block.sides) > 1


def _key(block: Block) -> str:
    """What a line says without its numbers."""
    if not isinstance(block, Equation) or not _is_result(block):
        return repr(block)
    letters = [s for s in block.sides[:-1] if not isinstance(s, Math) or not s.values]
    return repr(replace(block, sides=tuple(letters)))
