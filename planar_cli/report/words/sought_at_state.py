"""What the file seeks and says is the value of something at a state is called so from the start: v_0, not v_Gx,1 up to
a line `At 1: v_0 = v_Gx,1`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from planar_cli.report.document.blocks import Answer, Block, Equation, Math, Text, Value
from planar_cli.report.words.one_name import letter_of_answer, renamed
from planar_cli.solve.between.trace.trace import MotionTrace

AS_GIVEN = "as given"
STATE = "__"
"""Stands before the state in the name of a letter."""


def with_sought_names(blocks: Sequence[Block], motion: MotionTrace | None) -> list[Block]:
    """The blocks of a part of a page."""
    sought = [] if motion is None else [u.name for u in motion.problem.unknowns]
    stays = {letter_of_answer(b.line) for b in blocks if isinstance(b, Answer)} | set(_given(blocks))
    said = {at: own for at, own in _said_the_same(blocks, sought) if at not in stays}
    if len(set(said.values())) < len(said):
        said = {}
    names = said | {at: own for at, own in _put_in(blocks, motion, sought) if at not in stays}
    if not names:
        return list(blocks)
    kept = [b for b in blocks if not any(pair in said.items() for pair in _said_the_same([b], sought))]
    return renamed(kept, names)


def _given(blocks: Sequence[Block]) -> Iterator[str]:
    """What a line gives: the wind has then the speed of the cyclist for a reason."""
    for b in blocks:
        match b:
            case Equation((Math(at), *_), None, (Text(lead), *_)) if at.is_Symbol and AS_GIVEN in lead:
                yield at.name


def _put_in(blocks: Sequence[Block], motion: MotionTrace | None, sought: Collection[str]) -> Iterator[tuple[str, str]]:
    """The letters of states for which an unknown of the file was put in at once, where no line tells them."""
    told = {b.sides[0].expr for b in blocks if isinstance(b, Equation) and isinstance(b.sides[0], Math)}
    for at, own in motion.route.plain.items() if motion is not None and sought else ():
        if own.is_Symbol and own.name in sought and STATE in at.name and at not in told:
            yield at.name, own.name


def _said_the_same(blocks: Sequence[Block], sought: Collection[str]) -> Iterator[tuple[str, str]]:
    """The letters of states that lines say to be an unknown, each with its name."""
    for b in blocks:
        match b:
            case Equation((Math(own), Math(at), Value()), None, (Text(lead), *_)) if own.is_Symbol and at.is_Symbol:
                if lead.startswith("At ") and own.name in sought and STATE in at.name:
                    yield at.name, own.name
