"""Of what was typed the part that is asked: of a vector its size or a component, and along a line the sign that a
direction in words gives.
"""

from __future__ import annotations

import math
from dataclasses import replace

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.typed.typed import TWO_ASKED, Typed
from planar_cli.homework.typed.typed_directions import along_line
from planar_cli.homework.typed.unreadable import Unreadable

NEARLY = math.cos(math.radians(20))
"""A direction further off than this is not that of the line."""
NOT_READ = "not read: "
ON_LINE = 1e-9
"""What machine numbers may be off a line."""


def asked_part(expected: Expected, answer: Typed) -> Typed:
    """One number, where one is asked. Unreadable: a vector stands where no part of one is asked."""
    if expected.kind == "vector" and len(answer.values) == 1:
        return _vector_of_one(expected, answer)
    if expected.kind != "number":
        return answer
    if answer.polar and expected.axis:
        return answer
    if answer.polar or len(answer.values) == 2:
        return _part(expected, answer)
    return _along(expected, answer) if expected.heading is not None else answer


def _vector_of_one(expected: Expected, answer: Typed) -> Typed:
    """The vector that one number tells: by words along a line of the problem, `17.0 N down the slope`; or by its sign
    where what is asked lies along a horizontal or vertical line of the problem, a guide or a floor.
    """
    words, (value,), (figures,) = along_line(answer.unread) if answer.unread else 0, answer.values, answer.figures
    if words and (heading := _line_of(expected)) is not None:
        size = value if value >= 0 else -value if words < 0 else value
        sign = words * math.copysign(1, math.sin(heading)) * size
        notes = tuple(n for n in answer.notes if not n.startswith(NOT_READ))
        values = sign * math.cos(heading), sign * math.sin(heading)
        return replace(answer, values=values, figures=(figures, figures), unread="", notes=notes)
    place = _only_component(expected)
    if place is None or answer.unread or (value > 0) > (expected.values[place] > 0):
        raise Unreadable(f"the direction is missing: {TWO_ASKED}")
    note = f"read as the component along {'xy'[place]}; the other is taken for zero"
    values = (value, 0.0) if place == 0 else (0.0, value)
    return replace(answer, values=values, figures=(figures, figures), notes=(*answer.notes, note))


def _line_of(expected: Expected) -> float | None:
    """The one inclined line of the problem; of several that along which the right vector lies. None: there is none."""
    inclined = [line for line in expected.lines if abs(math.sin(line)) > ON_LINE]
    if len(inclined) > 1:
        inclined = [line for line in inclined if _lies_along(expected, line)]
    return inclined[0] if len(inclined) == 1 else None


def _only_component(expected: Expected) -> int | None:
    """Along which axis the right vector lies, where a line of the problem does too; None: along neither."""
    for place, line in ((0, 0.0), (1, math.pi / 2)):
        there = any(abs(math.sin(other - line)) < ON_LINE for other in expected.lines)
        if there and _lies_along(expected, line):
            return place
    return None


def _lies_along(expected: Expected, line: float) -> bool:
    x, y = expected.values
    return abs(x * math.sin(line) - y * math.cos(line)) <= ON_LINE * math.hypot(x, y)


def _part(expected: Expected, answer: Typed) -> Typed:
    size, angle = answer.values if answer.polar else (math.hypot(*answer.values), 0.0)
    x, y = (size * math.cos(angle), size * math.sin(angle)) if answer.polar else answer.values
    if expected.axis:
        place = "xy".index(expected.axis)
        return _told(answer, (x, y)[place], answer.figures[place], f"the {expected.axis} component")
    figures = answer.figures[0] if answer.polar else min(answer.figures)
    if expected.size:
        return _told(answer, size, figures, "the size")
    if expected.heading is not None and size:
        along = (x * math.cos(expected.heading) + y * math.sin(expected.heading)) / size
        if abs(along) < NEARLY:
            raise Unreadable("the vector does not point along the line on which the component is asked")
        return _told(answer, math.copysign(size, along), figures, "the component along the line")
    raise Unreadable("only a vector is written so; here one number is asked")


def _told(answer: Typed, value: float, figures: int, part: str) -> Typed:
    notes = (*answer.notes, f"a vector was typed: {part} of it is taken")
    return replace(answer, values=(value,), figures=(figures,), polar=False, notes=notes)


def _along(expected: Expected, answer: Typed) -> Typed:
    """`5.50 m/s^2 down`, `5.50 m/s^2 up the ramp` of a component along a line."""
    assert expected.heading is not None
    words = along_line(answer.unread) if answer.unread else 0
    axis, way = (answer.axis, answer.way) if answer.way else ("y", words)
    if not way:
        return answer
    share = math.cos(expected.heading) if axis == "x" else math.sin(expected.heading)
    if abs(share) < 1e-9:
        raise Unreadable("the direction in words does not fit the line along which the component is asked")
    # A minus sign before the words was taken for what it says when the answer was read, unless a line stands there.
    value = answer.values[0]
    if not answer.way and value < 0 and way * share < 0:
        value = -value
    notes = tuple(n for n in answer.notes if not n.startswith(NOT_READ)) if words else answer.notes
    return replace(answer, values=(math.copysign(1, way * share) * value,), axis="", way=0, notes=notes)
