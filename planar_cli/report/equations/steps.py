"""The headings of the steps of a page: what is solved at sight needs none of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.report.document.blocks import Block, Heading, Text
from planar_cli.report.equations.one_motion import STEP, STRETCH, in_one_motion, without_single_stretch

SOLVING, SINGLE = "Solving the equations", "1 equation, 1 unknown"
KINETICS, EQUILIBRIUM = "Kinetic analysis", "Equilibrium"
"""The step of the forces: of what moves, and of what does not."""


def without_ritual(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks of a part without the heading over the solution of a single equation, which stands just before, and
    without a step of which nothing is left; the steps behind it count on.
    """
    left_out = 0
    if any(isinstance(b, Heading) and b.label == STRETCH for b in blocks):
        blocks = without_single_stretch(in_one_motion(blocks))
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        if not isinstance(block, Heading) or not block.label.startswith(STEP):
            yield block
            continue
        number = int(block.label.removeprefix(STEP))
        left_out = 0 if number == 1 else left_out
        empty = isinstance(after, Heading) and after.label.startswith(STEP) and not block.aside
        if empty or (number > 1 and is_ritual(block)):
            left_out += 1
        else:
            yield replace(block, label=f"{STEP} {number - left_out}")


def is_ritual(heading: Heading) -> bool:
    """Does it stand over the solution of a single equation?"""
    first = heading.aside[0] if isinstance(heading.aside, tuple) and heading.aside else None
    return heading.text == SOLVING and isinstance(first, Text) and first.text.startswith(SINGLE)
