"""Where a component along a line is positive, `a(crate).along(beta)` in the direction beta; and the straight lines of a
problem, along which students tell a direction in words: down the slope.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from planar_cli.homework.typed.typed_formula import value_of
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.problem.language.expression import Binary, Name, Negate, Number, PointPair, Quantity, Side
from planar_cli.problem.scene.scene import Line, Problem
from planar_cli.replay.equations import Equations

NEARLY = 1e-9
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
    found = _value(part.direction, equations, own)
    return None if found is None else found + AHEAD[part.kind]


def lines_of(problem: Problem, equations: Equations | None, own: Mapping[str, float]) -> tuple[float, ...]:
    """The directions of straight surfaces and fixed guides, in radians from +x, each once and none that points left."""
    shapes = (s.shape for s in problem.surfaces if s.body is None)
    angles = [s.angle for s in shapes if isinstance(s, Line)]
    angles += [
        side for j in problem.joints if isinstance(side := getattr(j, "along", None), Number | Name | Binary | Negate)
    ]
    if equations is None:
        return ()
    found = (_value(a, equations, own) for a in angles)
    return tuple(dict.fromkeys(_to_the_right(f) for f in found if f is not None))


def _value(side: Side, equations: Equations, own: Mapping[str, float]) -> float | None:
    numbers = {n: equations.value[s] for n, s in equations.inputs.items() if s in equations.value} | dict(own)
    try:
        found = value_of(side, numbers)
    except Unreadable:
        return None
    return found if math.isfinite(found) else None


def _to_the_right(angle: float) -> float:
    """The direction of the same line that lies between down and up, up included."""
    turned = math.remainder(angle, math.pi)
    return math.pi / 2 if turned <= -math.pi / 2 + NEARLY else turned
