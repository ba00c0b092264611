"""The acceleration of a point at a state, in letters, as it stands in the diagram of its body:

a_G,BC = a_B + α_BC × r_G,BC/B - ω_BC² r_G,BC/B = [-3/2 l ω_AB², 1/2 l α_AB]
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Name, Text, line
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution

LONGEST = 8
"""A component of more operations is not told."""
MOST = 30
"""Nor is one put together that is longer than so many at any place."""
Letters = Mapping[sp.Symbol, sp.Expr]


def with_components(block: Block, instant: InstantSolution, at: Letters, known: Letters, phrases: Phrases) -> Block:
    """The vector equation of a point with its components; others as they are. `at`: what is known at the state;
    `known`: α_BC = -α_AB.
    """
    if not isinstance(block, Equation) or len(block.sides) != 2 or not isinstance(block.sides[1], tuple):
        return block
    name = block.sides[0][0] if isinstance(block.sides[0], tuple) and len(block.sides[0]) == 1 else None
    turns = any(isinstance(p, Text) and "×" in p.text for p in block.sides[1])
    if not isinstance(name, Name) or not turns:
        return block
    a = next((a for own, a in _accelerations(instant, name.name) if own == name.name), None)
    if a is None or any(longer(p, MOST) for p in (a.x, a.y)):
        return block
    x, y = (simplified(sp.sympify(p).xreplace(dict(at)).xreplace(dict(known))) for p in (a.x, a.y))
    if any(longer(p, LONGEST) for p in (x, y)):
        return block
    told = line("[", phrases.math(x), ", ", phrases.math(y), "]")
    return replace(block, sides=(*block.sides, told))


def _accelerations(instant: InstantSolution, name: str) -> Iterator[tuple[str, Vec]]:
    """Those of the mass centres and points of bodies, by their names a_B and a_G,AB."""
    scene, motion = instant.instant.scene, instant.trial.system.motion
    for body in scene.bodies if motion is not None else ():
        if f"a_{index_of(centre_of(scene, body))}" == name and motion is not None:
            yield name, motion.acceleration(scene.center(body), body)
    for point, owners in scene.owners.items() if motion is not None else ():
        if f"a_{index_of(point)}" == name and motion is not None:
            for body in owners:
                yield name, motion.acceleration(scene.point(point), body)
