"""Whether the plane of the drawing goes round: of a car on a banked curve, of a bob on a circle, through its axis.

There all is at rest, while the file gives the acceleration towards the axis by a speed, as v²/ρ.
"""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.problem.language.expression import Binary, Name, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.units import RATE, VELOCITY, parse_unit


def goes_round(problem: Problem) -> bool:
    """Does an acceleration of the file hold the square of a speed, or of a rate of turning, that is a constant?"""
    stated = [*(problem.instant or ()), *(law.statement for law in problem.motion)]
    speeds = {s.name for s in (*problem.given, *problem.symbols, *problem.unknowns) if _is_speed(s)}
    for relation in (r for r in stated if isinstance(r, Relation) and r.operator == "="):
        for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
            if isinstance(one, Quantity) and one.word == "a" and not speeds.isdisjoint(_squared(other)):
                return True
    return False


def _is_speed(symbol: Symbol) -> bool:
    unit = symbol.value.unit if isinstance(symbol.value, Number) else symbol.unit
    return unit is not None and parse_unit(unit).dimension in (VELOCITY, RATE)


def _squared(side: Side) -> Iterator[str]:
    """The names whose squares stand in a side."""
    powers = (n for n in walk(side) if isinstance(n, Binary) and n.operator == "^")
    for power in powers:
        if isinstance(power.left, Name) and isinstance(power.right, Number) and power.right.value == 2:
            yield power.left.name
