"""The size of a reaction that has one direction is its letter: √(N² sin² θ + N² cos² θ) is N, where that presses."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.language.expression import Quantity
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution


def with_single_forces(part: PartSolution) -> PartSolution:
    """The part of one instant with the sizes that are asked of such reactions told by their letters."""
    if part.motion is not None or not part.instants:
        return part
    last = part.instants[-1]
    forces = set(last.trial.system.symbols.values())
    return replace(part, found=tuple(_told(f, forces, last.value) for f in part.found))


def _told(found: Found, forces: Collection[sp.Symbol], value: Valuation) -> Found:
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.word != "reaction" or len(found.asked) != 1:
        return found
    (size,) = found.asked
    inside = size.free_symbols & set(forces)
    if size.is_Symbol or len(inside) != 1 or not what.parts or what.parts[-1].kind != "mag":
        return found
    (force,) = inside
    number = value.known(force)
    if not number or not value.is_zero(size - (force if number > 0 else -force)):
        return found
    return replace(found, asked=(force if number > 0 else -force,))
