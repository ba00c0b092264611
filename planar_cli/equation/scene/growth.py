"""Masses and moments of inertia that change with the time or with places, with their rates."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.jets import Jet, constant


def growth(scene: Scene, evaluator: Evaluator, name: str) -> tuple[Jet, Jet]:
    """Mass and moment of inertia of a body, whose formulas `evaluator` knows with their rates.

    A moment of inertia that is one number goes with the mass.
    """
    body = scene.bodies[name]
    mass, inertia = constant(body.mass), constant(body.inertia)
    if not body.varies:
        return mass, inertia
    given = next(b for b in scene.problem.bodies if b.name == name)
    if given.weight is not None:
        mass = evaluator.jet(given.weight) / constant(scene.ledger.symbols["g"])
    elif given.mass is not None:
        mass = evaluator.jet(given.mass)
    if body.inertia != 0:
        inertia = constant(body.inertia / body.mass) * mass
        told = constant(sp.S.Zero) if given.inertia is None else evaluator.jet(given.inertia)
        if told.rate != 0:
            inertia = told - constant((told.value - body.inertia) / body.mass) * mass
    return replace(mass, value=body.mass), replace(inertia, value=body.inertia)
