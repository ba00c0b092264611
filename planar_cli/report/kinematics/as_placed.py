"""The components of an arm by the distance and the angle that the file gives in numbers, before what is made of them:

r_A/O = [0.4 cos 60°, 0.4 sin 60°] = [0.2, 0.3464] m
v_A = ω × r_A/O = [-0.3464 · 3, 0.2 · 3] = [-1.039, 0.6] m/s
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Polar
from planar_cli.report.document.blocks import Equation, Line, Name, Text, Value, line
from planar_cli.report.document.lines import Inline
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.sides import said
from planar_cli.report.words.words import Phrases
from planar_cli.units import LENGTH


def as_placed(place: str, reference: str, arm: Vec, scene: Scene, phrases: Phrases) -> Line:
    """The arm from the reference to a point that is placed from it, or from which it is placed itself, ending in an
    equals sign; empty: the file places neither so, or the arm lies along an axis.
    """
    if any(phrases.value.is_zero(part) for part in (arm.x, arm.y)):
        return ()
    value, places = phrases.value, {p.name: p.place for p in scene.problem.points}
    for end, start, sign in ((place, reference, ""), (reference, place, "-")):
        polar = places.get(end)
        if not isinstance(polar, Polar) or polar.origin != start:
            continue
        size, turn = scene.value(polar.distance), scene.value(polar.angle)
        whole = Vec(size * sp.cos(turn), size * sp.sin(turn)) * (-1 if sign else 1)
        if not all(value.is_zero(p) for p in (whole.x - arm.x, whole.y - arm.y)):
            continue
        angle = said(polar.angle, phrases.figures)
        if angle and not sp.sympify(size).free_symbols:
            turned, back = _upward(angle)
            length = significant(phrases.of_dimension(phrases.certain(size), LENGTH).number, phrases.figures)
            other = sign if back == "" else "" if sign else "-"
            return line(f"[{sign}{length} cos ", *turned, f", {other}{length} sin ", *turned, "] = ")
    return ()


def with_arm(sides: Sequence[Line], in_numbers: bool, arm: Line) -> Iterator[Equation]:
    """A vector equation with its arm: before it where the numbers of the arm stand in it, else behind it, as one along
    an axis, of which only a length stands in it.
    """
    numbers = [piece.number for piece in arm if isinstance(piece, Value)]
    if not in_numbers or not numbers or 0 in numbers:
        yield Equation(tuple(sides), None, note=arm)
        return
    yield Equation(_sides_of(arm), None)
    yield Equation(tuple(sides), None)


def _sides_of(told: Line) -> tuple[Line, ...]:
    """The sides of what is told with equals signs."""
    found: list[list[Inline]] = [[]]
    for piece in told:
        if not isinstance(piece, Text):
            found[-1].append(piece)
            continue
        first, *others = piece.text.split(" = ")
        found[-1] += [replace(piece, text=first)] if first else []
        found += [[replace(piece, text=part)] if part else [] for part in others]
    return tuple(tuple(side) for side in found)


def arm_name(place: str, reference: str) -> Name:
    """r_P/A."""
    return Name(f"r_{index_of(place.rstrip('′'))}/{index_of(reference)}")


def _upward(angle: Line) -> tuple[Line, str]:
    """30° and "-" of -30°, whose cosine is that of 30°."""
    (first, *more) = angle
    if more or not isinstance(first, Value) or first.number >= 0:
        return angle, ""
    return (replace(first, number=-first.number),), "-"
