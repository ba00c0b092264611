"""Vectors along one line at one place, side by side, as the two strands of a cord at a pulley."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.report.document.marks import Arrow, Mark

LANE = 11.0
"""So far apart they are on paper, px."""
CLOSE, NEAR = 0.12, 1e-9
"""Ways that differ by no more than this angle lie over each other, from places that are no farther apart, m."""


def in_lanes(marks: Sequence[Mark]) -> list[Mark]:
    """The marks of one diagram; those that are alike, such as both strands, stand on both sides of the others."""
    groups: list[list[int]] = []
    for i, mark in enumerate(marks):
        if isinstance(mark, Arrow):
            own = next((g for g in groups if isinstance(m := marks[g[0]], Arrow) and _are_one_line(m, mark)), None)
            groups += [[]] if own is None else []
            (groups[-1] if own is None else own).append(i)
    found = list(marks)
    for group in groups:
        arrows = {i: m for i in group if isinstance(m := marks[i], Arrow)}
        for lane, i in enumerate(_ordered(arrows)):
            aside = LANE * (lane - (len(group) - 1) / 2)
            found[i] = replace(arrows[i], aside=-aside if arrows[i].inward else aside)
    return found


def _are_one_line(one: Arrow, other: Arrow) -> bool:
    """Are both drawn on the same side of the same place?"""
    apart = math.remainder(_way(one) - _way(other), 2 * math.pi)
    return abs(apart) < CLOSE and math.dist(one.at, other.at) < NEAR


def _way(arrow: Arrow) -> float:
    """On which side of its place it is drawn."""
    return arrow.angle + (math.pi if arrow.inward else 0.0)


def _ordered(arrows: dict[int, Arrow]) -> Iterator[int]:
    """From one side to the other: pairs of equal letters outside, one on each side."""
    letters = {i: repr(m.words) for i, m in arrows.items()}
    often = Counter(letters.values())
    pairs = [[i for i, own in letters.items() if own == words] for words, n in often.items() if n == 2]
    yield from (i for i, _ in pairs)
    yield from (i for i, own in letters.items() if often[own] != 2)
    yield from (i for _, i in reversed(pairs))
