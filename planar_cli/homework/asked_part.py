"""Of what was typed the part that is asked: of a vector its size or a component, and along a line the sign that a
direction in words gives.
"""

from __future__ import annotations

import math
from dataclasses import replace

from planar_cli.homework.paper import Expected
from planar_cli.homework.typed import Typed
from planar_cli.homework.typed_directions import along_line
from planar_cli.homework.unreadable import Unreadable

NEARLY = math.cos(math.radians(20))
"""A direction further off than this is not that of the line."""
NOT_READ = "not read: "


def asked_part(expected: Expected, answer: Typed) -> Typed:
    """One number, where one is asked. Unreadable: a vector stands where no part of one is asked."""
    if expected.kind != "number":
        return answer
    if answer.polar and expected.axis:
        return answer
    if answer.polar or len(answer.values) == 2:
        return _part(expected, answer)
    return _along(expected, answer) if expected.heading is not None else answer


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
