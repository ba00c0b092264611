"""A check that a person can make of a point on a fixed curve y = f(x): the equation of the curve, differentiated twice.

ÿ = y″ ẋ² + y′ ẍ = (0.2/m) v² - (0.16/m) v² = (0.04/m) v²

The page works with ρ and the components along and across the path.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.equation.scene.curves import curve_formula
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.exact import Unvalued
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND, Curve
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.swallowed import with_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import ACCELERATION

LONGEST = 12
"""Operations in one term."""


def track_check(part: PartSolution, phrases: Phrases) -> Line:
    """Of the first point whose acceleration is asked for on such a curve; empty where there is none, or the curve is
    level there.
    """
    if part.motion is not None or not part.instants or not any(_is_acceleration(f) for f in part.found):
        return ()
    instant = part.instants[-1]
    motion = instant.trial.system.motion
    joinings = [j for mode in instant.trial.system.modes.values() for j in mode.facts.joinings]
    for j in joinings if motion is not None else ():
        shape = _shape(j, instant.instant.scene)
        if shape is None:
            continue
        try:
            told = _told(instant, j, shape, phrases)
        except Unvalued:
            continue
        if told:
            return told
    return ()


def _is_acceleration(found: object) -> bool:
    find = getattr(found, "find", None)
    return find is not None and getattr(find.found.what, "word", "") == "a"


def _shape(j: Joining, scene: Scene) -> Curve | None:
    """The curve y = f(x), fixed to the ground, along which a point slides."""
    joint = next((x for x in scene.problem.joints if x.name == j.joint), None)
    named = (getattr(joint, "along", ""), *getattr(joint, "between", ()))
    surface = next((s for n in named if isinstance(n, str) and (s := scene.surfaces.get(n))), None)
    if j.path is None or j.base != GROUND or surface is None or surface.body is not None:
        return None
    return surface.shape if isinstance(surface.shape, Curve) and surface.shape.kind == "y" else None


def _told(instant: InstantSolution, j: Joining, shape: Curve, phrases: Phrases) -> Line:
    motion, scene = instant.trial.system.motion, instant.instant.scene
    assert motion is not None
    x, formula = curve_formula(scene, shape)
    slope, bend = (simplified(sp.diff(formula, x, n)).xreplace({x: j.point.x}) for n in (1, 2))
    if slope.has(sp.Piecewise) or bend.has(sp.Piecewise):
        return ()
    v, a = motion.velocity(j.point, j.mover), motion.acceleration(j.point, j.mover)
    closed = {s: e for stage in instant.stages for s, e in stage.algebra.formulas.items()}
    terms = [sp.sympify(e).xreplace(closed) for e in (bend * v.x**2, slope * a.x)]
    whole = sp.sympify(a.y).xreplace(closed)
    twice = "the equation of the curve, differentiated twice: "
    head = line(
        twice, Math(sp.Symbol("y_ddot")), " = y″ ", Math(sp.Symbol("x_dot") ** 2), " + y′ ", Math(sp.Symbol("x_ddot"))
    )
    if not phrases.symbolic:
        numbers, result = [phrases.certain(t) for t in terms], phrases.certain(whole)
        if len(counting(numbers)) < 2 or not agree(numbers, [result]):
            return ()
        return line(*head, " = ", *_in_numbers(numbers, phrases))
    terms, whole = [simplified(t) for t in terms], simplified(whole)
    if 0 in terms or any(longer(e, LONGEST) for e in (*terms, whole)) or not identically_zero(sp.Add(*terms) - whole):
        return ()
    one, other, result_told = (_in_letters(e, phrases) for e in (terms[0], _bare(terms[1]), whole))
    return line(*head, " = ", one, " - " if terms[1].could_extract_minus_sign() else " + ", other, " = ", result_told)


def _bare(term: sp.Expr) -> sp.Expr:
    """The term without its minus sign."""
    return -term if term.could_extract_minus_sign() else term


def _in_numbers(numbers: list[Decimal], phrases: Phrases) -> Line:
    return line(*chain(numbers, coherent_unit(ACCELERATION, False, phrases.ledger.us), phrases))


def _in_letters(expr: sp.Expr, phrases: Phrases) -> Math:
    return with_unit(expr, ACCELERATION, phrases.ledger, phrases.figures) or phrases.math(expr)
