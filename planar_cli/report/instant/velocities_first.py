"""What is asked of velocities stands with the velocities, before the accelerations that rest on them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Block, Equation
from planar_cli.report.document.joined_lines import ACCELERATIONS, VELOCITIES
from planar_cli.report.document.said import said
from planar_cli.report.instant.asked import AskedTelling
from planar_cli.report.instant.axes_asked import is_vector
from planar_cli.solve.solution import Found


def of_velocities(found: Iterable[Found], late: Collection[sp.Symbol]) -> tuple[Found, ...]:
    """Those of the answers that are velocities and rest on velocities alone. `late`: what is only found after them."""
    return tuple(f for f in found if _word(f) == "v" and not any(e.free_symbols & set(late) for e in f.asked))


def asked_told(asked: AskedTelling, found: Iterable[Found], blocks: list[Block]) -> Iterator[Block]:
    """The lines of some answers but for those that stand in `blocks`; accelerations behind all else, under a heading
    where the blocks have one for velocities alone.
    """
    told = [said(b) for b in blocks if isinstance(b, Equation)]
    told += [[sides[0], sides[-1]] for sides in told if len(sides) > 2]
    alone = VELOCITIES in blocks and ACCELERATIONS not in blocks
    every = tuple(found)
    last = tuple(f for f in every if alone and _word(f) in ("a", "coriolis"))
    for b in asked.blocks(f for f in every if f not in last):
        yield from _new(b, told)
    behind = [new for b in asked.blocks(last) for new in _new(b, told)]
    yield from (ACCELERATIONS, *behind) if any(isinstance(b, Equation) for b in behind) else behind


def without_repeats(blocks: Iterable[Block], above: Iterable[Block]) -> list[Block]:
    """The blocks without vector equations that stand above them with their values."""
    told = [said(b)[:2] for b in above if isinstance(b, Equation)]
    return [b for b in blocks if not isinstance(b, Equation) or said(b) not in told]


def _new(block: Block, told: list[list[Any]]) -> Iterator[Block]:
    """A line that was not told; a vector in letters without the equation that stands above it."""
    if not isinstance(block, Equation):
        yield block
        return
    own = said(block)
    if len(own) == 3 and own[:2] in told and is_vector(block.sides[-1]):
        yield replace(block, sides=(block.sides[0], block.sides[-1]))
    elif own not in told:
        yield block


def _word(found: Found) -> str:
    """The word of the quantity that is asked."""
    what = found.find.found.what if found.find is not None else None
    return what.word if isinstance(what, Quantity) else ""
