"""What the whole system has: its mass centre, and the energy that its loads store."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.jets import Jet, constant
from planar_cli.loads.base import Load
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions


def mass_centre(bodies: Iterable[tuple[Jet, Vec]]) -> Vec:
    """Σ m r / Σ m, as jets; `bodies`: the mass of each [kg], and its place [m]."""
    heavy = [(mass, place) for mass, place in bodies if mass.value != 0]
    total = sum((mass for mass, _ in heavy), constant(sp.S.Zero))
    parts = [place * (mass / total) for mass, place in heavy]
    return sum(parts[1:], parts[0])


def energy_of_load(
    load: Load, scene: Scene, reactions: Reactions | None, velocity: Callable[[Vec, str], Vec]
) -> Jet | None:
    """What a load stores [J], and how fast: at the power that it takes. None: it stores nothing.

    `reactions`: which loads act, and with what forces; None where no force is known yet, nor that rate.
    `velocity`: of a body's point at a place.
    """
    energy = load.potential(scene)
    if energy is None:
        return None
    if reactions is None:
        return Jet(energy, None, None)
    acting = [w for w in reactions.wrenches if (w.kind, w.name) == (load.kind, load.name)]
    if not acting:
        return constant(sp.S.Zero)
    given = (w.force.dot(velocity(w.point, w.body)) for w in acting if w.force is not None)
    return Jet(energy, -sp.Add(*given), None)
