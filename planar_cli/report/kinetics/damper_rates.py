"""How fast the length of a slanting damper changes: the part of the velocity of its end along it, before its force."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.system.system import System
from planar_cli.loads.base import Load
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Equation, Line, Name, line
from planar_cli.report.kinematics.geometry import measured
from planar_cli.report.words.words import Phrases
from planar_cli.units import LENGTH, VELOCITY

LONGEST = 6
"""A longer formula of the rate says no more than the force does."""


def rate_of_length(symbol: sp.Symbol, force: sp.Expr, system: System, phrases: Phrases) -> Iterator[Equation]:
    """The length and its rate of the damper whose pull has a letter: √(1.2² + 0.5²) = 1.3 m, 12/13 v_P = 1.4 m/s."""
    own = next((w for w in system.wrenches if w.kind == "damper" and w.magnitude == symbol), None)
    load = next((x for x in system.scene.problem.loads if own is not None and x.name == own.name), None)
    between, coefficient = getattr(load, "between", ()), getattr(load, "coefficient", None)
    if load is None or not between or coefficient is None or phrases.symbolic:
        return
    scene = system.scene
    start, end = (scene.points[p] for p in between)
    reach = end - start
    rate = simplified(force / scene.value(coefficient))
    squares = (sp.Pow(abs(part), 2, evaluate=False) for part in (reach.x, reach.y))
    length = measured(sp.Pow(sp.Add(*squares, evaluate=False), sp.Rational(1, 2), evaluate=False), phrases)
    if length is None or longer(rate, LONGEST) or any(phrases.value.known(s) is None for s in rate.free_symbols):
        return
    size = phrases.of_dimension(phrases.value(scene.length(reach)), LENGTH)
    number = phrases.value(rate)
    value = phrases.of_dimension(number, VELOCITY)
    sense = "it pulls" if number > 0 else "it pushes"
    yield Equation((length, size), None, line(f"length of {load.called}:"))
    sides: list[Any] = [phrases.math(rate), *phrases.substituted(rate, value), value]
    yield Equation(tuple(sides), None, line("rate of its length, ", *_part(load, scene.owner), ":"), line(sense))


def _part(load: Load, owner: Callable[[str], str]) -> Line:
    """`v_P along WP`, where one end is at rest."""
    ends: tuple[str, ...] = getattr(load, "between", ())
    moving = [p for p in ends if owner(p) != GROUND]
    if len(moving) != 1:
        return line("the relative velocity of its ends along it")
    return line(Name(f"v_{moving[0]}"), f" along {''.join(ends)}")
