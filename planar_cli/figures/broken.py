"""A long stretch on which nothing lies is drawn shorter, with the sign of a break on each line along it.

A rope of 30 m makes a drum of 0.3 m a dot. So a drawing whose smallest body or distance could not be read is cut
across where only straight lines along one direction pass: ropes, floors, ways, dimensions. What lies beyond the cut
moves nearer as a whole; all bodies, all angles, and all lengths but those along the broken lines stay to scale.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise

from planar_cli.figures.shapes import moved
from planar_cli.records import record
from planar_cli.report.document.lines import line
from planar_cli.report.document.marks import (
    Angle,
    Arc,
    Arrow,
    Coil,
    Dashpot,
    Dimension,
    Figure,
    Hatched,
    Mark,
    Panel,
    Polyline,
    Span,
    Spot,
    Symbol,
    Tag,
    Turn,
    spots_of,
)

PAPER = (4.0, 3.0)
"""Width and height of a sheet; what follows is in the same unit."""
SMALL, GOOD = 0.24, 0.6
"""What is smaller cannot be read; so large it is drawn then, if that is possible."""
LEAST, PART = 0.45, 0.6
"""The least length of a broken line, and of all of them together in parts of what else lies along them."""
BESIDE = 1.7
"""The least length of a broken line with arrows along it."""
WORTH = 1.4
"""A break that makes the drawing no more than so many times as large is none."""
LINES = ("rope", "way", "ground", "dashed")
"""The styles of lines that may be broken."""
NEAR = 1e-6
NOT_TO_SCALE = "not to scale along the broken lines"
Move = Callable[[Spot], Spot]


def scene(panel: Panel, title: str) -> Figure:
    """The figure of a scene, which tells where it is not to scale."""
    marks = broken(panel.marks)
    note = line(NOT_TO_SCALE) if _is_cut(marks) else ()
    return Figure((replace(panel, marks=marks),), title, name="scene", note=note)


def broken_together(panels: Sequence[Panel]) -> tuple[tuple[Panel, ...], bool]:
    """Drawings of the same bodies, all broken alike where a rope is long; and whether they are."""
    whole = [m for panel in panels for m in panel.marks]
    roped = any(isinstance(m, Polyline) and m.style == "rope" for m in whole)
    marks = broken(whole, min(len(panels) * SMALL, GOOD), BESIDE) if roped else whole
    if not _is_cut(marks):
        return tuple(panels), False
    made, since, signs = list[Panel](), 0, tuple(marks[len(whole) :])
    for panel in panels:
        until = since + len(panel.marks)
        made.append(replace(panel, marks=(*marks[since:until], *signs)))
        since = until
    return tuple(made), True


def _is_cut(marks: Sequence[Mark]) -> bool:
    return any(isinstance(m, Symbol) and m.kind == "break" for m in marks)


def broken(marks: Sequence[Mark], small: float = SMALL, least: float = LEAST) -> tuple[Mark, ...]:
    """The marks of a drawing, some of them nearer to each other if it could not be read otherwise. `small`: what is
    smaller cannot be read; `least`: the least length of a broken line.
    """
    # While it is worked out, a rope as it is later is a line like that which is there.
    found = before = tuple(_with_later_ropes(marks))
    angles = _directions(found)
    while angles and (smallest := min(_sizes(found), default=math.inf)) * (scale := _scale(found)) < small:
        tried = {angle: _along(found, angle, smallest, least) for angle in angles}
        best = max(tried, key=lambda angle: _scale(tried[angle]))
        if _scale(tried[best]) < WORTH * scale:
            break
        found = tried[best]
        angles.remove(best)
    if found is before:
        return tuple(marks)
    return (*map(_styled, found, marks), *found[len(marks) :])


def _styled(mark: Mark, like: Mark) -> Mark:
    """A mark in the style of another one."""
    return replace(mark, style=like.style) if isinstance(mark, Polyline) and isinstance(like, Polyline) else mark


def _with_later_ropes(marks: Sequence[Mark]) -> Iterator[Mark]:
    """The marks; a rope as it is later, that begins as one that is there and goes the same way, is a line like that."""
    ropes = [ends for m in marks if isinstance(m, Polyline) and m.style == "rope" for ends in pairwise(m.places)]
    for mark in marks:
        match mark:
            case Polyline(places=places, style="hidden", closed=False) if all(
                any(_is_like(ends, rope) for rope in ropes) for ends in pairwise(places)
            ):
                yield replace(mark, style="dashed")
            case _:
                yield mark


def _is_like(ends: tuple[Spot, Spot], rope: tuple[Spot, Spot]) -> bool:
    """Does a straight line begin, or end, where another one does, and lie along it?"""
    angle = math.atan2(rope[1][1] - rope[0][1], rope[1][0] - rope[0][0])
    meet = min(math.dist(a, b) for a in ends for b in rope) <= NEAR * math.dist(*rope)
    return meet and _is_along(*ends, angle)


def _scale(marks: Sequence[Mark]) -> float:
    """How large a metre is where the drawing fills the sheet."""
    spots = [s for m in marks for s in spots_of(m)]
    xs, ys = zip(*spots, strict=True) if spots else ((0.0,), (0.0,))
    sizes = (max(xs) - min(xs), max(ys) - min(ys))
    return min((room / size for room, size in zip(PAPER, sizes, strict=True) if size > 0), default=math.inf)


def _sizes(marks: Iterable[Mark]) -> Iterator[float]:
    """The sizes of bodies, and the distances that are told."""
    for mark in marks:
        match mark:
            case Arc(radius=radius) if radius > 0:
                yield 2 * radius
            case Polyline(places=places, style="body" | "slim"):
                yield max(math.dist(places[0], p) for p in places)
            case Dimension(start=start, end=end) if math.dist(start, end) > 0:
                yield math.dist(start, end)


def _directions(marks: Sequence[Mark]) -> list[float]:
    """The axes, and those of lines that are long enough to be broken, each as an angle from 0 to π."""
    found, least = [0.0, math.pi / 2], LEAST / _scale(marks)
    for mark in marks:
        for start, end in _lines(mark):
            if math.dist(start, end) < least:
                continue
            angle = math.atan2(end[1] - start[1], end[0] - start[0]) % math.pi
            if all(abs(math.remainder(angle - a, math.pi)) > NEAR for a in found):
                found.append(angle)
    return found


def _lines(mark: Mark) -> Iterator[tuple[Spot, Spot]]:
    """The straight pieces of a mark that may be broken."""
    match mark:
        case Polyline(places=places, style=style, closed=False) if style in LINES:
            yield from pairwise(_corners(places))
        case Hatched(places=places):
            yield from pairwise(_corners(places))
        case Dimension(start=start, end=end) if mark.side:
            yield start, end


def _corners(places: Sequence[Spot]) -> Iterator[Spot]:
    """The places at which a line turns, and its ends."""
    yield places[0]
    for before, at, after in zip(places, places[1:], places[2:], strict=False):
        if math.dist(before, at) + math.dist(at, after) > math.dist(before, after) * (1 + NEAR):
            yield at
    yield places[-1]


@record
class _Cut:
    """From one place to another along a direction, and how long that is drawn; `told`: with the sign of a break."""

    start: float
    end: float
    drawn: float
    told: bool

    def at(self, s: float) -> float:
        """By how much what lies there comes nearer."""
        return (min(max(s, self.start), self.end) - self.start) * (1 - self.drawn / (self.end - self.start))


def _along(marks: Sequence[Mark], angle: float, smallest: float, least: float) -> tuple[Mark, ...]:
    """The marks with as much left out along a direction as the smallest of them needs."""
    cuts = _cuts(marks, angle, smallest, least)

    def to(spot: Spot) -> Spot:
        return moved(spot, angle, -sum(cut.at(_on(spot, angle)) for cut in cuts))

    if not cuts:
        return tuple(marks)
    signs = [s for m in marks if not isinstance(m, Dimension) for s in _signs(m, angle, cuts, to)]
    return (*(_placed(m, angle, cuts, to) for m in marks), *dict.fromkeys(signs))


def _on(spot: Spot, angle: float) -> float:
    """How far along a direction a place is."""
    return spot[0] * math.cos(angle) + spot[1] * math.sin(angle)


def _cuts(marks: Sequence[Mark], angle: float, smallest: float, least: float) -> list[_Cut]:
    """Where the direction is cut: stretches that are free, the longer ones shortened in one ratio."""
    on = partial(_on, angle=angle)
    reach = [on(s) for m in marks for s in spots_of(m)]
    taken = sorted(t for m in marks for t in _taken(m, angle))
    free, end = list[tuple[float, float]](), min(reach)
    for low, high in taken:
        if low > end:
            free.append((end, low))
        end = max(end, high)
    whole, wanted = max(reach) - min(reach), GOOD / smallest
    room = PAPER[1] if abs(math.sin(angle)) > math.sqrt(0.5) else PAPER[0]
    scale = _scale(marks)
    crossed = [(a, b) for a, b in free if (b - a) * scale > LEAST and any(_passes(m, angle, a, b) for m in marks)]
    length = sum(b - a for a, b in crossed)
    rest = whole - length
    # As much is left as the sheet has room for, when the smallest thing is as large as it should be.
    left = max(room / wanted - rest, PART * rest)
    shortest = least * (rest + left) / room
    # A floor that only goes on beyond all else is shorter, and nobody misses that.
    things = [t for m in marks if not isinstance(m, Hatched) for t in _taken(m, angle)]
    low, high = min(a for a, _ in things), max(b for _, b in things)
    drawn = [(a, b, max((b - a) * left / length, shortest)) for a, b in crossed]
    return [_Cut(a, b, d, low <= a and b <= high) for a, b, d in drawn if d < b - a]


def _taken(mark: Mark, angle: float) -> list[tuple[float, float]]:
    """The stretches on which something lies that is no straight line along the direction."""
    on = partial(_on, angle=angle)
    match mark:
        case Polyline() | Hatched() | Dimension() if lines := [*_lines(mark)]:
            places = [on(s) for ends in lines for s in ends]
            across = [(*sorted((on(a), on(b))),) for a, b in lines if not _is_along(a, b, angle)]
            return [(s, s) for s in (min(places), max(places))] + [(a, b) for a, b in across]
        case Arc(center=center, radius=r, start=start, sweep=sweep):
            steps = [on(moved(center, start + sweep * k / 36, r)) for k in range(37)]
            return [(min(steps), max(steps))]
        case _:
            places = [on(s) for s in spots_of(mark)]
            return [(min(places), max(places))] if places else []


def _is_along(start: Spot, end: Spot, angle: float) -> bool:
    length = math.dist(start, end)
    aside = (end[1] - start[1]) * math.cos(angle) - (end[0] - start[0]) * math.sin(angle)
    return abs(aside) <= NEAR * length


def _passes(mark: Mark, angle: float, low: float, high: float) -> bool:
    """Does a line go through a stretch?"""
    return any(not isinstance(mark, Dimension) and _crosses(ends, angle, low, high) for ends in _lines(mark))


def _crosses(ends: tuple[Spot, Spot], angle: float, low: float, high: float) -> bool:
    first, last = sorted(_on(s, angle) for s in ends)
    return first <= low + NEAR * (high - low) and last >= high - NEAR * (high - low)


def _signs(mark: Mark, angle: float, cuts: Sequence[_Cut], to: Move) -> Iterator[Symbol]:
    """The sign of a break in the middle of each cut through a line."""
    for start, end in _lines(mark):
        for cut in cuts:
            if cut.told and _crosses((start, end), angle, cut.start, cut.end):
                ahead = (cut.start + cut.end) / 2 - _on(start, angle)
                yield Symbol("break", to(moved(start, angle, ahead)), angle)


def _placed(mark: Mark, angle: float, cuts: Sequence[_Cut], to: Move) -> Mark:
    """A mark where it is drawn."""
    match mark:
        case Polyline(places=places) | Hatched(places=places):
            return replace(mark, places=tuple(map(to, places)))
        case Dimension(start=start, end=end):
            cut = any(_crosses((start, end), angle, c.start, c.end) for c in cuts)
            return replace(mark, start=to(start), end=to(end), broken=mark.broken or cut)
        case Coil(start=start, end=end) | Dashpot(start=start, end=end) | Span(start=start, end=end):
            return replace(mark, start=to(start), end=to(end))
        case Arc(center=center):
            return replace(mark, center=to(center))
        case Angle(vertex=vertex):
            return replace(mark, vertex=to(vertex))
        case Symbol(at=at) | Arrow(at=at) | Turn(at=at) | Tag(at=at):
            return replace(mark, at=to(at))
        case _:
            return mark
