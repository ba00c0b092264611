"""Where words stand in a drawing: of all places round what they belong to, where they cover least.

Every label has candidate places, each with a cost; they are set one after the other and then, while that helps, anew
(Christensen, Marks, Shieber: An Empirical Study of Algorithms for Point-Feature Label Placement, 1995).
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from planar_cli.formats._paper import Box, Paper, Placed, Words, along
from planar_cli.records import record

CELL = 4.0
ANGLES = tuple(math.radians(a) for a in range(0, 360, 20))
FAR = (1.0, 2.2, 4.0, 7.0, 11.0, 16.0)
"""Distances from the anchor in parts of the gap that is usual."""
ROUNDS = 4
CLASH, COVERS, AWAY, TURNED, OUTSIDE = 1e6, 3.0, 2.0, 1.5, 25.0
"""What it costs to overlap another label; to cover a cell of a stroke; to stand farther; to be off the best angle; to
stand outside a gap that is left for it.
"""


def with_labels(paper: Paper) -> Paper:
    """The paper with its words at their places."""
    ink = Counter(
        (int(x // CELL), int(y // CELL)) for s in paper.strokes if s.kind != "grid" for x, y in along(s, CELL)
    )
    order = sorted(range(len(paper.words)), key=lambda i: (not paper.words[i].fixed, -paper.words[i].width))
    set_: dict[int, Placed] = {}
    for _ in range(ROUNDS):
        before = dict(set_)
        for i in order:
            others = [p.box for k, p in set_.items() if k != i]
            set_[i] = _best(paper.words[i], others, ink)
        if set_ == before:
            break
    return Paper(paper.strokes, paper.words, tuple(set_[i] for i in range(len(paper.words))))


@record
class _Candidate:
    box: Box
    cost: float


def _best(words: Words, others: Sequence[Box], ink: Counter[tuple[int, int]]) -> Placed:
    if words.fixed:
        return Placed(words, _box(words, words.angles[0], words.gap))
    found = min(_candidates(words, others, ink), key=lambda c: c.cost)
    return Placed(words, found.box)


def _candidates(words: Words, others: Sequence[Box], ink: Counter[tuple[int, int]]) -> Iterator[_Candidate]:
    x, y, half_w, half_h = *words.anchor, words.width / 2, words.height / 2
    if words.within:
        box = Box(x - half_w, y - half_h, x + half_w, y + half_h)
        yield _Candidate(box, sum(box.overlaps(o) for o in others) * CLASH + COVERS * _covered(box, ink))
    for far in FAR:
        for angle in (*words.angles, *ANGLES):
            box = _box(words, angle, words.gap * far)
            off = min((abs(math.remainder(angle - a, 2 * math.pi)) for a in words.angles), default=0.0)
            clashes = sum(box.overlaps(o) for o in others)
            cost = (
                clashes * CLASH
                + (OUTSIDE if words.within else 0.0)
                + COVERS * _covered(box, ink)
                + AWAY * (far - 1)
                + TURNED * off
            )
            yield _Candidate(box, cost)


def _box(words: Words, angle: float, away: float) -> Box:
    """The box of words in a direction from their anchor, whose nearest edge or corner is so far away."""
    cos, sin = math.cos(angle), -math.sin(angle)
    half_w, half_h = words.width / 2, words.height / 2
    x = words.anchor[0] + cos * away + half_w * max(-1.0, min(1.0, cos * 1.5))
    y = words.anchor[1] + sin * away + half_h * max(-1.0, min(1.0, sin * 1.5))
    return Box(x - half_w, y - half_h, x + half_w, y + half_h)


def _covered(box: Box, ink: Counter[tuple[int, int]]) -> int:
    """How many cells of strokes a box covers."""
    columns = range(int(box.left // CELL), int(box.right // CELL) + 1)
    rows = range(int(box.top // CELL), int(box.bottom // CELL) + 1)
    return sum((i, j) in ink for i in columns for j in rows)


def clashes(paper: Paper) -> list[tuple[Placed, Placed]]:
    """The pairs of words that overlap."""
    placed = paper.placed
    return [(a, b) for i, a in enumerate(placed) for b in placed[i + 1 :] if a.box.overlaps(b.box)]
