"""Lengths that the text gives and the coordinates of the file do not: how far two points are apart along an axis, as
those at -2.5 ft and 2.5 ft that are 5 ft apart.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from itertools import combinations

from planar_cli.figures.drawn import Drawn, words_of
from planar_cli.figures.stated import is_stated
from planar_cli.problem.language.expression import Negate, Number, Side
from planar_cli.problem.scene.scene import At
from planar_cli.report.document.marks import Dimension, Spot


def apart_in_text(drawn: Drawn, tagged: Mapping[str, Spot]) -> Iterator[Dimension]:
    """Of equal lengths along an axis between those points that are nearest to each other across it."""
    problem = drawn.scene.problem
    places = {p.name: p.place for p in problem.points if p.name in tagged and isinstance(p.place, At)}
    for axis in (0, 1):
        sides = {name: (place.x, place.y)[axis] for name, place in places.items() if not drawn.moved_by(name)[axis]}
        found: dict[Fraction, tuple[float, Dimension]] = {}
        for (one, a), (other, b) in combinations(sides.items(), 2):
            told = _difference(a, b)
            if told is None or not _is_told(problem.text or "", told) or _are_told(drawn, a, b):
                continue
            start, end = sorted((tagged[one], tagged[other]), key=lambda s: s[axis])
            across = abs(start[1 - axis] - end[1 - axis])
            if told.value not in found or across < found[told.value][0]:
                # From the farther one, so that what leads to the dimension passes both.
                far = max(start[1 - axis], end[1 - axis])
                ends = [(s[0], far) if axis == 0 else (far, s[1]) for s in (start, end)]
                side = -1 if axis == 0 else 1
                found[told.value] = (across, Dimension(ends[0], ends[1], words_of(told), side=side, level=True))
        yield from (mark for _, mark in found.values())


def _difference(a: Side | None, b: Side | None) -> Number | None:
    """How far two coordinates in numbers of one unit are apart."""
    (one, unit), (other, second) = _number(a), _number(b)
    units = {u for u in (unit, second) if u is not None}
    if one is None or other is None or one == other or len(units) != 1 or a is None:
        return None
    return Number(abs(one - other), units.pop(), 1, a.mark)


def _number(side: Side | None) -> tuple[Fraction | None, str | None]:
    match side:
        case Negate(operand=Number(value=value, unit=unit)):
            return -value, unit
        case Number(value=value, unit=unit):
            return value, unit
        case _:
            return None, None


def _is_told(text: str, length: Number) -> bool:
    number = f"{(Decimal(length.value.numerator) / Decimal(length.value.denominator)).normalize():f}"
    whole = rf"(?<![\d.]){re.escape(number)}\s*{re.escape(length.unit or '')}(?![\w/^²·*])"
    return re.search(whole, text) is not None


def _are_told(drawn: Drawn, *sides: Side | None) -> bool:
    """Does the text give the coordinates themselves, or is one of them zero, so that the other one is the length?"""
    lengths = [side for side in sides if _number(side)[0]]
    return len(lengths) < len(sides) or all(s is not None and is_stated(drawn.scene.problem, s) for s in lengths)
