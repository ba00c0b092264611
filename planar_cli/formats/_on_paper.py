"""Marks of a figure on paper: what has a size there alone, such as arrows, hatching and signs, gets it here."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import singledispatch
from itertools import pairwise
from typing import Any

from planar_cli.formats._graph import graph_pieces
from planar_cli.formats._paper import Box, Disc, Paper, Run, Spot, Stroke, Words, along, box_of, runs_of
from planar_cli.records import record
from planar_cli.report.blocks import Line
from planar_cli.report.graphs import Graph
from planar_cli.report.marks import (
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
    Span,
    Symbol,
    Tag,
    Turn,
    spots_of,
)

ARROW, HEAD, WING = 46.0, 9.0, 3.6
"""The length of an arrow, and of its head and half its width."""
TICK, EVERY = 7.0, 7.0
"""Hatching."""
BLOCK = 26.0
SLIDER = (24.0, 14.0)
HANGER = 24.0
ASIDE = 18.0
"""How far a dimension is drawn beside what it measures."""
VERTEX = 26.0
"""The radius of the arc of an angle."""
COUPLE = 17.0
AXIS, APART = 30.0, 62.0
"""The length of an axis, and how far the axes are beside everything."""
STEP = math.radians(6)
LATER, WAY = "hidden", "way"
"""The style of a position that a body has later, its outline alone, and of the way there."""
Piece = Stroke | Disc | Words


@record
class Scale:
    """How metres become pixels: x right, y downward."""

    pixels: float
    """Of one metre."""

    def spot(self, place: Spot) -> Spot:
        return place[0] * self.pixels, -place[1] * self.pixels


def on_paper(panel: Panel, scale: Scale) -> Paper:
    """A panel on paper, with words that have no places yet."""
    level = [m for m in panel.marks if isinstance(m, Dimension) and m.level]
    axes = [m for m in panel.marks if isinstance(m, Axes)]
    inner = [m for m in panel.marks if not isinstance(m, Axes) and m not in level]
    pieces = [piece for mark in inner for piece in _drawn(mark, scale)]
    frame = box_of(spot for p in pieces if isinstance(p, Stroke | Disc) for spot in along(p, 8.0))
    pieces += _beside(level, frame or Box(0.0, 0.0, 0.0, 0.0), scale)
    whole = box_of(spot for p in pieces if isinstance(p, Stroke | Disc) for spot in along(p, 8.0))
    if whole is not None:
        pieces += [p for mark in axes for p in _axes(mark, (whole.left - APART, whole.bottom))]
    # What is somewhere only later lies below all that is there.
    strokes = sorted((p for p in pieces if isinstance(p, Stroke | Disc)), key=lambda s: s.kind not in (LATER, WAY))
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


def moved(start: Spot, angle: float, ahead: float, left: float = 0.0) -> Spot:
    """On paper: the place `ahead` in a direction (counterclockwise as seen), and `left` of it."""
    cos, sin = math.cos(angle), math.sin(angle)
    return start[0] + ahead * cos - left * sin, start[1] - ahead * sin - left * cos


@singledispatch
def _drawn(mark: Any, scale: Scale) -> Iterator[Piece]:
    raise TypeError(type(mark).__name__)


@_drawn.register
def _polyline(mark: Polyline, scale: Scale) -> Iterator[Piece]:
    filled = mark.closed and mark.style != LATER
    kind = f"{mark.style} area" if filled else f"{mark.style} bar" if mark.style == "body" else mark.style
    yield Stroke(tuple(map(scale.spot, mark.places)), kind, mark.closed)


@_drawn.register
def _arc(mark: Arc, scale: Scale) -> Iterator[Piece]:
    center, radius = scale.spot(mark.center), mark.radius * scale.pixels
    if abs(mark.sweep) >= 2 * math.pi - 1e-9:
        yield Disc(center, radius, mark.style if mark.style == LATER else f"{mark.style} area")
    else:
        yield Stroke(arc(center, radius, mark.start, mark.sweep), mark.style)


def arc(center: Spot, radius: float, start: float, sweep: float) -> tuple[Spot, ...]:
    """Places along an arc on paper, angles counterclockwise as seen."""
    count = max(int(abs(sweep) / STEP), 2)
    return tuple(moved(center, start + sweep * i / count, radius) for i in range(count + 1))


@_drawn.register
def _hatched(mark: Hatched, scale: Scale) -> Iterator[Piece]:
    places = tuple(map(scale.spot, mark.places))
    yield Stroke(places, "ground")
    yield from hatching(places)


def hatching(places: tuple[Spot, ...], right: float = 1.0) -> Iterator[Piece]:
    """Short strokes on the right of the way along some places, or on the left (-1)."""
    rest = EVERY / 2
    for (x0, y0), (x1, y1) in pairwise(places):
        length = math.hypot(x1 - x0, y1 - y0)
        angle = math.atan2(-(y1 - y0), x1 - x0)
        while rest < length:
            at = moved((x0, y0), angle, rest)
            yield Stroke((at, moved(at, angle, -TICK * 0.7, -TICK * right)), "hatch")
            rest += EVERY
        rest -= length


@_drawn.register
def _coil(mark: Coil, scale: Scale) -> Iterator[Piece]:
    start, end = scale.spot(mark.start), scale.spot(mark.end)
    length, angle = math.hypot(end[0] - start[0], end[1] - start[1]), math.atan2(start[1] - end[1], end[0] - start[0])
    lead, turns = length * 0.14, max(min(int((mark.like * scale.pixels or length) / 9), 12), 4)
    inner = length - 2 * lead
    zigzag = [moved(start, angle, lead + inner * (i + 0.5) / (2 * turns), 6.0 * (-1) ** i) for i in range(2 * turns)]
    yield Stroke((start, moved(start, angle, lead), *zigzag, moved(start, angle, length - lead), end), "spring")


@_drawn.register
def _dashpot(mark: Dashpot, scale: Scale) -> Iterator[Piece]:
    start, end = scale.spot(mark.start), scale.spot(mark.end)
    length, angle = math.hypot(end[0] - start[0], end[1] - start[1]), math.atan2(start[1] - end[1], end[0] - start[0])
    low, high, wide = length * 0.35, length * 0.65, 7.0
    cup = [(high, wide), (low, wide), (low, -wide), (high, -wide)]
    yield Stroke((start, moved(start, angle, low)), "spring")
    yield Stroke(tuple(moved(start, angle, a, b) for a, b in cup), "spring")
    piston = length * 0.5
    yield Stroke((moved(start, angle, piston, wide - 2), moved(start, angle, piston, 2 - wide)), "spring")
    yield Stroke((moved(start, angle, piston), end), "spring")


@_drawn.register
def _symbol(mark: Symbol, scale: Scale) -> Iterator[Piece]:
    at = scale.spot(mark.at)
    match mark.kind:
        case "pin":
            yield Disc(at, 3.6, "pin")
        case "support":
            feet = (moved(at, 0, -10, -16), moved(at, 0, 10, -16))
            yield Stroke((feet[0], at, feet[1]), "support area", True)
            base = (moved(feet[0], 0, -5), moved(feet[1], 0, 5))
            yield Stroke(base, "ground")
            yield from hatching(base)
            yield Disc(at, 3.6, "pin")
        case "particle":
            yield Disc(at, 5.0, "mass")
        case "block":
            corners = ((-0.5, 0.0), (0.5, 0.0), (0.5, 0.8), (-0.5, 0.8))
            yield Stroke(tuple(moved(at, mark.angle, a * BLOCK, b * BLOCK) for a, b in corners), "body area", True)
        case "slider" | "rail":
            yield from _slider(at, mark.angle, mark.kind == "rail")
        case "weld":
            yield Stroke(tuple(moved(at, 0, a, b) for a, b in ((-4, -4), (4, -4), (4, 4), (-4, 4))), "mass area", True)
        case "centre":
            yield Disc(at, 4.5, "centre")
            yield Stroke((moved(at, 0, -7), moved(at, 0, 7)), "centre")
            yield Stroke((moved(at, 0, 0, -7), moved(at, 0, 0, 7)), "centre")
        case "point":
            yield Disc(at, 1.8, "dot")
        case "place":
            yield Disc(at, 5.0, LATER)
        case "break":
            for ahead in (-3.0, 3.0):
                yield Stroke((moved(at, mark.angle, ahead - 3, -8), moved(at, mark.angle, ahead + 3, 8)), "thin")
        case "hanger":
            yield from _hanger(at, mark.angle)
        case "wall":
            wall = (moved(at, mark.angle, 0, -11), moved(at, mark.angle, 0, 11))
            yield Stroke(wall, "ground")
            yield from hatching(wall, -1)


def _hanger(at: Spot, angle: float) -> Iterator[Piece]:
    """What holds a wheel: a bar from its axle to a fixed edge, in a direction."""
    yield Stroke((at, moved(at, angle, HANGER)), "spring")
    edge = (moved(at, angle, HANGER, 11), moved(at, angle, HANGER, -11))
    yield Stroke(edge, "ground")
    yield from hatching(edge, -1)
    yield Disc(at, 2.6, "pin")


def _slider(at: Spot, angle: float, fixed: bool) -> Iterator[Piece]:
    """A box; on a fixed rail with the rail on both sides of it."""
    half = SLIDER[0] / 2, SLIDER[1] / 2
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    for side in (1, -1) if fixed else ():
        rail = tuple(moved(at, angle, a * 2.1 * half[0], side * (half[1] + 2)) for a in (-1, 1))
        yield Stroke(rail, "ground")
        yield from hatching(rail, -side)
    yield Stroke(tuple(moved(at, angle, a * half[0], b * half[1]) for a, b in corners), "body area", True)
    yield Disc(at, 2.6, "pin")


@_drawn.register
def _arrow(mark: Arrow, scale: Scale) -> Iterator[Piece]:
    at, length = scale.spot(mark.at), ARROW * mark.reach
    tail, tip = (moved(at, mark.angle, -length), at) if mark.inward else (at, moved(at, mark.angle, length))
    yield from pointed((tail, tip), mark.style)
    outer = tail if mark.inward else tip
    yield _words(mark, outer, mark.angle + (math.pi if mark.inward else 0.0), mark.style)


def pointed(places: tuple[Spot, ...], kind: str) -> Iterator[Piece]:
    """A line with an arrow head at its end."""
    (x0, y0), tip = places[-2:]
    angle = math.atan2(y0 - tip[1], tip[0] - x0)
    neck = moved(tip, angle, -HEAD * 0.8)
    yield Stroke((*places[:-1], neck), kind)
    yield Stroke((tip, moved(tip, angle, -HEAD, WING), moved(tip, angle, -HEAD, -WING)), f"{kind} head", True)


def _words(mark: Any, anchor: Spot, angle: float, kind: str) -> Words:
    """Words at the end of something, beyond it or beside."""
    angles = (angle, angle + 0.7, angle - 0.7, angle + math.pi / 2, angle - math.pi / 2)
    return Words(runs_of(mark.words), anchor, kind, angles)


@_drawn.register
def _span(mark: Span, scale: Scale) -> Iterator[Piece]:
    start, end = scale.spot(mark.start), scale.spot(mark.end)
    if math.dist(start, end) < HEAD:
        return
    yield from pointed((start, end), mark.style)
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    angle = math.atan2(start[1] - end[1], end[0] - start[0])
    sides = (angle + math.pi / 2, angle - math.pi / 2)
    yield Words(runs_of(mark.words), middle, mark.style, sides, 4.0)


@_drawn.register
def _turn(mark: Turn, scale: Scale) -> Iterator[Piece]:
    at = scale.spot(mark.at)
    places = arc(at, COUPLE, math.radians(-60 if mark.sense > 0 else 240), mark.sense * math.radians(270))
    yield from pointed(places, mark.style)
    yield _words(mark, moved(at, math.pi / 2, COUPLE), math.pi / 2, mark.style)


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
        away = ASIDE * (1 + row)
        aside = frame.bottom + away - end[1] if across else end[0] - frame.left + away
        # On paper the way from left to right has what is below on its right, the way upward what is left on its left.
        side = (-1 if end[0] > start[0] else 1) if across else (1 if end[1] < start[1] else -1)
        yield from _measured(mark.words, (start, end), side * aside)


@_drawn.register
def _dimension(mark: Dimension, scale: Scale) -> Iterator[Piece]:
    yield from _measured(mark.words, (scale.spot(mark.start), scale.spot(mark.end)), ASIDE * mark.side)


def _measured(words: Line, places: tuple[Spot, Spot], aside: float) -> Iterator[Piece]:
    """A dimension line so far on the left of the way from place to place; 0: an arrow on the way itself."""
    start, end = places
    length = math.dist(start, end)
    if length < 2.0:
        return
    angle, side = math.atan2(start[1] - end[1], end[0] - start[0]), (aside > 0) - (aside < 0)
    ends = (moved(start, angle, 0, aside), moved(end, angle, 0, aside))
    if side:
        for place, beside in zip((start, end), ends, strict=True):
            over = moved(beside, angle, 0, 4 * side)
            yield Stroke((moved(place, angle, 0, 4 * side), over), "measure")
        yield from _ticked(ends, angle, both=True)
    else:
        yield from _ticked(ends, angle, both=False)
    middle = ((ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2)
    out = angle + math.pi / 2 * (side or 1)
    yield Words(runs_of(words), middle, "measure", (out, out + math.pi), 3.0)


def _ticked(ends: tuple[Spot, Spot], angle: float, both: bool) -> Iterator[Piece]:
    yield Stroke(ends, "measure")
    for tip, way in ((ends[1], angle), *(((ends[0], angle + math.pi),) if both else ())):
        head = (tip, moved(tip, way, -6.5, 2.2), moved(tip, way, -6.5, -2.2))
        yield Stroke(head, "measure head", True)


@_drawn.register
def _angle(mark: Angle, scale: Scale) -> Iterator[Piece]:
    at = scale.spot(mark.vertex)
    yield Stroke((at, moved(at, mark.start, VERTEX * 1.35)), "measure dashed")
    yield Stroke(arc(at, VERTEX, mark.start, mark.sweep), "measure")
    middle = mark.start + mark.sweep / 2
    tip, way = (
        moved(at, mark.start + mark.sweep, VERTEX),
        mark.start + mark.sweep + math.copysign(math.pi / 2, mark.sweep),
    )
    yield Stroke((tip, moved(tip, way, -6.5, 2.2), moved(tip, way, -6.5, -2.2)), "measure head", True)
    yield Words(runs_of(mark.words), moved(at, middle, VERTEX), "measure", (middle,), 4.0)


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
