"""What is driven along a fixed groove r(θ) by a rod that turns about the pole: how r changes tells how fast it slides
on the rod, with no components.

    r = f(θ),   ṙ = f′ ω,   r̈ = f″ ω² + f′ α
    tan ψ = r/(dr/dθ), the angle from the radius to the tangent of the groove

(An Introduction to Planar Dynamics, 1.3.)
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.scene.curves import curve_formula
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.facts import Joining, Push
from planar_cli.problem.scene.scene import GROUND, Curve
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Value, line
from planar_cli.report.kinematics.component_sums import Term, sum_of_products
from planar_cli.report.kinematics.polar_parts import COMPONENTS
from planar_cli.report.kinematics.polar_slides import LETTERS
from planar_cli.report.kinematics.told import Told
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.enough_figures import DEGREE
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.tangent_angle import TANGENT
from planar_cli.solve.instant.written import Written
from planar_cli.units import ACCELERATION, LENGTH, PURE, VELOCITY


@record
class Groove:
    """A point on a rod through the pole and in a groove r = `radius`(`angle`). `sense`: 1 where its rate along the rod
    counts outward; `turned`: the angle θ of the rod, rad; `spin`, `gain`: ω and α of the rod.
    """

    place: str
    rod: str
    pole: str
    name: str
    angle: sp.Symbol
    radius: sp.Expr
    sense: int
    turned: Decimal
    spin: sp.Expr
    gain: sp.Expr


def groove_told(w: Written, stage: Stage, told: Told, number: int) -> list[Block]:
    """The lines of one relation, of velocities or of accelerations; empty: it is about something else."""
    if w.source != "closure" or told.phrases.symbolic:
        return []
    joining = next((j for j in told.system.tree.closures if j.joint == w.lead and j.place == w.place), None)
    found = None if joining is None else _groove(told, joining)
    result = next((x for b in stage.blocks for x in b.lines if x.equations == (w.number,) and not x.letters), None)
    if joining is None or found is None or result is None:
        return []
    edge = next(e for e in told.system.tree.edges if e.body == joining.mover)
    key = f"groove {joining.place}"
    if result.symbol == edge.slide:
        told.valued.add(key)
        return list(_velocity(found, result, told.phrases, number))
    # Where something else tells how fast it slides, r has no line.
    if result.symbol != edge.slide_rate or key not in told.valued:
        return []
    told.valued.add(TANGENT)
    return list(_acceleration(found, result, told.phrases, number))


def _groove(told: Told, joining: Joining) -> Groove | None:
    scene, motion, edges = told.system.scene, told.motion, {e.body: e for e in told.system.tree.edges}
    edge = edges.get(joining.mover)
    joint = next((j for j in scene.problem.joints if j.name == joining.joint), None)
    along = getattr(joint, "along", None)
    surface = scene.surfaces.get(getattr(along, "name", along) or "")
    if edge is None or surface is None or surface.body is not None or joining.base != GROUND:
        return None
    shape = surface.shape
    if not isinstance(shape, Curve) or shape.kind != "r" or not _turns_about_pole(edge, edges):
        return None
    assert edge.joining is not None
    assert edge.joining.path is not None
    phrases, at, way = told.phrases, joining.point, edge.joining.path.tangent
    if not phrases.value.is_zero(at.cross(way)):
        return None
    angle, radius = curve_formula(scene, shape)
    spin, gain = motion.velocities[edge.parent].angular, motion.accelerations[edge.parent].angular
    pole = edges[edge.parent].joining
    assert pole is not None
    sense = 1 if phrases.certain(at.dot(way)) > 0 else -1
    turned = phrases.value(sp.atan2(at.y, at.x))
    letters = radius.free_symbols - {angle}
    if not all(phrases.has_numbers(s) for s in letters) or phrases.value.is_zero(spin):
        return None
    if angle not in scene.ledger.units or not is_clean(scene.ledger, radius, dimension=LENGTH):
        return None
    if not phrases.value.is_zero(radius.xreplace({angle: sp.atan2(at.y, at.x)}) ** 2 - at.dot(at)):
        return None
    return Groove(joining.place, edge.parent, pole.place, surface.name, angle, radius, sense, turned, spin, gain)


def _turns_about_pole(edge: Edge, edges: dict[str, Edge]) -> bool:
    """Does it slide along a straight line of a body that turns about the origin of the axes?"""
    straight = edge.joining is not None and edge.joining.path is not None and edge.joining.path.curvature == 0
    rod = edges.get(edge.parent)
    if not straight or rod is None or rod.joining is None or rod.parent != GROUND:
        return False
    return rod.joining.only_turns and (rod.joining.point.x, rod.joining.point.y) == (0, 0)


def _velocity(g: Groove, result: SolvedLine, phrases: Phrases, number: int) -> Iterator[Block]:
    words = f"{g.place} slides along {g.rod}, which turns about {g.pole}, and along {g.name}; "
    yield Paragraph(line(words, Name("r"), f" = {g.pole}{g.place}:"))
    sizes = _sizes(g, phrases)
    length = phrases.of_dimension(phrases.value.extended(sizes)(g.radius), LENGTH)
    yield Equation((line(Name("r")), phrases.math(g.radius), *_numbers(g.radius, sizes, phrases), length))
    rate = sp.diff(g.radius, g.angle) * g.spin
    yield _rate(g, result, rate, Name("r_dot"), (phrases, VELOCITY), number)


def _acceleration(g: Groove, result: SolvedLine, phrases: Phrases, number: int) -> Iterator[Block]:
    slope = sp.diff(g.radius, g.angle)
    rate = sp.diff(slope, g.angle) * g.spin**2
    if not phrases.value.is_zero(g.gain):
        rate += slope * g.gain
    yield _rate(g, result, rate, Name("r_ddot"), (phrases, ACCELERATION), number)
    yield from _components(g, result, phrases)
    sizes = _sizes(g, phrases)
    value = phrases.value.extended(sizes)
    if value.is_zero(slope):
        return
    quotient = g.radius / slope
    angle = sp.atan(quotient) if value(quotient) > 0 else sp.pi + sp.atan(quotient)

    def pure(size: sp.Expr) -> Value:
        return phrases.of_dimension(value(size), PURE)

    degrees = phrases.of_dimension(value(angle) / DEGREE, PURE)
    tangent = line("tan ", Name("psi"))
    formula = line(Name("r"), "/(d", Name("r"), "/d", Name("theta"), ") = ", phrases.math(quotient))
    yield Equation(
        (tangent, formula, *_numbers(quotient, sizes, phrases), phrases.of_dimension(value(quotient), PURE)),
        None,
        note=line(
            Name("psi"),
            " = ",
            degrees,
            f"°, from {g.pole}{g.place} to the tangent of {g.name}; ",
            "sin ",
            Name("psi"),
            " = ",
            pure(sp.sin(angle)),
            ", cos ",
            Name("psi"),
            " = ",
            pure(sp.cos(angle)),
        ),
    )


def _components(g: Groove, result: SolvedLine, phrases: Phrases) -> Iterator[Block]:
    """a_r = r̈ - r ω² and a_θ = r α + 2 ṙ ω with their numbers, where the equations have these letters."""
    if not all(phrases.value.known(s) is not None for s in COMPONENTS):
        return
    r, r_dot, r_ddot = LETTERS
    spin = [(g.spin, phrases.certain(g.spin)), (g.gain, phrases.certain(g.gain))]
    length = phrases.of_dimension(phrases.value.extended(_sizes(g, phrases))(g.radius), LENGTH).number
    slope = phrases.value.extended(_sizes(g, phrases))(sp.diff(g.radius, g.angle) * g.spin)
    slide = phrases.of_dimension(slope, VELOCITY).number
    rate = phrases.of_dimension(phrases.value(result.symbol), ACCELERATION).number
    (omega, turns), (alpha, gains) = spin
    outward = sp.Add(r_ddot, -r * omega**2, evaluate=False)
    across = sp.Add(r * alpha, 2 * r_dot * omega, evaluate=False) if gains else 2 * r_dot * omega
    terms: tuple[list[Term], list[Term]] = (
        [(1, ((rate, 1),)), (-1, ((length, 1), (turns, 2)))],
        [*([(1, ((length, 1), (gains, 1)))] if gains else []), (1, ((Decimal(2), 1), (slide, 1), (turns, 1)))],
    )
    for letter, formula, parts in zip(COMPONENTS, (outward, across), terms, strict=True):
        value = phrases.of_dimension(phrases.value(letter), ACCELERATION)
        steady = line("θ̈ = 0") if letter == COMPONENTS[1] and not gains else ()
        yield Equation((Math(letter), Math(formula), sum_of_products(parts, phrases.figures), value), note=steady)


def normal_to(scene: Scene, push: Push) -> str:
    """What the force of a groove r(θ) is normal to, beside its arrow: it is neither along the radius nor across it."""
    joint = next((j for j in scene.problem.joints if j.name == push.joint), None)
    along = getattr(joint, "along", None)
    surface = scene.surfaces.get(getattr(along, "name", along) or "")
    shape = surface.shape if surface is not None and push.kind == "normal" else None
    if surface is None or not isinstance(shape, Curve) or shape.kind != "r":
        return ""
    return f" (normal to {surface.name})"


def _rate(g: Groove, result: SolvedLine, rate: sp.Expr, letter: Name, by: tuple[Phrases, Any], number: int) -> Equation:
    """v_P,rod = ṙ = formula = numbers = value."""
    phrases, dimension = by
    sizes = _sizes(g, phrases)
    value = phrases.of_dimension(g.sense * phrases.value.extended(sizes)(rate), dimension)
    named: Line = line("" if g.sense > 0 else "-", letter)
    signed = g.sense * rate
    return Equation(
        (phrases.math(result.symbol), named, phrases.math(signed), *_numbers(signed, sizes, phrases), value), number
    )


def _sizes(g: Groove, phrases: Phrases) -> dict[sp.Symbol, Decimal]:
    inside = [s for s in (g.spin, g.gain) if isinstance(s, sp.Symbol)]
    return {g.angle: g.turned, **{s: phrases.value(s) for s in inside}}


def _numbers(formula: sp.Expr, sizes: dict[sp.Symbol, Decimal], phrases: Phrases) -> list[Any]:
    known = {s: sizes.get(s, phrases.value.known(s)) for s in formula.free_symbols}
    put = phrases.numbers(formula, {s: n for s, n in known.items() if n is not None})
    return [] if put is None else [put]
