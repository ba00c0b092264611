"""Where a component along a line is positive: `a(crate).along(beta)` in the direction beta."""

from __future__ import annotations

import math
from collections.abc import Mapping

from planar_cli.homework.typed_formula import value_of
from planar_cli.homework.unreadable import Unreadable
from planar_cli.problem.expression import PointPair, Quantity
from planar_cli.replay.equations import Equations

AHEAD = {"along": 0.0, "across": math.pi / 2}


def heading_of(what: object, equations: Equations | None, own: Mapping[str, float]) -> float | None:
    """In radians from +x; None: it is no such component, or its line turns. `own`: the data of a variant, by their
    names, in base units; the others have the numbers of the file.
    """
    if not isinstance(what, Quantity) or not what.parts or equations is None:
        return None
    part = what.parts[-1]
    if part.kind not in AHEAD or part.direction is None or isinstance(part.direction, PointPair):
        return None
    numbers = {n: equations.value[s] for n, s in equations.inputs.items() if s in equations.value} | dict(own)
    try:
        found = value_of(part.direction, numbers)
    except Unreadable:
        return None
    return found + AHEAD[part.kind] if math.isfinite(found) else None
