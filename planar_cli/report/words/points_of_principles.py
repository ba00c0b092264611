"""The two points of which the formulas at the head of a page speak: where the page has other letters than B and A, its
own.

v_G = v_C + ω × r_G/C
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from planar_cli.report.document.blocks import Block, Equation, Math, Name, Text
from planar_cli.report.document.mentioned import pieces_of

CROSS = " × "
PAIR = re.compile(r"r_([^_/,]+(?:,\d+)?)/([^_/,]+(?:,\d+)?)")
PLACE = re.compile(r"[xy]_([A-Z])")
USUAL = ("B", "A")


def turned_about(page: Sequence[Block]) -> tuple[str, str]:
    """The points of v_B = v_A + ω × r_B/A as the page calls them: those of the course where it has them, else of its
    first such equation with both velocities, else of its first one.
    """
    found = list(_of_turning(page))
    whole = [pair for pair, both in found if both]
    pairs = [pair for pair, _ in found]
    return USUAL if USUAL in pairs or not pairs else (whole or pairs)[0]


def placed_from(page: Sequence[Block]) -> tuple[str, str]:
    """The points of r_B = r_A + r_B/A: of the first coordinate that stands as that of another point and more."""
    for block in page:
        if isinstance(block, Equation) and len(block.sides) > 1 and (to := _point(block.sides[0])):
            side = block.sides[1]
            others = [p for piece in (side if isinstance(side, tuple) else ()) if (p := _point(piece)) and p != to]
            if others:
                return to, others[0]
    return USUAL


def in_letters(formula: str, points: tuple[str, str]) -> str:
    """v_B, r_B/A, … of a formula with these points."""
    own = dict(zip(USUAL, points, strict=True))
    return re.sub(r"(?<=[rva/]_)[AB]|(?<=/)[AB]\b", lambda m: own[m[0]], formula)


def _of_turning(page: Sequence[Block]) -> Iterator[tuple[tuple[str, str], bool]]:
    """The points of each ω × r, and whether the velocity of both is in the equation."""
    for block in page:
        own = list(pieces_of(block)) if isinstance(block, Equation) else []
        if not any(isinstance(p, Text) and p.text == CROSS for p in own):
            continue
        names = [p.name for p in own if isinstance(p, Name)]
        pairs = [found for name in names if (found := PAIR.fullmatch(name))]
        if pairs and names[0] in (f"v_{pairs[0][1]}", f"a_{pairs[0][1]}"):
            yield (pairs[0][1], pairs[0][2]), f"{names[0][0]}_{pairs[0][2]}" in names


def _point(piece: object) -> str:
    """The point of which something is a coordinate, by one capital; "" of anything else."""
    name = piece.expr.name if isinstance(piece, Math) and piece.expr.is_Symbol else ""
    found = PLACE.fullmatch(name)
    return found[1] if found is not None else ""
