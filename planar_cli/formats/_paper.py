"""A drawing on paper: strokes, discs and words, in pixels; x to the right, y downward."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace
from itertools import pairwise

from planar_cli.formats._layout import settled, spans
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, Name

Spot = tuple[float, float]
SIZE = 13.0
"""Of letters."""
SMALL = 0.72
"""Of an index."""
WIDE, NARROW = set("mwMW∑Σ@ω"), set("iljtfrI.,:;|'′()[] /")
_INDEX = re.compile(r"_([^\s/)\]=<>+·²³⁴′]+)|(?<=(?<![^\W\d_])[^\W\d_])(\d+)(?![A-Za-z0-9.])")
_OF_NAME = re.compile(r"_([^\s)\]=<>+·²³⁴′]+)|(?<=[^\W\d_])(\d+)(?![\d.])")
"""The index of one name alone: a stroke in it is a relative motion, v_B/A. Digits behind a letter are one too: v0."""


@record
class Stroke:
    """A line through some places; `closed`: the outline of an area. `kind`: its class in the style sheet."""

    places: tuple[Spot, ...]
    kind: str
    closed: bool = False


@record
class Disc:
    """A circle."""

    center: Spot
    radius: float
    kind: str


@record
class Run:
    """Letters in one style; `index`: they stand lower and smaller; `formula`: they are slanted."""

    text: str
    index: bool = False
    formula: bool = False

    @property
    def width(self) -> float:
        return sum(map(_width, self.text)) * SIZE * (SMALL if self.index else 1.0)


@record
class Words:
    """Words that belong to a place, and where they may stand: `angles`, in order of preference; `fixed`: nowhere but
    at the first of them, as the numbers of an axis. `room`: their width, where letters have another one than usual.
    """

    runs: tuple[Run, ...]
    anchor: Spot
    kind: str
    angles: tuple[float, ...] = ()
    gap: float = 6.0
    within: bool = False
    fixed: bool = False
    room: float = 0.0

    @property
    def width(self) -> float:
        return self.room or sum(r.width for r in self.runs)

    @property
    def height(self) -> float:
        return SIZE * 1.25


@record
class Box:
    """An upright rectangle."""

    left: float
    top: float
    right: float
    bottom: float

    def overlaps(self, other: Box) -> bool:
        return (
            self.left < other.right and other.left < self.right and self.top < other.bottom and other.top < self.bottom
        )

    def is_cut(self, start: Spot, end: Spot) -> bool:
        """Does a straight line go through it (Liang and Barsky: by where it passes each edge)?"""
        first, last = 0.0, 1.0
        for at, step, low, high in (
            (start[0], end[0] - start[0], self.left, self.right),
            (start[1], end[1] - start[1], self.top, self.bottom),
        ):
            if step == 0.0:
                if not low < at < high:
                    return False
                continue
            enters, leaves = sorted(((low - at) / step, (high - at) / step))
            first, last = max(first, enters), min(last, leaves)
        return first < last

    def grown(self, by: float) -> Box:
        return Box(self.left - by, self.top - by, self.right + by, self.bottom + by)

    def around(self, other: Box) -> Box:
        return Box(
            min(self.left, other.left),
            min(self.top, other.top),
            max(self.right, other.right),
            max(self.bottom, other.bottom),
        )


@record
class Placed:
    """Words at their place: the box that they fill."""

    words: Words
    box: Box


@record
class Paper:
    """What one panel has on paper."""

    strokes: tuple[Stroke | Disc, ...]
    words: tuple[Words, ...]
    placed: tuple[Placed, ...] = field(default=())


def runs_of(line: Line) -> tuple[Run, ...]:
    """A line as runs of letters, with indices set lower."""
    found: list[Run] = []
    for piece in line:
        alone = isinstance(piece, Name) or (isinstance(piece, Math) and piece.expr.is_Symbol)
        for span in settled(spans((piece,))):
            text, formula, end = span.text, span.style == "math", 0
            for match in (_OF_NAME if alone else _INDEX).finditer(text) if formula or "_" in text else ():
                found += [Run(text[end : match.start()], formula=formula), Run(match[1] or match[2], True, formula)]
                end = match.end()
            found.append(Run(text[end:], formula=formula))
    return tuple(_joined(r for r in found if r.text))


def _joined(runs: Iterable[Run]) -> Iterator[Run]:
    """Two indices that follow each other as one: v0_x."""
    last: Run | None = None
    for run in runs:
        if last is not None and last.index and run.index:
            last = replace(last, text=f"{last.text},{run.text}")
            continue
        if last is not None:
            yield last
        last = run
    if last is not None:
        yield last


def width_of(runs: Sequence[Run]) -> float:
    """The width of letters in a row."""
    return sum(r.width for r in runs)


def along(stroke: Stroke | Disc, step: float) -> Iterator[Spot]:
    """Places along a stroke, not farther apart than `step`."""
    if isinstance(stroke, Disc):
        count = max(int(2 * math.pi * stroke.radius / step), 8)
        for i in range(count):
            a = 2 * math.pi * i / count
            yield stroke.center[0] + stroke.radius * math.cos(a), stroke.center[1] + stroke.radius * math.sin(a)
        return
    places = (*stroke.places, stroke.places[0]) if stroke.closed else stroke.places
    for (x0, y0), (x1, y1) in pairwise(places):
        count = max(int(math.hypot(x1 - x0, y1 - y0) / step), 1)
        for i in range(count + 1):
            yield x0 + (x1 - x0) * i / count, y0 + (y1 - y0) * i / count


def box_of(spots: Iterable[Spot]) -> Box | None:
    """The box round some places; None: there are none."""
    found: Sequence[Spot] = list(spots)
    if not found:
        return None
    xs, ys = zip(*found, strict=True)
    return Box(min(xs), min(ys), max(xs), max(ys))


def _width(letter: str) -> float:
    """The width of a letter in parts of its size, rather too wide than too narrow."""
    if letter in NARROW:
        return 0.38
    if letter in WIDE:
        return 0.92
    return 0.72 if letter.isupper() else 0.62
