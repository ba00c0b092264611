"""Graphs on paper: axes with ticks at round numbers, curves, and dots with their names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from planar_cli.formats._paper import Disc, Run, Spot, Stroke, Words, runs_of
from planar_cli.records import record
from planar_cli.report.document.graphs import Curve, Graph, Scaled
from planar_cli.report.document.lines import Line, line
from planar_cli.report.notation.numbers import superscript

PITCH = 74.0
"""What stands above and below the field of a graph, where several stand over each other."""
TICK = 4.0
LEAST_ACROSS, LEAST_UP, ROOM = 45.0, 27.0, 0.6
"""So far apart are ticks at least; letters in these parts of it."""
STEPS = (1.0, 2.0, 5.0, 10.0)
LARGE, SMALL = 1e5, 1e-3
"""Numbers beyond these have a power of ten at the axis."""
COLOURS = 5
"""As many as a ledger of energy has accounts."""
RIGHT, UP, LEFT, DOWN = 0.0, math.pi / 2, math.pi, -math.pi / 2
FLAT, JUMP = 0.08, 0.5
"""How far a curve may be off where it is drawn; so far apart two pieces are joined by a thin line, which is no part of
it (pixels).
"""
Piece = Stroke | Disc | Words


@record
class Ticked:
    """An axis with its ticks: the range that is drawn, and where numbers stand."""

    low: float
    high: float
    ticks: tuple[float, ...]
    step: float
    power: int
    """Of ten, by which the numbers at the ticks are to be multiplied."""
    powers: bool = False
    """Are the numbers exponents of ten?"""
    letters: tuple[Line, ...] = ()
    """What stands at the ticks instead of numbers."""

    def words(self, tick: float) -> Line:
        """What stands at a tick."""
        return self.letters[self.ticks.index(tick)] if self.letters else line(self.told(tick))

    def told(self, tick: float) -> str:
        """The number at a tick."""
        if self.powers:
            return f"10{superscript(str(round(tick)))}" if round(tick) else "1"
        decimals = max(0, -math.floor(math.log10(self.step) - self.power + 1e-9))
        text = f"{tick / 10.0**self.power:.{decimals}f}"
        return "0" if not float(text) else text.replace("-", "−")


def ticked(low: float, high: float, most: int, tight: bool = False) -> Ticked:
    """Round ticks for a range; `tight`: it ends where the curves do, else at the next tick beyond."""
    if high - low <= 1e-12 * max(abs(low), abs(high), 1e-300):
        # What is constant lies in the middle.
        beside = abs(low) / 2 or 1.0
        low, high = low - beside, high + beside
    step = _round((high - low) / most)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    if tight:
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    else:
        low, high = first * step, last * step
    largest = max(abs(low), abs(high))
    power = 3 * math.floor(math.log10(largest) / 3) if largest >= LARGE or largest < SMALL else 0
    return Ticked(low, high, tuple(k * step for k in range(first, last + 1)), step, power)


def scaled_ticks(axis: Scaled, most: int, tight: bool = False) -> Ticked:
    """The ticks of an axis; of powers of ten the axis ends at whole ones, letters stand where there is room."""
    if axis.letters:
        kept: list[tuple[float, Line]] = []
        for place, words in axis.letters:
            if all(abs(place - other) >= ROOM * (axis.high - axis.low) / most for other, _ in kept):
                kept.append((place, words))
        return Ticked(axis.low, axis.high, tuple(p for p, _ in kept), 1.0, 0, letters=tuple(w for _, w in kept))
    if not axis.powers:
        return ticked(axis.low, axis.high, most, tight)
    low, high = math.floor(axis.low + 1e-9), math.ceil(axis.high - 1e-9)
    high = max(high, low + 1)
    step = math.ceil((high - low) / most)
    return Ticked(low, high, tuple(range(high, low - 1, -step))[::-1], step, 0, powers=True)


def _round(least: float) -> float:
    """1, 2 or 5 times a power of ten, not below this."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(power * s for s in STEPS if power * s >= least * (1 - 1e-9))


@record
class Field:
    """Where the field of a graph lies on paper."""

    across: Ticked
    up: Ticked
    width: float
    height: float
    top: float = 0.0

    def spot(self, at: Spot) -> Spot:
        """Where a place of the graph is, from the left and from above."""
        x = (at[0] - self.across.low) / (self.across.high - self.across.low)
        y = (at[1] - self.up.low) / (self.up.high - self.up.low)
        return x * self.width, self.top + (1 - y) * self.height


def graph_pieces(mark: Graph) -> Iterator[Piece]:
    """Axes, curves and dots of a graph, with the words at them."""
    field = _field(mark)
    yield from _axes(mark, field)
    own = [c for c in mark.curves if not c.faint]
    for curves in (own, [c for c in mark.curves if c.faint]):
        for i, curve in enumerate(curves):
            look = "total" if curve.total else f"c{i % COLOURS}"
            yield from _curve(curve, look, field, len(own) > 1)
    for dot in mark.dots:
        at = field.spot(dot.at)
        yield Disc(at, 3.2, "pin")
        yield Words(runs_of(dot.words), at, "name", (UP - 0.6, UP, UP + 0.6), 6.0)


def _field(mark: Graph) -> Field:
    width, height = mark.size
    across, up = _ticks(mark, width, height)
    if mark.equal:
        for _ in range(2):
            # With fewer ticks along the shorter side it may be a little longer.
            pixels = min(mark.size[0] / (across.high - across.low), mark.size[1] / (up.high - up.low))
            width, height = pixels * (across.high - across.low), pixels * (up.high - up.low)
            across, up = _ticks(mark, width, height)
        pixels = min(mark.size[0] / (across.high - across.low), mark.size[1] / (up.high - up.low))
        width, height = pixels * (across.high - across.low), pixels * (up.high - up.low)
    return Field(across, up, width, height, mark.row * (mark.size[1] + PITCH))


def _ticks(mark: Graph, width: float, height: float) -> tuple[Ticked, Ticked]:
    """As many ticks as there is room for."""
    many = max(1, int(width / LEAST_ACROSS)), max(1, int(height / LEAST_UP))
    return (
        scaled_ticks(mark.across, many[0], tight=not mark.equal),
        scaled_ticks(mark.up, many[1]),
    )


def _axes(mark: Graph, field: Field) -> Iterator[Piece]:
    left, top, right, bottom = 0.0, field.top, field.width, field.top + field.height
    yield Stroke(((left, bottom), (right, bottom)), "measure")
    yield Stroke(((left, bottom), (left, top)), "measure")
    for tick in field.across.ticks:
        x, _ = field.spot((tick, field.up.low))
        yield Stroke(((x, bottom), (x, top)), "grid")
        yield Stroke(((x, bottom), (x, bottom + TICK)), "measure")
        yield _number(field.across.words(tick), (x, bottom + TICK), DOWN)
    for tick in field.up.ticks:
        _, y = field.spot((field.across.low, tick))
        zero = tick == 0 and bottom - y > 1
        yield Stroke(((left, y), (right, y)), "measure" if zero else "grid")
        yield Stroke(((left - TICK, y), (left, y)), "measure")
        yield _number(field.up.words(tick), (left - TICK, y), LEFT)
    yield Words(_measured(mark.across, field.across.power), (right, bottom - 4.0), "axis", (RIGHT,), 14.0, fixed=True)
    yield Words(_measured(mark.up, field.up.power), (left, top), "axis", (UP,), 11.0, fixed=True)


def _number(words: Line, at: Spot, angle: float) -> Words:
    # At the corner the first numbers of both axes stand near each other.
    return Words(runs_of(words), at, "axis", (angle,), 5.0 if angle == DOWN else 3.0, fixed=True)


def _measured(axis: Scaled, power: int) -> tuple[Run, ...]:
    told = in_unit(axis.unit, power)
    return (*runs_of(axis.words), *((Run(told),) if told else ()))


def in_unit(unit: str, power: int) -> str:
    """What stands behind v and F at an axis: ` in m/s`, ` in 10⁶ N`; "" behind a pure number."""
    told = " ".join(p for p in (f"10{superscript(str(power))}" if power else "", unit) if p)
    return f" in {told}" if told else ""


def _curve(curve: Curve, look: str, field: Field, named: bool) -> Iterator[Piece]:
    kind = f"curve {look}" + (" dashed" if curve.faint else "")
    pieces = [tuple(map(field.spot, piece)) for piece in curve.pieces if piece]
    for before, after in pairwise(pieces):
        if math.dist(before[-1], after[0]) > JUMP:
            yield Stroke((before[-1], after[0]), f"curve {look} jump")
    for piece in pieces:
        if len(piece) > 1:
            yield Stroke(_thinned(piece), kind)
        else:
            yield Disc(piece[0], 1.2, f"curve {look} dot")
        if curve.marked:
            yield from (Disc(spot, 2.6, f"curve {look} pin") for spot in piece)
    if named and pieces:
        yield Words(runs_of(curve.words), pieces[-1][-1], look, (RIGHT, RIGHT + 0.5, RIGHT - 0.5, UP), 4.0)


def _thinned(places: Sequence[Spot]) -> tuple[Spot, ...]:
    """As few of these places as leave none farther than `FLAT` from the line (Ramer; Douglas and Peucker)."""
    kept, waiting = {0, len(places) - 1}, [(0, len(places) - 1)]
    while waiting:
        first, last = waiting.pop()
        inner = range(first + 1, last)
        if not inner:
            continue
        off, k = max((_off(places[i], places[first], places[last]), i) for i in inner)
        if off > FLAT:
            kept.add(k)
            waiting += [(first, k), (k, last)]
    return tuple(places[i] for i in sorted(kept))


def _off(at: Spot, start: Spot, end: Spot) -> float:
    """How far a place is from the stroke between two others."""
    (x0, y0), (x1, y1) = start, end
    length = math.hypot(x1 - x0, y1 - y0)
    if length < 1e-9:
        return math.dist(at, start)
    return abs((at[0] - x0) * (y1 - y0) - (at[1] - y0) * (x1 - x0)) / length
