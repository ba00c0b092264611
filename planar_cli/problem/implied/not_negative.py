"""Constants under `unknowns` that can not be negative: friction, sizes, masses, springs, forces that may turn, and what
stands squared only.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from planar_cli.problem.checks.unused import names_of
from planar_cli.problem.language.expression import Binary, Extreme, Name, Number, Quantity, Scaled
from planar_cli.problem.language.walk import Tree, children, walk
from planar_cli.problem.scene.scene import Body, Circle, Composite, Polar, Problem, Shape, TwoFacts
from planar_cli.problem.scene.shapes import rim_of

FRICTION = ("mu", "mu_s", "mu_k", "friction", "friction_torque")
"""Keys of joints that say how much friction there is at most."""
COEFFICIENTS = {"mu": "friction", "mu_s": "friction", "mu_k": "friction", "restitution": "rebound"}
"""Keys of joints for coefficients, with what there is none of where they are zero."""
RATES = ("stiffness", "coefficient", "natural_length", "linear", "quadratic")
"""Keys of springs, dampers and drags."""
SIZES = ("radius", "hub", "width", "height", "length")
AMOUNTS = ("mass", "weight", "inertia", "gyration")
"""Of a part of a body they may be negative: those of a hole are."""


def limits_of_friction(problem: Problem) -> frozenset[str]:
    """The names of the unknowns that say alone how much friction there is at most."""
    return _sought(problem, (getattr(j, key, None) for j in problem.joints for key in FRICTION))


def with_coefficients(problem: Problem) -> Problem:
    """The letters that stand alone for coefficients of friction or restitution are marked: both are below one."""
    sides = ((getattr(joint, key, None), of) for joint in problem.joints for key, of in COEFFICIENTS.items())
    named = {side.name: of for side, of in sides if isinstance(side, Name)}
    if not named:
        return problem
    return replace(problem, symbols=tuple(replace(s, coefficient=named.get(s.name, "")) for s in problem.symbols))


def not_negative(problem: Problem) -> frozenset[str]:
    """The names of the unknowns that stand alone for friction, for a size, for a mass, for a spring or a damper, or for
    a force of which the direction is sought as well; or for what the resistance of the air is in proportion to. Of what
    stands squared only, such as a speed in v^2/rho, the size is meant.
    """
    amounts = (getattr(body, key) for body in problem.bodies for key in AMOUNTS)
    sizes = (getattr(shape, key, None) for body in problem.bodies for shape in _shapes(body) for key in SIZES)
    rates = (getattr(load, key, None) for load in problem.loads for key in RATES)
    braking = (n for d in problem.loads if d.opposes for n in _in_proportion(getattr(d, "magnitude", None)))
    named = _sought(problem, (*amounts, *sizes, *rates, *_turned(problem), *braking))
    return limits_of_friction(problem) | named | _squared(problem)


def distances(problem: Problem) -> frozenset[str]:
    """The names that stand alone for the distance of two points or for the radius of a circle, coordinates too."""
    places = [p.place for p in problem.points]
    found: list[object] = [d for place in places if isinstance(place, TwoFacts) for _, d in place.distances]
    found += [place.distance for place in places if isinstance(place, Polar)]
    found += [s.shape.radius for s in problem.surfaces if isinstance(s.shape, Circle)]
    return frozenset(side.name for side in found if isinstance(side, Name))


def _squared(problem: Problem) -> frozenset[str]:
    """The names of the unknowns that all which is said of the scene holds in even powers alone."""
    stated = [*problem.assume, *(law.statement for law in problem.motion), *(problem.instant or ())]
    stated += [s for state in problem.states for s in state.relations]
    # `v is smallest` asks for v, and says nothing of its sign.
    said = [s for s in stated if not (isinstance(s, Extreme) and isinstance(s.side, Name))]
    scene = (problem.points, problem.surfaces, problem.bodies, problem.joints, problem.loads)
    values = [s.value for s in problem.given]
    squares = [node for s in said for node in walk(s) if _is_square(node)]
    held = {name for square in squares for name in names_of(square)}
    plain = names_of((scene, values)) | {name for s in said for name in _outside_squares(s)}
    return frozenset((held - plain) & {u.name for u in problem.unknowns})


def _is_square(node: object) -> bool:
    match node:
        case Binary(operator="^", left=Name(), right=Number(value=power, unit=None)):
            return power.denominator == 1 and power.numerator % 2 == 0
    return False


def _outside_squares(tree: Tree) -> Iterator[str]:
    """The names in a tree, less those that stand in an even power."""
    if _is_square(tree):
        return
    if isinstance(tree, Name):
        yield tree.name
    for child in children(tree):
        yield from _outside_squares(child)


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
