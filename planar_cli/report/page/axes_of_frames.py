"""What slides along a curve of a turning body has its coordinate along an axis of that body: it is called ξ from the
start, as x is that of the fixed axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from planar_cli.report.document.blocks import Answer, Block, Equation, Heading, Math, Name, Paragraph, Text, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.given.data import GIVEN
from planar_cli.report.kinematics.turning_axes import coordinates_turned
from planar_cli.report.repeats.idle_symmetry import renumbered
from planar_cli.report.words.one_name import renamed
from planar_cli.solve.between.trace.trace import MotionTrace

STEP, STATE = "STEP", "__"
RATES = ("_dot", "_ddot")
SPOKEN = ("line", "lead", "note")
"""Fields of blocks that hold words."""


def with_axes_of_frames(blocks: Sequence[Block], motion: MotionTrace | None) -> list[Block]:
    """The blocks of a part with ξ for such a coordinate, its rates and its values in states."""
    places = {} if motion is None else coordinates_turned(motion)
    if motion is None or len(places) != 1:
        return list(blocks)
    ((place, (point, frame)),) = places.items()
    names = {place.name: "xi"} | {f"{place.name}{dots}": f"xi{dots}" for dots in RATES}
    names |= {f"{own}__{state}": f"{new}__{state}" for own, new in tuple(names.items()) for state in motion.states}
    told = [_spoken(b, point) for b in renamed(blocks, names)]
    told = _without_slide(told)
    first = next((i for i, b in enumerate(told) if isinstance(b, Heading)), -1)
    what = f": coordinates of {point} along axes that turn with {frame}, x and y at the start"
    relative = line("; ", Name("v_rel"), " = [", Name("xi_dot"), ", ", Name("eta_dot"), "]")
    axes = Paragraph(line(Name("xi"), ", ", Name("eta"), what, relative))
    return [*told[: first + 1], axes, *told[first + 1 :]]


def _without_slide(blocks: list[Block]) -> list[Block]:
    """The blocks without a first step that only finds the speed along the curve, of which nothing behind it speaks: by
    ξ̇ and η̇ it is told without that.
    """
    heads = [i for i, b in enumerate(blocks) if isinstance(b, Heading)]
    if len(heads) < 2 or not _is_step(blocks[heads[0]]) or not _is_step(blocks[heads[1]]):
        return blocks
    step, behind = blocks[heads[0] + 1 : heads[1]], blocks[heads[1] :]
    equations = [b for b in step if isinstance(b, Equation)]
    found = [b for b in equations if b.lead != GIVEN]
    inside = set.intersection(*map(_letters, found)) if found else set()
    if len(equations) + sum(isinstance(b, Paragraph) for b in step) < len(step) or not inside - _spoken_of(behind):
        return blocks
    numbers = [b.number for b in equations if b.number is not None]
    for number in reversed(numbers):
        behind = [renumbered(b, number) for b in behind]
    kept = [replace(b, label=_one_less(b.label)) if isinstance(b, Heading) else b for b in behind]
    return [*blocks[: heads[0]], *kept]


def _is_step(block: Block) -> bool:
    return isinstance(block, Heading) and block.label.startswith(STEP)


def _one_less(label: str) -> str:
    number = label.removeprefix(STEP)
    return f"{STEP} {int(number) - 1}" if label.startswith(STEP) else label


def _letters(block: Block) -> set[str]:
    return {s.name for p in pieces_of(block) if isinstance(p, Math) for s in p.expr.free_symbols}


def _spoken_of(blocks: Sequence[Block]) -> set[str]:
    """All letters in blocks, those of states in general too."""
    found = {name for b in blocks for name in _letters(b)}
    return found | {name.partition(STATE)[0] for name in found}


def _spoken(block: Block, point: str) -> Block:
    """With the axis named in its words."""
    return block if isinstance(block, Answer) else _put(block, point)


def _put(part: Any, point: str) -> Any:
    if isinstance(part, Text):
        words = part.text.replace(f"For x of {point}:", f"For ξ of {point}:")
        return replace(part, text=words.replace(f"of {point} along x", f"of {point} along ξ"))
    if isinstance(part, tuple):
        return tuple(_put(p, point) for p in part)
    inside = [f.name for f in fields(part) if f.name in SPOKEN] if is_dataclass(part) else []
    return replace(part, **{n: _put(getattr(part, n), point) for n in inside}) if inside else part
