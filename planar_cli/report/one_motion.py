"""A motion of which the file gives every acceleration, in stretches: nothing is to be analysed before it, and it is
told in one step. What the file says in other units is converted once, where the motion begins; what is asked follows
the lines that it rests on.

    STEP 1  Motion over time                     states pass, go, meet
      ẋ_A = 108 km/h = 30 m/s
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, takewhile

from planar_cli.report.blocks import Block, Equation, Heading, Inline, Line, Paragraph, Text
from planar_cli.report.mentioned import names_in
from planar_cli.report.restated import is_restated

STRETCH = "MOTION"
"""The label of the heading of a stretch of a motion."""
STEP, ANALYSIS = "STEP", "Kinematic analysis"
TITLES = ("Motion over time", "Motion")
STATES, HENCE = "states ", "Hence"


def in_one_motion(blocks: Sequence[Block]) -> Sequence[Block]:
    """The blocks of a part with stretches so; the same object where it is no such motion."""
    starts = [i for i, b in enumerate(blocks) if isinstance(b, Heading)]
    sections = [blocks[i:j] for i, j in pairwise([*starts, len(blocks)])]
    data, moving = list[Block](), list[Block]()
    states: list[str] = []
    for head, *own in sections:
        assert isinstance(head, Heading)
        if head.label == STRETCH and not own:
            continue
        if head.text == ANALYSIS and is_restated([head, *own], converted=True):
            data += [b for b in own if isinstance(b, Equation) and len(b.sides) > 2 and b not in data]
        elif head.text in TITLES and isinstance(head.aside, str) and head.aside.startswith(STATES):
            states += [s for s in head.aside.removeprefix(STATES).split(", ") if s not in states]
            moving += own
        else:
            return blocks
    told = Heading(f"{STEP} 1", TITLES[0], STATES + ", ".join(states))
    return [*blocks[: starts[0]], told, *data, *_asked_in_turn(moving)]


def _asked_in_turn(blocks: Sequence[Block]) -> list[Block]:
    """What stands under `Hence:` right behind the last line on which it rests, where a heading follows that."""
    at = next((i for i, b in enumerate(blocks) if _is_hence(b)), len(blocks))
    asked = list(takewhile(lambda b: isinstance(b, Equation), blocks[at + 1 :]))
    before, left = list(blocks[:at]), list[Block]()
    for line in asked:
        used = {name for side in _sides(line)[1:] for name in names_in(side)}
        rests = [i for i, b in enumerate(before) if {n for s in _sides(b)[:1] for n in names_in(s)} & used]
        behind = max(rests, default=at) + 1
        if isinstance(next(iter(before[behind:]), None), Paragraph):
            before[behind:behind] = [blocks[at], line]
        else:
            left.append(line)
    return [*before, *([blocks[at], *left] if left else []), *blocks[at + 1 + len(asked) :]]


def _is_hence(block: Block) -> bool:
    first = block.line[0] if isinstance(block, Paragraph) else None
    return isinstance(first, Text) and first.text.startswith(HENCE)


def _sides(block: Block) -> tuple[Inline | Line, ...]:
    return block.sides if isinstance(block, Equation) else ()
