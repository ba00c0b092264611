"""How long a vector of an acceleration is that is no unit vector: a formula, the name of a distance, or a number."""

from __future__ import annotations

from decimal import Decimal
from itertools import product
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.recognised import recognised
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import LENGTH

SHORT = 3
"""A distance of more operations is given by its name or its number."""


def drawn_length(direction: Vec, instant: InstantSolution, body: str, phrases: Phrases) -> sp.Expr:
    """The length of a direction that is no unit vector: a formula, or a number."""
    square = sp.sympify(direction.dot(direction))
    if square == 1 or abs(phrases.value(square) - 1) < Decimal("1e-30"):
        return sp.S.One
    formula = sp.sqrt(factored(simplified(square)))
    if phrases.symbolic:
        return formula
    value = instant.value
    formula = formula.replace(
        lambda e: isinstance(e, sp.Abs), lambda e: e.args[0] if value(e.args[0]) > 0 else -e.args[0]
    )
    short = not longer(formula, SHORT) and not formula.could_extract_minus_sign()
    if short and is_clean(phrases.ledger, formula, dimension=LENGTH):
        return formula
    plain = recognised(formula, phrases.ledger, value)
    if plain is not None and plain.free_symbols:
        return plain
    return sp.Rational(str(phrases.value(square).sqrt()))


def distance_drawn(direction: Vec, turning: sp.Expr, instant: InstantSolution, body: str) -> sp.Symbol | None:
    """AG or AB of a direction that is the arm from one point of the turning body to another, or that arm turned."""
    scene, value, motion = instant.instant.scene, instant.value, instant.trial.system.motion
    assert motion is not None
    rates = {b: (motion.accelerations[b].angular, motion.velocities[b].angular) for b in scene.bodies}
    bodies = [b for b, (alpha, omega) in rates.items() if turning in (alpha, -alpha, omega**2)]
    for owner in sorted(bodies, key=lambda b: b != body):
        own = {n: p for n, p in scene.points.items() if owner in scene.owners.get(n, ()) and "_" not in n}
        ends = {centre_of(scene, owner): scene.center(owner), centre_of(scene, body): scene.center(body), **own}
        found = [e for e in ends.items() if _same(e[1], scene.center(body), value)]
        for (start, here), (end, there) in (*product(own.items(), found), *product(own.items(), ends.items())):
            arm = there - here
            if any(_same(way, direction, value) for way in (arm, -arm, arm.turned(), -arm.turned())):
                return sp.Symbol(f"{start}{end}", positive=True)
    return None


def _same(one: Vec, other: Vec, value: Any) -> bool:
    return all(value.is_zero(getattr(one, a) - getattr(other, a)) for a in ("x", "y"))
