"""The acceleration of a particle whose place is a sum of coordinates, before it stands in an equation of forces."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.scene.centres import centre_of
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.given.written_places import LONGEST
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution


def sums_of_rates(instant: InstantSolution, stage: Stage, phrases: Phrases) -> Iterator[Block]:
    """y_A = s - z differentiated twice: a_Ay = s̈ - z̈, of each that the kinetic diagram has as such a sum."""
    scene = instant.instant.scene
    for body, components in stage.accelerations.items():
        model = scene.bodies[body]
        point = centre_of(scene, body)
        formula = scene.formulas.get(point)
        if formula is None or model.rigid or len(components) != 1:
            continue
        direction, rate = components[0]
        axis = "x" if direction.y == 0 else "y" if direction.x == 0 else ""
        place = sp.sympify(getattr(formula, axis).value) if axis else sp.S.Zero
        terms = sp.Add.make_args(sp.sympify(rate))
        if not place.is_Add or longer(place, LONGEST) or len(terms) < 2 or not all(t.free_symbols for t in terms):
            continue
        yield Paragraph(line(Name(f"{axis}_{point}"), " = ", phrases.math(place), " differentiated twice:"))
        own = rate if getattr(direction, axis) > 0 else -rate
        yield Equation((line(Name(f"a_{point}{axis}")), phrases.math(own)))
