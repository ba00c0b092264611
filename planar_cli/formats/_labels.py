"""Where words stand in a drawing: of all places round what they belong to, the nearest where they cover nothing.

Every label has candidate places, each with a cost; they are set one after the other and then, while that helps, anew
(Christensen, Marks, Shieber: An Empirical Study of Algorithms for Point-Feature Label Placement, 1995). What stands so
far from its place that it could belong elsewhere is led to it by a thin line.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence

from planar_cli.formats._ink import Ink
from planar_cli.formats._paper import Box, Paper, Placed, Spot, Stroke, Words, along
from planar_cli.records import record

ANGLES = tuple(math.radians(a) for a in range(0, 360, 15))
FAR = (1.0, 1.5, 2.2, 3.0, 4.0, 5.5, 7.0, 9.0, 11.0, 13.5, 16.0, 20.0, 25.0, 30.0)
"""Distances from the anchor in parts of the gap that is usual."""
ROUNDS = 4
CLASH, COVERS, EACH, AWAY, TURNED, OUTSIDE, CROSSES, TOUCHES = 1e6, 200.0, 1.0, 2.0, 1.5, 25.0, 0.7, 20.0
"""What it costs to overlap another label; to cover strokes, and each pixel of them; to stand farther; to be off the
best angle; to stand outside a gap that is left for it; each pixel of a stroke that the line to its place crosses; to be
so near to another label that the two are read as one.
"""
NEAR_COVERS, NEAR_EACH = 8.0, 0.3
"""What it costs words that no line leads to, to cover strokes, and each pixel of them."""
EACH_CELL, BEYOND = 5.0, 300.0
"""What it costs to cover something in a cell of letters; to stand where no room is for letters."""
SPACE = 5.0
"""Between two labels beside each other, px."""
LED, SPARE = 15.0, 2.5
"""Words farther away than this have a line to their place, px; so much of it is left out at either end."""

ORDERS: tuple[Callable[[Words], float], ...] = (
    lambda w: -w.width,
    lambda w: w.width,
    lambda w: w.anchor[0],
    lambda w: -w.anchor[0],
)


def with_labels(paper: Paper, led: bool = True) -> Paper:
    """The paper with its words at their places, and with the lines that lead from them. `led`: there may be such lines;
    what moves has none, so that its words stay near it and rather cover a stroke.
    """
    seen = [s for s in paper.strokes if s.kind != "grid"]
    found = _set(paper.words, _Ground(Ink(spot for s in seen for spot in along(s, 1.0)), led=led))
    leaders = (Stroke(c.leader, "leader") for c in found if c.leader)
    placed = tuple(Placed(words, c.box) for words, c in zip(paper.words, found, strict=True))
    return Paper((*paper.strokes, *leaders), paper.words, placed)


def in_cells(words: Sequence[Words], taken: Iterable[Spot], cell: Spot, sides: Spot) -> list[Box]:
    """Where words stand whose letters fill cells. `taken`: places in cells with something else, the oftener the more
    it matters; `sides`: nothing is to stand to the left of the first, or to the right of the second.
    """
    return [c.box for c in _set(words, _Ground(Ink(taken), cell=cell, sides=sides))]


@record
class _Ground:
    """What words stand on: pixels, each stroke with many; or cells, where few are free. `led`: lines lead to them."""

    ink: Ink
    led: bool = False
    cell: Spot = (0.0, 0.0)
    sides: Spot = (-math.inf, math.inf)

    def covers(self, pixels: int) -> float:
        """What it costs to stand on so many."""
        if self.cell[0]:
            return EACH_CELL * pixels
        first, each = (COVERS, EACH) if self.led else (NEAR_COVERS, NEAR_EACH)
        return first + each * pixels if pixels else 0.0

    def box(self, box: Box) -> Box:
        """Where words stand that ought to stand in a box."""
        wide, high = self.cell
        if not wide:
            return box
        left, top = round(box.left / wide) * wide, round(box.top / high) * high
        right = left + round((box.right - box.left) / wide) * wide
        return Box(left, top, right, top + high).grown(-1.5)

    def leader(self, anchor: Spot, box: Box) -> tuple[Spot, ...]:
        """The line that leads to words, if one does."""
        return _leader(anchor, box) if self.led else ()

    def beyond(self, box: Box) -> float:
        """What it costs to stand so far to the left or right."""
        return BEYOND * (box.left < self.sides[0] or box.right > self.sides[1])


@record
class _Candidate:
    """A place for words; `leader`: the line from there to what they belong to."""

    box: Box
    leader: tuple[Spot, ...] = ()


def _set(words: Sequence[Words], ground: _Ground) -> list[_Candidate]:
    """The place of each of some words: the widest first; where some cover something then, also in other orders."""
    best, least = list[_Candidate](), math.inf
    for way in ORDERS:
        found = _in_order(words, ground, sorted(range(len(words)), key=lambda i: (not words[i].fixed, way(words[i]))))
        rest = ((c, [o for o in found if o is not c]) for c in found)
        cost = sum(_covers(c, others, ground) >= COVERS for c, others in rest)
        if cost < least:
            best, least = found, cost
        if not cost or ground.cell[0]:
            break
    return best


def _in_order(words: Sequence[Words], ground: _Ground, order: Sequence[int]) -> list[_Candidate]:
    set_: dict[int, _Candidate] = {}
    for _ in range(ROUNDS):
        before = dict(set_)
        for i in order:
            set_[i] = _best(words[i], [c for k, c in set_.items() if k != i], ground)
        if set_ == before:
            break
    return [set_[i] for i in range(len(words))]


def _best(words: Words, others: Sequence[_Candidate], ground: _Ground) -> _Candidate:
    if words.fixed:
        return _Candidate(ground.box(_box(words, words.angles[0], words.gap)))
    best, least = None, math.inf
    for ring in (0.0, *FAR) if words.within else FAR:
        # What costs more where it is, costs more whatever it covers.
        if _least_of(words, ring) >= least:
            break
        for one, cost in _candidates(words, ground, ring):
            if cost < least and (total := cost + _covers(one, others, ground)) < least:
                best, least = one, total
    assert best is not None
    return best


def _least_of(words: Words, far: float) -> float:
    """What it costs at least to be so far from the anchor; 0: in the gap that is left for the words."""
    return (OUTSIDE if words.within else 0.0) + AWAY * (far - 1) if far else 0.0


def _candidates(words: Words, ground: _Ground, far: float) -> Iterator[tuple[_Candidate, float]]:
    """Places so far round an anchor, with what it costs to be there, whatever else is."""
    if not far:
        x, y, half_w, half_h = *words.anchor, words.width / 2, words.height / 2
        box = ground.box(Box(x - half_w, y - half_h, x + half_w, y + half_h))
        yield _Candidate(box), ground.beyond(box)
        return
    for angle in (*words.angles, *ANGLES):
        box = ground.box(_box(words, angle, words.gap * far))
        off = min((abs(math.remainder(angle - a, 2 * math.pi)) for a in words.angles), default=0.0)
        cost = _least_of(words, far) + TURNED * off
        yield _Candidate(box, ground.leader(words.anchor, box)), cost + ground.beyond(box)


def _covers(one: _Candidate, others: Iterable[_Candidate], ground: _Ground) -> float:
    """What it costs to be where other words, strokes and lines are."""
    pixels, cost, box = ground.ink.within(one.box), 0.0, one.box
    wide = Box(box.left - SPACE, box.top, box.right + SPACE, box.bottom)
    for other in others:
        cost += CLASH * box.overlaps(other.box) + TOUCHES * wide.overlaps(other.box)
        if other.leader and box.is_cut(*other.leader):
            pixels += 1
        if one.leader and other.box.is_cut(*one.leader):
            pixels += 1
    crossed = sum(map(ground.ink.has, along(Stroke(one.leader, ""), 1.0)))
    return cost + CROSSES * crossed + ground.covers(pixels)


def _leader(anchor: Spot, box: Box) -> tuple[Spot, ...]:
    """A line from words to their place; (): they are near it."""
    x, y = max(box.left, min(anchor[0], box.right)), max(box.top, min(anchor[1], box.bottom))
    away = math.dist(anchor, (x, y))
    if away <= LED:
        return ()
    dx, dy = (anchor[0] - x) / away * SPARE, (anchor[1] - y) / away * SPARE
    return (x + dx, y + dy), (anchor[0] - dx, anchor[1] - dy)


def _box(words: Words, angle: float, away: float) -> Box:
    """The box of words in a direction from their anchor, whose nearest edge or corner is so far away."""
    cos, sin = math.cos(angle), -math.sin(angle)
    half_w, half_h = words.width / 2, words.height / 2
    x = words.anchor[0] + cos * away + half_w * max(-1.0, min(1.0, cos * 1.5))
    y = words.anchor[1] + sin * away + half_h * max(-1.0, min(1.0, sin * 1.5))
    return Box(x - half_w, y - half_h, x + half_w, y + half_h)


def clashes(paper: Paper) -> list[tuple[Placed, Placed]]:
    """The pairs of words that overlap."""
    placed = paper.placed
    return [(a, b) for i, a in enumerate(placed) for b in placed[i + 1 :] if a.box.overlaps(b.box)]
