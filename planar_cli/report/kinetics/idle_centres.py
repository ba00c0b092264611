"""The acceleration of a mass centre that no equation needs: moments about a fixed axis, with I_O, hold none."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.document.blocks import Block, Equation, Heading, Line, Math, Name
from planar_cli.report.equations.steps import KINETICS

MOMENTS, INERTIA = "ΣM_", "I_"


def without_idle_centre(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of one position without the vector equation of the one mass centre, where the only equation of the
    forces is one of moments about a point for which I is told.
    """
    start = next((i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == KINETICS), len(blocks))
    laws = [b for b in blocks[start:] if isinstance(b, Equation) and b.number is not None]
    centres = [b for b in blocks[:start] if isinstance(b, Equation) and _is_centre(b)]
    if len(laws) != 1 or len(centres) != 1 or not _is_about_axis(laws[0]):
        return list(blocks)
    return [b for b in blocks if b is not centres[0]]


def _is_centre(b: Equation) -> bool:
    """Is it a_G = α × r_G/O - ω² r_G/O?"""
    names = _names(b.sides[0])
    return b.number is None and not b.lead and len(names) == 1 and names[0].startswith("a_G")


def _is_about_axis(b: Equation) -> bool:
    """Are they moments about a point O with I_O on the other side?"""
    points = [n.removeprefix(MOMENTS) for n in _names(b.lead) if n.startswith(MOMENTS)]
    letters = {s.name for side in b.sides[1:] if isinstance(side, Math) for s in side.expr.free_symbols}
    return bool(points) and f"{INERTIA}{points[0]}" in letters


def _names(side: object) -> list[str]:
    pieces: Line = side if isinstance(side, tuple) else ()
    return [p.name for p in pieces if isinstance(p, Name)]
