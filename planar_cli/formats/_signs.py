"""Signs of fixed size on paper: pins, supports, sliders, walls, mass centres, points."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.formats._paper import Disc, Spot, Stroke
from planar_cli.formats._strokes import LATER, Piece, arc, hatching, moved
from planar_cli.report.document.marks import Symbol

BLOCK = 26.0
HIDDEN, BREAK = "gap", "break"
"""What hides a line between the two strokes of a break, and these."""
CORNERS = ((-0.5, 0.0), (0.5, 0.0), (0.5, 0.8), (-0.5, 0.8))
WALL = (0.25, 1.35)
"""From where to where the walls beside a block go, in parts of its width."""
SLIDER = (24.0, 14.0)
HANGER = 24.0


def sign(mark: Symbol, at: Spot) -> Iterator[Piece]:
    """A sign at a place on paper."""
    match mark.kind:
        case "pin":
            yield Disc(at, 3.6, "pin")
        case "support":
            feet = (moved(at, mark.angle, -10, -16), moved(at, mark.angle, 10, -16))
            yield Stroke((feet[0], at, feet[1]), "support area", True)
            base = (moved(feet[0], mark.angle, -5), moved(feet[1], mark.angle, 5))
            yield Stroke(base, "ground")
            yield from hatching(base)
            yield Disc(at, 3.6, "pin")
        case "edge":
            # Under a point of what lies on it.
            tip = moved(at, mark.angle, 0, -3.5)
            feet = (moved(tip, mark.angle, -8, -14), moved(tip, mark.angle, 8, -14))
            yield Stroke((feet[0], tip, feet[1]), "support area", True)
            base = (moved(feet[0], mark.angle, -5), moved(feet[1], mark.angle, 5))
            yield Stroke(base, "ground")
            yield from hatching(base)
        case "particle":
            yield Disc(at, 5.0, "mass")
        case "block" | "later":
            yield Stroke(_block(at, mark.angle, mark.lean), LATER if mark.kind == "later" else "body area", True)
        case "guides":
            for side in (1, -1):
                wall = tuple(moved(at, mark.angle, a * BLOCK, side * (BLOCK / 2 + 2)) for a in WALL)
                yield Stroke(wall, "ground")
                yield from hatching(wall, -side)
        case "slider" | "rail":
            yield from _slider(at, mark.angle, mark.kind == "rail")
        case "weld":
            yield Stroke(tuple(moved(at, 0, a, b) for a, b in ((-4, -4), (4, -4), (4, 4), (-4, 4))), "mass area", True)
        case _:
            yield from _place(mark, at)


def _block(at: Spot, angle: float, lean: float) -> tuple[Spot, ...]:
    """The corners of a block on what lies along an angle, its sides turned by `lean` from upright on that."""
    low = 0.5 / math.cos(lean)
    feet = tuple(moved(at, angle, a * BLOCK) for a in (-low, low))
    (_, _), (_, _), *top = CORNERS
    return (*feet, *(moved(at, angle + lean, a * BLOCK, b * BLOCK) for a, b in top))


def _place(mark: Symbol, at: Spot) -> Iterator[Piece]:
    """A sign that tells where something is."""
    match mark.kind:
        case "centre":
            yield Disc(at, 4.5, "centre")
            yield Stroke((moved(at, 0, -7), moved(at, 0, 7)), "centre")
            yield Stroke((moved(at, 0, 0, -7), moved(at, 0, 0, 7)), "centre")
        case "origin":
            yield from (Stroke((moved(at, a, -6), moved(at, a, 6)), "measure") for a in (0.0, math.pi / 2))
        case "point":
            yield Disc(at, 1.8, "dot")
        case "ring":
            yield Disc(at, 2.4, "pin")
        case "place":
            yield Disc(at, 5.0, LATER)
        case "break":
            sides = [(moved(at, mark.angle, a - 3, -8), moved(at, mark.angle, a + 3, 8)) for a in (-3.0, 3.0)]
            yield Stroke((*sides[0], *reversed(sides[1])), HIDDEN, True)
            yield from (Stroke(side, f"thin {BREAK}") for side in sides)
        case "hanger":
            yield from _hanger(at, mark.angle)
        case "plate":
            yield Stroke((moved(at, mark.angle, 0, 10), moved(at, mark.angle, 0, -10)), "ground")
        case "wall":
            wall = (moved(at, mark.angle, 0, -11), moved(at, mark.angle, 0, 11))
            yield Stroke(wall, "ground")
            yield from hatching(wall, -1)


def _hanger(at: Spot, angle: float) -> Iterator[Piece]:
    """What holds a wheel: a bar from its axle to a fixed edge, in a direction."""
    yield Stroke((at, moved(at, angle, HANGER)), "spring")
    edge = (moved(at, angle, HANGER, 11), moved(at, angle, HANGER, -11))
    yield Stroke(edge, "ground")
    yield from hatching(edge, -1)
    yield Disc(at, 2.6, "pin")


def slot(start: Spot, end: Spot, angle: float, fixed: bool) -> Iterator[Piece]:
    """A slot from one place on paper to another along a direction; in the ground longer by the room for a slider."""
    wide = SLIDER[1] / 2 + 2
    length = math.cos(angle) * (end[0] - start[0]) - math.sin(angle) * (end[1] - start[1])
    room = SLIDER[0] / 2 + 4 if fixed else -min(wide, length / 2)
    start, end = moved(start, angle, -room), moved(end, angle, room)
    ring = (*arc(end, wide, angle - math.pi / 2, math.pi), *arc(start, wide, angle + math.pi / 2, math.pi))
    yield Stroke(ring, "ground" if fixed else "thin", True)
    for side in (1, -1) if fixed else ():
        yield from hatching((moved(start, angle, 0, side * wide), moved(end, angle, 0, side * wide)), -side)


def _slider(at: Spot, angle: float, fixed: bool) -> Iterator[Piece]:
    """A box; on a fixed rail with the rail on both sides of it."""
    half = SLIDER[0] / 2, SLIDER[1] / 2
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    for side in (1, -1) if fixed else ():
        rail = tuple(moved(at, angle, a * 2.1 * half[0], side * (half[1] + 2)) for a in (-1, 1))
        yield Stroke(rail, "ground")
        yield from hatching(rail, -side)
    yield Stroke(tuple(moved(at, angle, a * half[0], b * half[1]) for a, b in corners), "body area", True)
    yield Disc(at, 2.6, "pin")
