"""A step of an earlier case at another angle: the diagram of a body turned there, all equations the same in letters.

A pendulum about its lowest and about its highest place: S and m l θ̇² point the other way, but along the rod and across
it the equations hold for every θ.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from itertools import islice, pairwise, takewhile

from planar_cli.report.document.blocks import Block, Equation, Forces, Heading

ARROWS = "→↗↑↖←↙↓↘"
"""Directions, each an eighth of a turn after the one before."""
ARROW = re.compile(f"[{ARROWS}]")


def without_arrows(said: str) -> str:
    """What a block says but for directions."""
    return ARROW.sub("#", said)


def is_turned(one: str, other: str) -> bool:
    """Do two diagrams differ in directions alone, all but one, that of the weight, being turned by the same angle?"""
    if without_arrows(one) != without_arrows(other):
        return False
    pairs = zip(ARROW.findall(one), ARROW.findall(other), strict=True)
    turns = [(ARROWS.index(b) - ARROWS.index(a)) % len(ARROWS) for a, b in pairs]
    return turns.count(0) <= 1 and len({*turns} - {0}) == 1


def steps_turned(
    blocks: Sequence[Block], known: Sequence[bool], is_as_turned: Callable[[Block], bool]
) -> Iterator[bool]:
    """For each block whether it stands in a step of which all is known but for a diagram that is turned. `known`: what
    stood there word for word.
    """
    starts = [0, *(i for i, b in enumerate(blocks) if isinstance(b, Heading) and i), len(blocks)]
    for since, stop in pairwise(starts):
        step = [i for i in range(since, stop) if not isinstance(blocks[i], Heading)]
        new = [i for i in step if not known[i]]
        drawn = any(isinstance(blocks[i], Forces) for i in new)
        same = drawn and all(isinstance(blocks[i], Forces | Equation) and is_as_turned(blocks[i]) for i in new)
        yield from (same and i in step for i in range(since, stop))


def with_first_equations(blocks: Sequence[Block]) -> Iterator[tuple[Forces, Equation]]:
    """Every diagram with the first numbered equation below it in its step."""
    for i, block in enumerate(blocks):
        if isinstance(block, Forces):
            below = takewhile(lambda b: not isinstance(b, Heading), blocks[i + 1 :])
            numbered = (b for b in below if isinstance(b, Equation) and b.number is not None)
            yield from ((block, first) for first in islice(numbered, 1))
