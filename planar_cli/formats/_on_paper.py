"""Marks of a figure on paper: what has a size there alone, such as arrows, hatching and signs, gets it here."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import singledispatch
from typing import Any

from planar_cli.formats._graph import graph_pieces
from planar_cli.formats._paper import Box, Disc, Paper, Run, Spot, Stroke, Words, along, box_of, runs_of
from planar_cli.formats._signs import sign, slot
from planar_cli.formats._strokes import LATER, WAY, Piece, arc, hatching, moved, pointed
from planar_cli.records import record
from planar_cli.report.document.graphs import Graph
from planar_cli.report.document.marks import (
    Angle,
    Arc,
    Arrow,
    Axes,
    Coil,
    Dashpot,
    Dimension,
    Hatched,
    Mark,
    Panel,
    Polyline,
    Slot,
    Span,
    Symbol,
    Tag,
    Turn,
    spots_of,
)

ASIDE, ROW = 18.0, 24.0
"""How far a dimension is drawn beside what it measures, and how far rows of them are apart."""
VERTEX = 26.0
"""The radius of the arc of an angle."""
COUPLES, CLEAR = (17.0, 24.0, 31.0, 12.0), 5.0
"""The radii of the arrow of a couple, the best first, and how far it keeps from other circles about its place."""
AXIS, APART = 30.0, 62.0
"""The length of an axis, and how far the axes are beside everything."""
EXTENSION = "measure extension"
"""What leads from a place to its dimension: it lies below all else."""
STRENGTH = 10.0
"""So far from the middle line of a spring its letter stands."""
HEAD = (6.5, 2.2)
"""How long the head of a dimension is, and how wide on either side."""
LEFT = 10.0
"""So much is left of a dimension line on either side of its words."""
BELOW, LANES = (LATER, WAY, EXTENSION), ("lane", "lane core")
ARROW = 46.0
"""The length of an arrow."""


@record
class Scale:
    """How metres become pixels: x right, y downward."""

    pixels: float
    """Of one metre."""
    origin: Spot = (0.0, 0.0)
    """The place at the zero of paper, m."""

    def spot(self, place: Spot) -> Spot:
        return (place[0] - self.origin[0]) * self.pixels, (self.origin[1] - place[1]) * self.pixels


def on_paper(panel: Panel, scale: Scale) -> Paper:
    """A panel on paper, with words that have no places yet."""
    level = [m for m in panel.marks if isinstance(m, Dimension) and m.level]
    axes = [m for m in panel.marks if isinstance(m, Axes)]
    inner = [m for m in panel.marks if not isinstance(m, Axes) and m not in level]
    pieces = [piece for mark in in_rows(_with_room(inner, scale), scale) for piece in _drawn(mark, scale)]
    frame = box_of(spot for p in pieces if isinstance(p, Stroke | Disc) for spot in along(p, 8.0))
    pieces += _beside(level, frame or Box(0.0, 0.0, 0.0, 0.0), scale)
    whole = box_of(spot for p in pieces if isinstance(p, Stroke | Disc) for spot in along(p, 8.0))
    if whole is not None:
        pieces += [p for mark in axes for p in _axes(mark, (whole.left - APART, whole.bottom))]
    # What is somewhere only later lies below all that is there, and on the lane along which it moves.
    drawn = (p for p in pieces if isinstance(p, Stroke | Disc))
    strokes = sorted(drawn, key=lambda s: (s.kind not in LANES, s.kind not in BELOW))
    return Paper(tuple(strokes), tuple(p for p in pieces if isinstance(p, Words) and p.runs))


def pieces_of(mark: Mark, scale: Scale) -> Iterator[Piece]:
    """One mark on paper."""
    yield from _drawn(mark, scale)


def _axes(mark: Axes, at: Spot) -> Iterator[Piece]:
    """x, y and, where there is weight, g."""
    for name, angle in (("x", 0.0), ("y", math.pi / 2)):
        tip = moved(at, angle, AXIS)
        yield from pointed((at, tip), "axis")
        yield Words((Run(name, formula=True),), tip, "axis", (angle,), 3.0)
    if mark.heavy:
        start = moved(at, 0.0, AXIS * 0.75, AXIS * 0.95)
        tip = moved(start, -math.pi / 2, AXIS * 0.6)
        yield from pointed((start, tip), "axis")
        yield Words((Run("g", formula=True),), moved(start, -math.pi / 2, AXIS * 0.3), "axis", (0.0,), 3.0)


@singledispatch
def _drawn(mark: Any, scale: Scale) -> Iterator[Piece]:
    raise TypeError(type(mark).__name__)


@_drawn.register
def _polyline(mark: Polyline, scale: Scale) -> Iterator[Piece]:
    if mark.style in ("slim", "lane"):
        # Light within, so that an arrow along it is seen.
        kinds = (mark.style, f"{mark.style} core")
        yield from (Stroke(tuple(map(scale.spot, mark.places)), kind) for kind in kinds)
        return
    filled = mark.closed and mark.style != LATER
    kind = f"{mark.style} area" if filled else f"{mark.style} bar" if mark.style == "body" else mark.style
    yield Stroke(tuple(map(scale.spot, mark.places)), kind, mark.closed)


@_drawn.register
def _arc(mark: Arc, scale: Scale) -> Iterator[Piece]:
    center, radius = scale.spot(mark.center), mark.radius * scale.pixels
    if abs(mark.sweep) >= 2 * math.pi - 1e-9:
        filled = mark.style != LATER and not mark.hollow
        yield Disc(center, radius, f"{mark.style} area" if filled else mark.style)
    else:
        yield Stroke(arc(center, radius, mark.start, mark.sweep), mark.style)


@_drawn.register
def _hatched(mark: Hatched, scale: Scale) -> Iterator[Piece]:
    places = tuple(map(scale.spot, mark.places))
    if mark.aside:
        (x, y), (u, v) = places[0], places[-1]
        way = math.atan2(y - v, u - x)
        places = tuple(moved(p, way, 0.0, mark.aside) for p in places)
    yield Stroke(places, "ground")
    yield from hatching(places)


@_drawn.register
def _coil(mark: Coil, scale: Scale) -> Iterator[Piece]:
    start, end, angle = _held(mark, scale)
    length = math.dist(start, end)
    lead, turns = length * 0.14, max(min(int((mark.like * scale.pixels or length) / 9), 12), 4)
    inner = length - 2 * lead
    zigzag = [moved(start, angle, lead + inner * (i + 0.5) / (2 * turns), 6.0 * (-1) ** i) for i in range(2 * turns)]
    kind = LATER if mark.later else "spring"
    yield Stroke((start, moved(start, angle, lead), *zigzag, moved(start, angle, length - lead), end), kind)
    yield from _yokes(mark, (start, end), angle)
    yield from _strength(mark, (start, end), angle)


@_drawn.register
def _dashpot(mark: Dashpot, scale: Scale) -> Iterator[Piece]:
    start, end, angle = _held(mark, scale)
    length = math.dist(start, end)
    low, high, wide = length * 0.35, length * 0.65, 7.0
    cup = [(high, wide), (low, wide), (low, -wide), (high, -wide)]
    kind, piston = LATER if mark.later else "spring", length * 0.5
    yield Stroke((start, moved(start, angle, low)), kind)
    yield Stroke(tuple(moved(start, angle, a, b) for a, b in cup), kind)
    yield Stroke((moved(start, angle, piston, wide - 2), moved(start, angle, piston, 2 - wide)), kind)
    yield Stroke((moved(start, angle, piston), end), kind)
    yield from _yokes(mark, (start, end), angle)
    yield from _strength(mark, (start, end), angle)


def _strength(mark: Coil | Dashpot, ends: tuple[Spot, Spot], angle: float) -> Iterator[Piece]:
    """The letter of a spring or damper, beside its middle and away from one that lies beside it."""
    side = -1 if mark.lane < 0 else 1
    middle = ((ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2)
    out = angle + side * math.pi / 2
    yield Words(runs_of(mark.words), middle, "measure", (out, out + math.pi), STRENGTH)


def _held(mark: Coil | Dashpot, scale: Scale) -> tuple[Spot, Spot, float]:
    """Where a spring or damper begins and ends, and its direction."""
    start, end = scale.spot(mark.start), scale.spot(mark.end)
    angle, side = math.atan2(start[1] - end[1], end[0] - start[0]), mark.aside + mark.lane
    short = math.dist(start, end) > 2 * sum(mark.cuts)
    first, last = mark.cuts if short else (0.0, 0.0)
    return moved(start, angle, first, side), moved(end, angle, -last, side), angle


def _yokes(mark: Coil | Dashpot, ends: tuple[Spot, Spot], angle: float) -> Iterator[Piece]:
    """What joins one to another one beside it, at either end."""
    if mark.lane:
        kind = LATER if mark.later else "spring"
        yield from (Stroke((end, moved(end, angle, 0, -mark.lane)), kind) for end in ends)


@_drawn.register
def _slot(mark: Slot, scale: Scale) -> Iterator[Piece]:
    yield from slot(scale.spot(mark.start), scale.spot(mark.end), mark.angle, mark.fixed)


@_drawn.register
def _symbol(mark: Symbol, scale: Scale) -> Iterator[Piece]:
    yield from sign(mark, moved(scale.spot(mark.at), mark.angle, 0.0, mark.aside))


@_drawn.register
def _arrow(mark: Arrow, scale: Scale) -> Iterator[Piece]:
    at, length = moved(scale.spot(mark.at), mark.angle, 0.0, mark.aside), ARROW * mark.reach
    tail, tip = (moved(at, mark.angle, -length), at) if mark.inward else (at, moved(at, mark.angle, length))
    yield from pointed((tail, tip), mark.style, " dashed" if mark.assumed else "")
    outer = tail if mark.inward else tip
    words = _words(mark, outer, mark.angle + (math.pi if mark.inward else 0.0), mark.style)
    # Beside another one it has its words on its own side.
    off = mark.angle + math.copysign(math.pi / 2, mark.aside)
    yield replace(words, angles=(off,)) if mark.aside else words


def _words(mark: Any, anchor: Spot, angle: float, kind: str) -> Words:
    """Words at the end of something, beyond it or beside."""
    angles = (angle, angle + 0.7, angle - 0.7, angle + math.pi / 2, angle - math.pi / 2)
    return Words(runs_of(mark.words), anchor, kind, angles)


@_drawn.register
def _span(mark: Span, scale: Scale) -> Iterator[Piece]:
    start, end = scale.spot(mark.start), scale.spot(mark.end)
    if math.dist(start, end) < 1.0:
        return
    angle = math.atan2(start[1] - end[1], end[0] - start[0])
    start, end = (moved(spot, angle, 0.0, mark.aside) for spot in (start, end))
    yield from pointed((start, end), mark.style)
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    sides = (angle + math.pi / 2, angle - math.pi / 2)
    yield Words(runs_of(mark.words), middle, mark.style, sides, 4.0)


def _with_room(marks: Sequence[Mark], scale: Scale) -> Iterator[Mark]:
    """The marks, each couple with an arc of its own: not on a rim or hub about its place, nor on the arc of another."""
    rims = [(m.center, m.radius * scale.pixels) for m in marks if isinstance(m, Arc)]
    for mark in marks:
        if isinstance(mark, Turn):
            near = [r for center, r in rims if math.dist(scale.spot(center), scale.spot(mark.at)) < 2.0]
            radius = next((c for c in COUPLES if all(abs(c - r) >= CLEAR for r in near)), COUPLES[-1])
            rims.append((mark.at, radius))
            yield replace(mark, radius=radius)
        else:
            yield mark


@_drawn.register
def _turn(mark: Turn, scale: Scale) -> Iterator[Piece]:
    at, radius = scale.spot(mark.at), mark.radius or COUPLES[0]
    places = arc(at, radius, math.radians(-60 if mark.sense > 0 else 240), mark.sense * math.radians(270))
    yield from pointed(places, mark.style)
    yield _words(mark, moved(at, math.pi / 2, radius), math.pi / 2, mark.style)


def _beside(level: Sequence[Dimension], frame: Box, scale: Scale) -> Iterator[Piece]:
    """Dimensions along an axis: those along x below everything, those along y on the left, short ones nearest; those
    that do not lie side by side each in a row of its own.
    """
    rows: dict[tuple[bool, int], list[tuple[float, float]]] = {}
    for mark in sorted(level, key=lambda m: math.dist(m.start, m.end)):
        start, end = scale.spot(mark.start), scale.spot(mark.end)
        across = abs(end[0] - start[0]) >= abs(end[1] - start[1])
        low, high = sorted((start[0], end[0]) if across else (start[1], end[1]))
        row = 0
        while any(low < b - 1 and a < high - 1 for a, b in rows.get((across, row), ())):
            row += 1
        rows.setdefault((across, row), []).append((low, high))
        away = ASIDE + ROW * row
        aside = frame.bottom + away - end[1] if across else end[0] - frame.left + away
        # On paper the way from left to right has what is below on its right, the way upward what is left on its left.
        side = (-1 if end[0] > start[0] else 1) if across else (1 if end[1] < start[1] else -1)
        yield from _measured(mark, (start, end), side * aside)


@_drawn.register
def _dimension(mark: Dimension, scale: Scale) -> Iterator[Piece]:
    yield from _measured(mark, (scale.spot(mark.start), scale.spot(mark.end)), _away(mark))


def _away(mark: Dimension) -> float:
    """How far on the left of its way a dimension line lies, px."""
    return (ASIDE + ROW * mark.row) * mark.side


def in_rows(marks: Iterable[Mark], scale: Scale) -> list[Mark]:
    """The marks, of dimensions that would lie on one line the longer ones farther out."""
    told = list(marks)
    found: list[tuple[Spot, Spot]] = []
    aslant = [(m, i) for i, m in enumerate(told) if isinstance(m, Dimension) and m.side and not m.level]
    for mark, i in sorted(aslant, key=lambda entry: math.dist(entry[0].start, entry[0].end)):
        own = mark
        while any(_on_each_other(_ends(own, scale), other) for other in found):
            own = replace(own, row=own.row + 1)
        found.append(_ends(own, scale))
        told[i] = own
    return told


def _ends(mark: Dimension, scale: Scale) -> tuple[Spot, Spot]:
    """Of a dimension line, on paper."""
    start, end = scale.spot(mark.start), scale.spot(mark.end)
    angle = math.atan2(start[1] - end[1], end[0] - start[0])
    return moved(start, angle, 0.0, _away(mark)), moved(end, angle, 0.0, _away(mark))


def _on_each_other(one: tuple[Spot, Spot], other: tuple[Spot, Spot]) -> bool:
    """Do two lines have a part in common?"""
    (x, y), length = one[0], math.dist(*one)
    if length < 2.0:
        return False
    along = ((one[1][0] - x) / length, (one[1][1] - y) / length)
    ways = [((u - x) * along[0] + (v - y) * along[1], (v - y) * along[0] - (u - x) * along[1]) for u, v in other]
    (low, _), (high, _) = sorted(ways)
    return all(abs(aside) < ROW / 4 for _, aside in ways) and low < length - 1.0 and high > 1.0


def _measured(mark: Dimension, places: tuple[Spot, Spot], aside: float) -> Iterator[Piece]:
    """A dimension line so far on the left of the way from place to place, with its words in a gap of it where it is
    long enough; 0: an arrow on the way itself.
    """
    start, end = places
    length = math.dist(start, end)
    if length < 2.0:
        return
    angle, side = math.atan2(start[1] - end[1], end[0] - start[0]), (aside > 0) - (aside < 0)
    ends = (moved(start, angle, 0, aside), moved(end, angle, 0, aside))
    middle = ((ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2)
    out = angle + math.pi / 2 * (side or 1)
    told = Words(runs_of(mark.words), middle, "measure", (out, out + math.pi), 3.0)
    gap = _gap(told, angle) if side else 0.0
    gap = gap if length > 2 * (gap + LEFT) else 0.0
    if side:
        for place, beside in zip((start, end), ends, strict=True):
            over = moved(beside, angle, 0, 4 * side)
            yield Stroke((moved(place, angle, 0, 4 * side), over), EXTENSION)
    yield from _ticked(ends, angle, both=bool(side), gap=gap)
    if mark.broken:
        yield from sign(Symbol("break", (0.0, 0.0), angle), moved(middle, angle, (length / 2 + gap) / 2))
    yield replace(told, within=gap > 0)


def _gap(words: Words, angle: float) -> float:
    """Half the length of a line in some direction that words in its middle cover."""
    wide, high = words.width / 2 + 3.0, words.height / 2 + 2.0
    return min(wide / max(abs(math.cos(angle)), 1e-9), high / max(abs(math.sin(angle)), 1e-9))


def _ticked(ends: tuple[Spot, Spot], angle: float, both: bool, gap: float = 0.0) -> Iterator[Piece]:
    """A line with heads, and a gap so far on either side of its middle."""
    half = math.dist(*ends) / 2
    if gap:
        yield Stroke((ends[0], moved(ends[0], angle, half - gap)), "measure")
        yield Stroke((moved(ends[1], angle, gap - half), ends[1]), "measure")
    else:
        yield Stroke(ends, "measure")
    for tip, way in ((ends[1], angle), *(((ends[0], angle + math.pi),) if both else ())):
        # No more than half of what it measures.
        yield _head(tip, way, min(1.0, half / HEAD[0]))


def _head(tip: Spot, way: float, part: float = 1.0) -> Stroke:
    """The small head of a dimension; `part`: of its usual size."""
    back, aside = HEAD[0] * part, HEAD[1] * part
    return Stroke((tip, moved(tip, way, -back, aside), moved(tip, way, -back, -aside)), "measure head", True)


@_drawn.register
def _angle(mark: Angle, scale: Scale) -> Iterator[Piece]:
    at, radius = moved(scale.spot(mark.vertex), 0.0, *mark.shift), mark.radius or VERTEX
    yield Stroke((at, moved(at, mark.start, radius + VERTEX * 0.35)), "measure dashed")
    yield Stroke(arc(at, radius, mark.start, mark.sweep), "measure")
    middle = mark.start + mark.sweep / 2
    end = mark.start + mark.sweep
    yield _head(moved(at, end, radius), end + math.copysign(math.pi / 2, mark.sweep))
    yield Words(runs_of(mark.words), moved(at, middle, radius), "measure", (middle,), 4.0)


@_drawn.register
def _tag(mark: Tag, scale: Scale) -> Iterator[Piece]:
    angles = tuple(map(math.radians, (45, 135, -45, -135)))
    yield Words(runs_of(mark.words), scale.spot(mark.at), "name", angles, 6.0)


@_drawn.register
def _graph(mark: Graph, scale: Scale) -> Iterator[Piece]:
    yield from graph_pieces(mark)


def world_box(panel: Panel) -> tuple[float, float]:
    """Width and height of what a panel draws to scale, m."""
    spots = [s for mark in panel.marks for s in spots_of(mark)]
    if not spots:
        return 0.0, 0.0
    xs, ys = zip(*spots, strict=True)
    return max(max(xs) - min(xs), panel.least), max(max(ys) - min(ys), panel.least)
