"""Vectors along one line at one place, side by side, as the two strands of a cord at a pulley."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.report.marks import Arrow, Mark

LANE = 11.0
"""So far apart they are on paper, px."""


def in_lanes(marks: Sequence[Mark]) -> list[Mark]:
    """The marks of one diagram; those that are alike, such as both strands, stand on both sides of the others."""
    groups: dict[tuple[float, ...], list[int]] = {}
    for i, mark in enumerate(marks):
        if isinstance(mark, Arrow):
            groups.setdefault(_ray(mark), []).append(i)
    found = list(marks)
    for group in groups.values():
        arrows = {i: m for i in group if isinstance(m := marks[i], Arrow)}
        for lane, i in enumerate(_ordered(arrows)):
            aside = LANE * (lane - (len(group) - 1) / 2)
            found[i] = replace(arrows[i], aside=-aside if arrows[i].inward else aside)
    return found


def _ray(arrow: Arrow) -> tuple[float, ...]:
    """On which side of which place it is drawn."""
    way = arrow.angle + (math.pi if arrow.inward else 0.0)
    return round(arrow.at[0], 9), round(arrow.at[1], 9), round(math.cos(way), 3), round(math.sin(way), 3)


def _ordered(arrows: dict[int, Arrow]) -> Iterator[int]:
    """From one side to the other: pairs of equal letters outside, one on each side."""
    letters = {i: repr(m.words) for i, m in arrows.items()}
    often = Counter(letters.values())
    pairs = [[i for i, own in letters.items() if own == words] for words, n in often.items() if n == 2]
    yield from (i for i, _ in pairs)
    yield from (i for i, own in letters.items() if often[own] != 2)
    yield from (i for _, i in reversed(pairs))
