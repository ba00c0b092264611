"""A motion of which the file gives every acceleration, in stretches: nothing is to be analysed before it, and it is
told in one step. What the file says in other units is converted once, where the motion begins; what is asked follows
the lines that it rests on.

    STEP 1  Motion over time                     states pass, go, meet
      ẋ_A = 108 km/h = 30 m/s
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise, takewhile

from planar_cli.report.document.blocks import Block, Equation, Heading, Inline, Line, Note, Paragraph, Text
from planar_cli.report.document.mentioned import names_in
from planar_cli.report.given.restated import is_restated

STRETCH = "MOTION"
"""The label of the heading of a stretch of a motion."""
STEP, ANALYSIS, ASSUME = "STEP", "Kinematic analysis", "Assume"
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


def without_single_stretch(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part without the heading of the only stretch that has forces of its own, where what follows leads
    through states before it as well: what is assumed of it stands with the rest, and its forces say whose they are.

    Assume      from 1 to meets: the spring is free
                from meets to lowest: the spring pushes

    STEP 1  Kinetic analysis
      From meets to lowest:
    """
    heads = [i for i, b in enumerate(blocks) if isinstance(b, Heading)]
    labels = [b.label for b in blocks if isinstance(b, Heading)]
    if labels[:1] != [STRETCH] or labels.count(STRETCH) > 1 or len(heads) < 3 or heads[1] == heads[0] + 1:
        return list(blocks)
    start, step, *later = heads
    stretch, first = blocks[start], blocks[step]
    assert isinstance(stretch, Heading)
    assert isinstance(first, Heading)
    led = [b.aside for b in (blocks[i] for i in later) if isinstance(b, Heading)]
    listed = [a.removeprefix(STATES).split(", ") for a in led if isinstance(a, str) and a.startswith(STATES)]
    words, assumed = stretch.text, list(blocks[start + 1 : step])
    earlier = len(listed) == 1 and not words.startswith(f"from {listed[0][0]} ") and words.startswith("from ")
    if not earlier or not all(isinstance(b, Note) and b.kind == ASSUME for b in assumed):
        return list(blocks)
    notes = [replace(b, line=(Text(f"{words}: "), *b.line)) for b in assumed if isinstance(b, Note)]
    whose = Paragraph((Text(f"{words[:1].upper()}{words[1:]}:"),))
    return [*blocks[:start], *notes, first, whose, *blocks[step + 1 :]]


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
