"""Constants under `unknowns` that can not be negative: friction, sizes, masses, springs, forces that may turn."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from planar_cli.problem.expression import Binary, Name, Number, Quantity, Scaled
from planar_cli.problem.scene import Body, Composite, Problem, Shape
from planar_cli.problem.shapes import rim_of
from planar_cli.problem.walk import walk

FRICTION = ("mu", "mu_s", "mu_k", "friction", "friction_torque")
"""Keys of joints that say how much friction there is at most."""
COEFFICIENTS = ("mu", "mu_s", "mu_k")
RATES = ("stiffness", "coefficient", "natural_length", "linear", "quadratic")
"""Keys of springs, dampers and drags."""
SIZES = ("radius", "hub", "width", "height", "length")
AMOUNTS = ("mass", "weight", "inertia", "gyration")
"""Of a part of a body they may be negative: those of a hole are."""


def limits_of_friction(problem: Problem) -> frozenset[str]:
    """The names of the unknowns that say alone how much friction there is at most."""
    return _sought(problem, (getattr(j, key, None) for j in problem.joints for key in FRICTION))


def coefficients_in_letters(problem: Problem) -> frozenset[str]:
    """The names of the letters that stand alone for coefficients of friction."""
    named = {s.name for j in problem.joints for k in COEFFICIENTS if isinstance(s := getattr(j, k, None), Name)}
    return frozenset(named & {symbol.name for symbol in problem.symbols})


def not_negative(problem: Problem) -> frozenset[str]:
    """The names of the unknowns that stand alone for friction, for a size, for a mass, for a spring or a damper, or for
    a force of which the direction is sought as well; or for what the resistance of the air is in proportion to.
    """
    amounts = (getattr(body, key) for body in problem.bodies for key in AMOUNTS)
    sizes = (getattr(shape, key, None) for body in problem.bodies for shape in _shapes(body) for key in SIZES)
    rates = (getattr(load, key, None) for load in problem.loads for key in RATES)
    braking = (n for d in problem.loads if d.opposes for n in _in_proportion(getattr(d, "magnitude", None)))
    return limits_of_friction(problem) | _sought(problem, (*amounts, *sizes, *rates, *_turned(problem), *braking))


def _in_proportion(side: object) -> tuple[Name, ...]:
    """The name in `c*v(b).mag^2/2`, where all other factors are numbers above zero and sizes; else nothing."""
    factors = tuple(_factors(side))
    names = tuple(f for f in factors if isinstance(f, Name))
    positive = ((isinstance(f, Number) and f.value * f.sense > 0) or _is_size(f) for f in factors if f not in names)
    return names if len(names) == 1 and all(positive) else ()


def _factors(side: object) -> Iterator[object]:
    match side:
        case Binary(operator="*" | "/", left=left, right=right):
            yield from _factors(left)
            yield from _factors(right)
        case Scaled(operand=operand, sense=1):
            yield from _factors(operand)
        case Binary(operator="^", left=left, right=Number()):
            yield left
        case _:
            yield side


def _is_size(side: object) -> bool:
    return isinstance(side, Quantity) and bool(side.parts) and side.parts[-1].kind == "mag"


def _turned(problem: Problem) -> Iterable[object]:
    """The magnitudes of forces that a sought angle may turn round: with a minus they would be the same once more."""
    sought = {u.name for u in problem.unknowns}
    for load in problem.loads:
        angle = getattr(load, "angle", None)
        if angle is not None and any(isinstance(n, Name) and n.name in sought for n in walk(angle)):
            yield getattr(load, "magnitude", None)


def _shapes(body: Body) -> Iterable[Shape]:
    if isinstance(body.shape, Composite):
        return [p.shape for p in body.shape.pieces]
    return [rim_of(body.shape) or body.shape]


def _sought(problem: Problem, sides: Iterable[object]) -> frozenset[str]:
    named = {side.name for side in sides if isinstance(side, Name)}
    return frozenset(named & {u.name for u in problem.unknowns})
