"""Points whose places the file gives by formulas: what stands before their velocities and accelerations."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.scene.scene import Scene
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written

LONGEST = 12
"""A coordinate of more operations is not repeated."""


def differentiated(w: Written, level: str, scene: Scene, phrases: Phrases) -> Line:
    """A point whose place the file gives by a formula: its components are differentiated."""
    formula = scene.formulas[w.place]
    times = "" if level == "velocity" else " twice"
    told: list[Any] = []
    for axis in ("x", "y"):
        place = sp.sympify(getattr(formula, axis).value)
        if w.words.endswith(f"along {'y' if axis == 'x' else 'x'}") or longer(place, LONGEST):
            continue
        told += [" and " if told else "", Name(f"{axis}_{w.place}"), " = ", phrases.math(place)]
    if not told:
        return line(f"The coordinates of {w.place} differentiated{times}")
    return line(*told, f" differentiated{times}")


def stated_rate(w: Written, scene: Scene, phrases: Phrases) -> Line:
    """A place that is differentiated, of which the file gives the rate; empty where it gives no component."""
    axis = next((a for a in ("x", "y") if f".{a}" in w.lead), "")
    if not axis:
        return ()
    place = phrases.math(getattr(scene.formulas[w.place], axis).value)
    return line(Name(f"{axis}_{w.place}"), " = ", place, " differentiated; given: ", *spoken(w.lead, ()), ":")
