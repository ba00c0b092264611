"""Where velocities alone are sought, and two points of a body have known directions: its instantaneous centre.

    E moves along the wall; the perpendiculars to v_O and v_E cross at I, the instantaneous centre of rod:
    IO = √2/2 l = 0.2121 m
    ω_rod = v_O/IO = 1/0.2121 = 4.714 rad/s
    v_G,rod = IG ω_rod = 0.15 · 4.714 = 0.7071 m/s

(An Introduction to Planar Dynamics, 2.3.)
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Unvalued
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.given.given_vectors import size_of
from planar_cli.report.kinematics.centre_reasons import beside, half_of_diagonal
from planar_cli.report.kinematics.component_sums import sum_of_products
from planar_cli.report.kinematics.fixed_lines import way_along
from planar_cli.report.kinematics.told import Told
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.enough_figures import DEGREE, figures_of
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import Found as Answered
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import LENGTH, PURE, RATE, VELOCITY

CENTRE = "I"
ABOUT_CENTRE = "cross at I, the instantaneous centre of"
FROM_CENTRE = re.compile(f"{CENTRE}[A-Z]")
"""A distance from the centre."""
NEARLY = Decimal("1e-12")
SHORT = 7
"""A distance of more operations is told by its numbers alone."""


@record
class Centre:
    """The instantaneous centre of a body: `from_place` and `to` say by which points it was found; `place`: where it is,
    in metres; `letters`: the same in letters, where these are short; `spin`: ω.
    """

    body: str
    from_place: str
    to: str
    place: tuple[Decimal, Decimal]
    letters: Vec | None
    spin: sp.Symbol


@record
class Found:
    """How a centre was found. `speed`: of the first point, a letter with its sign or a formula that is positive;
    `arm`: the distance of that point, and `sine` of the angle between both directions.
    """

    centre: Centre
    speed: sp.Expr
    arm: sp.Expr
    sine: Decimal
    edge: Edge
    joining: Joining


def centre_found(w: Written, stages: Sequence[Stage], system: System, phrases: Phrases) -> Found | None:
    """Of a relation that leads the second point of a body along a fixed straight line; None: it is another relation,
    accelerations are sought as well, or the directions are parallel.
    """
    alone = all(s.level == "velocity" for s in stages)
    if not alone or phrases.symbolic or w.source != "closure" or w.along is None:
        return None
    taken = {*system.scene.points, *system.scene.ledger.symbols}
    j = next((j for j in system.tree.closures if j.joint == w.lead and j.place), None)
    edge = next((e for e in system.tree.edges if j is not None and e.body == j.mover), None)
    if j is None or edge is None or edge.joining is None or edge.spin is None or CENTRE in taken:
        return None
    if j.base != GROUND or j.path is None or j.path.curvature != 0 or j.drift is not None:
        return None
    try:
        return _found(w, edge, j, system, phrases)
    except Unvalued:
        return None


def _found(w: Written, edge: Edge, j: Joining, system: System, phrases: Phrases) -> Found | None:
    assert w.along is not None
    assert edge.spin is not None
    assert edge.joining is not None
    assert system.motion is not None
    residual, certain = sp.expand(w.residual), phrases.certain
    turning = sp.diff(residual, edge.spin)
    rest = residual.xreplace({edge.spin: sp.S.Zero})
    start = edge.joining
    if edge.joining.rolling is not None or turning.free_symbols & {*system.tree.velocity_unknowns()}:
        return None
    v = system.motion.velocity(start.point, edge.body)
    vx, vy, omega = certain(v.x), certain(v.y), certain(edge.spin)
    size = (vx * vx + vy * vy).sqrt()
    nx, ny = (certain(sp.sympify(p)) for p in w.along)
    length = (nx * nx + ny * ny).sqrt()
    if not size or not omega:
        return None
    sine = (vx * nx + vy * ny) / (size * length)
    if abs(sine) < NEARLY or not phrases.has_numbers(rest):
        return None
    speed = _letter(rest, size, phrases)
    if speed is None:
        return None
    at = (certain(start.point.x) - vy / omega, certain(start.point.y) + vx / omega)
    arm = -turning if certain(turning) < 0 else turning
    centre = Centre(
        edge.body, start.place, j.place, at, _in_letters(start.point, (vx, vy), omega, arm, sine), edge.spin
    )
    return Found(centre, speed, arm, abs(sine), edge, j)


def _letter(rest: sp.Expr, size: Decimal, phrases: Phrases) -> sp.Expr | None:
    """The known velocity whose size is that speed; None: there is none."""
    units = phrases.ledger.units
    speeds = [s for s in sorted(rest.free_symbols, key=str) if s in units and units[s].dimension == VELOCITY]
    inside = [s for s in speeds if abs(abs(phrases.certain(s)) - size) < NEARLY * size]
    return inside[0] if inside else None


def _in_letters(start: Vec, v: tuple[Decimal, Decimal], omega: Decimal, arm: sp.Expr, sine: Decimal) -> Vec | None:
    """Where both directions are those of the axes, the centre is straight beside the first point."""
    if abs(abs(sine) - 1) > NEARLY or all(v):
        return None
    sense = (1 if v[0] > 0 else -1 if v[0] < 0 else 0, 1 if v[1] > 0 else -1 if v[1] < 0 else 0)
    turn = 1 if omega > 0 else -1
    return Vec(start.x - sense[1] * turn * arm, start.y + sense[0] * turn * arm)


# --- lines -----------------------------------------------------------------------------------------------------------


def centre_told(w: Written, stages: Sequence[Stage], told: Told, number: int) -> list[Block]:
    """The centre and ω in place of the relation; nothing where it is another."""
    found = centre_found(w, stages, told.system, told.phrases)
    if found is None or found.speed in told.late:
        return []
    c, phrases = found.centre, told.phrases
    told.centres[c.body] = c
    way = f"{c.to} {way_along(found.joining, told.system, phrases)}; the perpendiculars to "
    both = line(Name(f"v_{c.from_place}"), " and ", Name(f"v_{c.to}"))
    head = Paragraph(line(way, *both, f" {ABOUT_CENTRE} {c.body}:"))
    return [head, *_arm(found, told), _rate(found, phrases, number)]


def _arm(found: Found, told: Told) -> Iterator[Block]:
    """IO, in letters or by the angle between both directions; beside it where I is."""
    c, phrases = found.centre, told.phrases
    at = line(*beside(c, told), "I = ", *phrases.vector(*c.place, LENGTH))
    size = phrases.certain(found.arm) / found.sine
    value = phrases.of_dimension(size, LENGTH)
    own = line(between(CENTRE, c.from_place))
    if abs(found.sine - 1) < NEARLY:
        sides = _lengths(found.arm, value, phrases)
        yield Equation((own, *sides, value), None, note=at)
        return
    assert found.joining.path is not None
    arm = told.system.scene.arms.between(told.motion.velocities[c.body].point, found.joining.point)
    unit = [phrases.certain(sp.sympify(p)) for p in (found.joining.path.tangent.x, found.joining.path.tangent.y)]
    reach = [phrases.of_dimension(phrases.certain(p), LENGTH).number for p in (arm.x, arm.y)]
    parts = [(1, ((r, 1), (e, 1))) for r, e in zip(reach, unit, strict=True) if r and e]
    degrees = phrases.of_dimension(phrases.value(sp.asin(sp.Rational(str(found.sine)))) / DEGREE, LENGTH).number
    turned = significant(degrees, phrases.figures)
    name = Name(f"r_{index_of(c.to)}/{index_of(c.from_place)}")
    letters = line("|", name, " · ", Name("e"), f"|/sin {turned}°")
    put = line("|", sum_of_products(parts, phrases.figures), f"|/sin {turned}°")
    way = line(Name("e"), " = ", *phrases.vector(unit[0], unit[1], PURE))
    arm_of = line(name, " = ", *phrases.vector(phrases.certain(arm.x), phrases.certain(arm.y), LENGTH))
    triangle = f"Law of sines in the triangle {c.from_place}, {c.to}, I; "
    yield Paragraph(line(triangle, *arm_of, ", ", *way, f" along the path of {c.to}:"))
    yield Equation((own, letters, put, value), None, note=at)


def _rate(found: Found, phrases: Phrases, number: int) -> Equation:
    """ω = v_O/IO = 1/0.2121 = 4.714 rad/s."""
    c = found.centre
    speed, omega = phrases.certain(found.speed), phrases.certain(c.spin)
    arm = phrases.certain(found.arm) / found.sine
    sign = "" if (speed < 0) == (omega < 0) else "-"
    letters = line(sign, phrases.math(found.speed), "/", between(CENTRE, c.from_place))
    numbers = (phrases.of_dimension(speed, VELOCITY).number, phrases.of_dimension(arm, LENGTH).number)
    put = _of_two(numbers, phrases, divided=True, minus=bool(sign))
    return Equation((phrases.math(c.spin), letters, put, phrases.of_dimension(omega, RATE, True)), number)


def speed_about(c: Centre, at: Vec, place: str, name: Line, told: Told) -> list[Equation]:
    """The distance of a point from the centre, and by that its speed. `name`: of the speed."""
    phrases = told.phrases
    x, y = phrases.certain(at.x) - c.place[0], phrases.certain(at.y) - c.place[1]
    size = (x * x + y * y).sqrt()
    own, value = between(CENTRE, place), phrases.of_dimension(size, LENGTH)
    sides: list[Any] = []
    if c.letters is not None:
        square = simplified((at.x - c.letters.x) ** 2 + (at.y - c.letters.y) ** 2)
        sides = list(_lengths(simplified(sp.sqrt(square)), value, phrases))
    oblique = min(abs(x), abs(y)) > NEARLY * size
    sides = sides or ([size_of((x, y), LENGTH, phrases)] if oblique else [])
    omega = phrases.certain(c.spin)
    turning = line("|", phrases.math(c.spin), "|") if omega < 0 else line(phrases.math(c.spin))
    numbers = (value.number, phrases.of_dimension(abs(omega), RATE, True).number)
    speed = phrases.of_dimension(size * abs(omega), VELOCITY)
    return [
        Equation((line(own), *sides, value), None, note=half_of_diagonal(c, at, _short(place), told)),
        Equation((name, line(own, " ", *turning), _of_two(numbers, phrases, divided=False), speed)),
    ]


def asked_by_centre(answer: Answered, q: Quantity, told: Told) -> list[Block]:
    """The lines of a speed, or of the centre itself, where that was found; empty of all else."""
    if answer.values is None or len(q.things) != 1:
        return []
    scene, (thing,) = told.system.scene, q.things
    values = told.phrases.in_units(answer.values[0], answer.unit)
    if q.word == "v" and [p.kind for p in q.parts] == ["mag"] and thing in scene.points:
        owners = scene.owners.get(thing, ()) or (scene.owner(thing),)
        c = next((told.centres[body] for body in owners if body in told.centres), None)
        if c is None:
            return []
        *before, last = speed_about(c, scene.point(thing), thing, line(Name(answer.name)), told)
        return [*before, replace(last, sides=(*last.sides[:-1], *values))]
    c = told.centres.get(thing) if q.word == "IC" and not q.parts else None
    if c is None:
        return []
    return [Equation((line(Name(answer.name)), line(CENTRE), told.phrases.vector(c.place[0], c.place[1], LENGTH)))]


def bodies_by_centre(instant: InstantSolution, phrases: Phrases) -> set[str]:
    """Of which bodies a page tells the instantaneous centre."""
    written = (w for s in instant.stages for b in s.blocks for w in b.equations)
    found = (centre_found(w, instant.stages, instant.trial.system, phrases) for w in written)
    return {f.centre.body for f in found if f is not None}


def _lengths(formula: sp.Expr, value: Any, phrases: Phrases) -> list[Inline | Line]:
    """A length in letters and its numbers, where it is short and its letters say it all."""
    if formula.is_number or longer(formula, SHORT) or not is_clean(phrases.ledger, formula, dimension=LENGTH):
        return []
    return [phrases.math(formula), *phrases.substituted(formula, value)]


def _of_two(numbers: tuple[Decimal, Decimal], phrases: Phrases, divided: bool, minus: bool = False) -> Math:
    figures = figures_of(numbers, lambda x: x[0] / x[1] if divided else x[0] * x[1], phrases.figures)
    letters = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in range(2)]
    texts = {s: significant(x, figures) for s, x in zip(letters, numbers, strict=True)}
    whole = letters[0] / letters[1] if divided else sp.Mul(*letters, evaluate=False)
    return Math(-whole if minus else whole, texts)


def between(start: str, end: str) -> Inline:
    """The distance of two points: IO; IG of a mass centre G_rod; r of names of several letters."""
    end = _short(end)
    return Text(f"{start}{end}") if len(end) == 1 else Name(f"r_{index_of(end)}/{start}")


def _short(place: str) -> str:
    """G of a mass centre G_rod."""
    return "G" if place.startswith(("G_", "G,")) else place
