"""A vector that the file gives by its size and its direction: of a relative one the sum of velocities comes first.

v_boat = v_stream + v_boat/stream, where v_boat/stream = w at β:
along y:   0 = v_stream,y + w sin β
along x:   v_boat,x = v_stream,x + w cos β
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Paragraph, line
from planar_cli.solve.instant.written import Written

THING = r"([va])\((\w+)(?:/(\w+))?\)"
SIZE, ANGLE = re.compile(rf"{THING}\.mag = (.+)"), re.compile(rf"{THING}\.angle = (.+)")
DEGREES = re.compile(r"(-?\d+(?:\.\d+)?) deg")
AXIS = re.compile(r", along ([xy])$")


@record
class _Given:
    """v or a of a thing, relative to another or not, by its size and its angle, along an axis."""

    v: str
    thing: str
    base: str | None
    size: str
    angle: str
    axis: str


def _given(w: Written) -> _Given | None:
    one, _, other = w.lead.partition("; ")
    axis = AXIS.search(w.words)
    size, angle = (p.fullmatch(one) or p.fullmatch(other) for p in (SIZE, ANGLE))
    if w.source != "given" or w.times or size is None or angle is None or axis is None:
        return None
    if size.groups()[:3] != angle.groups()[:3]:
        return None
    return _Given(size[1], size[2], size[3], size[4], angle[4], axis[1])


def as_sum(w: Written) -> Written:
    """The component of a relative vector as v_A = v_B + v_A/B."""
    found = _given(w)
    if found is None or found.base is None:
        return w
    letters = {s.name: s for s in w.residual.free_symbols}
    own, base = (letters.get(f"{found.v}_{thing}_{found.axis}") for thing in (found.thing, found.base))
    if own is not None and abs(own_slope := w.residual.coeff(own, 1)) == 1:
        return replace(w, left=own, right=sp.expand(own - w.residual / own_slope))
    if own is None and base is not None and abs(slope := w.residual.coeff(base, 1)) == 1:
        return replace(w, left=sp.S.Zero, right=sp.expand(w.residual / slope))
    return w


def with_sum(w: Written, blocks: list[Block], named: Callable[[str], Line]) -> list[Block]:
    """The blocks of one component with that sum before it, and with its axis. `named`: sets words as mathematics."""
    found = _given(w)
    if found is None or not isinstance(blocks[0], Paragraph):
        return blocks
    v, thing, base = found.v, found.thing, found.base
    own = Name(f"{v}_{thing}" + (f"/{base}" if base else ""))
    given = line(own, " = ", *named(found.size), " at ", *named(found.angle), ":")
    whole = line(Name(f"{v}_{thing}"), " = ", Name(f"{v}_{base}"), " + ", own, ", where ") if base else line("Given: ")
    lead, own_part = line(f"along {found.axis}:"), line(Name(f"{v}_{thing},{found.axis}"))
    head = Paragraph(line(*whole, *given))
    return [
        head,
        *(
            _along(b, lead, own_part, found.angle if base is None else "", found.axis) if isinstance(b, Equation) else b
            for b in blocks[1:]
        ),
    ]


def _along(equation: Equation, lead: Line, own: Line, angle: str, axis: str) -> Equation:
    """v_boat,y = v_stream,y + w sin β = 0, of a component that is zero."""
    first, *others = equation.sides
    sides = (own, *others, first) if first == Math(sp.S.Zero) else _with_angle(equation.sides, angle, axis)
    return replace(equation, sides=sides, lead=lead)


def _with_angle(sides: tuple[Inline | Line, ...], angle: str, axis: str) -> tuple[Inline | Line, ...]:
    """u cos 30° = 8 cos 30° in place of √3 u/2 = √3 · 8 / 2, where the file gives the angle as a number."""
    degrees = DEGREES.fullmatch(angle)
    if degrees is None:
        return sides
    turn = sp.Symbol("given angle", real=True)
    wave, at = (sp.cos if axis == "x" else sp.sin)(turn), sp.Rational(degrees[1]) * sp.pi / 180
    told: list[Inline | Line] = []
    for side in sides:
        size = side.expr / wave.subs(turn, at) if isinstance(side, Math) and wave.subs(turn, at) != 0 else sp.S.Zero
        size = sp.simplify(size)
        held = size.is_Symbol and isinstance(side, Math) and side is not sides[0] and side.expr != size
        values = {**(side.values or {}), turn: f"{degrees[1]}°"} if isinstance(side, Math) else {}
        told.append(Math(size * wave, values) if held else side)
    return tuple(told)
