"""A start on the other side: places that the file writes with coordinates fit twice, and an inequality chooses."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from planar_cli.motion.regime.model import Model
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.terms.zeros import AGREES, Equation, Zeros
from planar_cli.problem.scene.scene import Round


def open_terms(model: Model) -> list[Term]:
    """The places that nothing tells: coordinates, particles that are free, and how far a wheel has turned of which only
    the centre is drawn.
    """
    scene = model.scene
    wheels = (b.name for b in scene.problem.bodies if isinstance(b.shape, Round) and not b.points)
    found = [theta for name in wheels if (theta := scene.places[name].theta) is not None]
    for name in sorted(scene.reference.open):
        if name in model.layout.frames:
            found += [scene.places[name].x, scene.places[name].y]
        else:
            found.append(scene.coordinates[name][0])
    return found


def to_the_other_side(zeros: Zeros, model: Model, equations: Sequence[Equation], holds: Callable[[], bool]) -> None:
    """Leaves in `zeros` places for which the inequalities hold, where those that were found lie on their wrong side.

    What the drawing leaves open is taken to the other side of its zero, one after the other, with the places that have
    the same number, and from there the `equations` are fulfilled again.
    """
    if holds():
        return
    found, numbers, free = list(zeros.state), range(model.layout.count), open_terms(model)
    for value in zeros.numbers(tuple(free)):
        with_it = [n for n in numbers if abs(abs(found[n]) - abs(value)) <= AGREES * zeros.sizes[n]]
        zeros.state = [-v if n in with_it else v for n, v in enumerate(found)]
        if zeros.solved(equations, numbers) and holds():
            return
    zeros.state = found
