"""What slides along a curve of a turning body has its coordinate along an axis of that body: it is called ξ from the
start, as x is that of the fixed axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from planar_cli.report.blocks import Answer, Block, Heading, Name, Paragraph, Text, line
from planar_cli.report.one_name import renamed
from planar_cli.report.turning_axes import coordinates_turned
from planar_cli.solve.between.trace import MotionTrace

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
    first = next((i for i, b in enumerate(told) if isinstance(b, Heading)), -1)
    what = f": coordinates of {point} along axes that turn with {frame}, x and y at the start"
    return [*told[: first + 1], Paragraph(line(Name("xi"), ", ", Name("eta"), what)), *told[first + 1 :]]


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
