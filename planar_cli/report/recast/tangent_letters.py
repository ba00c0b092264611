"""Along its path a particle has the tangential acceleration that the equations have a letter for, where it is asked:
a_t = a_Pt = g sin 10°.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.problem.language.expression import Quantity
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def with_tangent_letters(part: PartSolution) -> PartSolution:
    """The part of single instants with what is asked along a path by its letter, or the opposite of that."""
    if part.motion is not None or not part.instants or not any(_is_tangential(f) for f in part.found):
        return part
    last = part.instants[-1]
    return replace(part, found=tuple(_told(f, last) if _is_tangential(f) else f for f in part.found))


def _is_tangential(found: Found) -> bool:
    """Is it the part of the whole acceleration along the velocity?"""
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.word != "a" or len(what.things) != 1 or len(found.asked) != 1:
        return False
    return [p.kind for p in what.parts] == ["t"] and found.values is not None


def _told(found: Found, instant: InstantSolution) -> Found:
    (asked,) = found.asked
    unknowns = {u for s in instant.stages for b in s.blocks for u in b.unknowns}
    slides = {e.slide_rate for e in instant.trial.system.tree.edges if e.joining is not None} & unknowns
    for letter in sorted(slides & asked.free_symbols, key=lambda s: s.name):
        own = next((x for x in (letter, -letter) if instant.value.is_zero(asked - x)), None)
        if own is not None and not asked.is_Symbol and isinstance(own, sp.Expr):
            return replace(found, asked=(own,))
    return found
