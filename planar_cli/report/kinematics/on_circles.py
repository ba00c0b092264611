"""The component towards the centre of a fixed circle of the acceleration of a point that slides along a turning body.

n = [-0.5, -0.8660], towards Q                   e · n = -0.8660, (k × e) · n = -0.5, r_P/O · n = -0.6 m
a_P · n = v_P²/R = (0.2771² + 0.16²)/0.4 = 0.256 m/s²
-ω² r_P/O · n = -0.4² (-0.6) = 0.096 m/s²
(2 ω × v_P/OC e) · n = 2 · 0.4 (-0.16) (-0.5) = 0.064 m/s²
(2)  -0.8660 a_P/OC = 0.256 - 0.096 - 0.064 = 0.096

(An Introduction to Planar Dynamics, 2.4: a_P = a_P′ + a_rel + 2 ω × v_rel.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Circle
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Value, line
from planar_cli.report.kinematics.along_slots import NEARLY
from planar_cli.report.kinematics.known_vectors import unit_along
from planar_cli.report.kinematics.told import Across, Told
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.solve.instant.written import Written
from planar_cli.units import ACCELERATION, LENGTH, PURE, RATE, VELOCITY, Dimension


@record
class _Circle:
    """A fixed circle on which a point moves: the name of its centre, its radius, and the unit vector towards it."""

    centre: str
    radius: sp.Expr
    inward: tuple[Decimal, Decimal]


@record
class _Slide:
    """How a point slides along a body that turns about a fixed place at a constant rate: that place, the letters of ω
    and of the speed along the unit vector e; in SI units ω, the speed, e, the arm from the place, and the velocity.
    """

    reference: str
    letters: tuple[sp.Symbol, sp.Symbol]
    spin: Decimal
    speed: Decimal
    along: tuple[Decimal, Decimal]
    arm: tuple[Decimal, Decimal]
    velocity: tuple[Decimal, Decimal]


def towards_centre(told: Told, j: Joining, w: Written, level: str) -> Iterator[Block]:
    """The products with n and the components of what is known; nothing of points that move otherwise."""
    if level == "velocity" or w.place not in told.system.scene.points or w.along is None or told.phrases.symbolic:
        return
    circle, slide = _circle(told, j, Vec(*w.along)), _slide(told, j)
    if (
        circle is None
        or slide is None
        or told.phrases.ledger.us
        or told.system.scene.ledger.symbols.keys() & {"k", "n", "e"}
    ):
        return
    n = circle.inward
    across, out = _dot((-slide.along[1], slide.along[0]), n), _dot(slide.arm, n)
    radius = told.phrases.certain(circle.radius)
    sizes = (
        _dot(slide.velocity, slide.velocity) / radius,
        -(slide.spin**2) * out,
        2 * slide.spin * slide.speed * across,
    )
    if not _is_whole(told, j, n, sizes) or any(abs(s) < NEARLY for s in sizes):
        return
    told.components = Across(sizes, (), as_told=True)
    yield from _lines(told, j.place, (circle, slide), sizes, (across, out))


def _circle(told: Told, j: Joining, across: Vec) -> _Circle | None:
    """None: the path is no fixed circle of the file whose centre has a name."""
    scene = told.system.scene
    joint = next((one for one in scene.problem.joints if one.name == j.joint), None)
    along = getattr(joint, "along", None)
    surface = scene.surfaces.get(str(getattr(along, "name", along) or ""))
    if surface is None or surface.body not in (None, GROUND) or not isinstance(surface.shape, Circle):
        return None
    centre = scene.carried(GROUND, surface.shape.center)
    x, y = (told.phrases.certain(p) for p in ((centre - j.point).x, (centre - j.point).y))
    unit, size = unit_along(across, told.phrases), (x * x + y * y).sqrt()
    if (
        not size
        or abs(x * unit[1] - y * unit[0]) > NEARLY * size
        or not told.phrases.certain(across.x**2 + across.y**2)
    ):
        return None
    return _Circle(surface.shape.center, scene.value(surface.shape.radius), (x / size, y / size))


def _slide(told: Told, j: Joining) -> _Slide | None:
    """None: it does not slide along a straight line of a body that turns so, or a velocity is not known yet."""
    edges = {e.body: e for e in told.system.tree.edges}
    own = edges.get(j.mover)
    frame = None if own is None else edges.get(own.parent)
    if own is None or frame is None or not _slides(own) or not _turns(frame) or own.slide is None:
        return None
    motion = told.motion
    turns, begins = motion.velocities[frame.body].angular, motion.accelerations[frame.body].angular
    velocity = motion.velocity(j.point, j.mover)
    if begins not in (0, *told.zero) or not turns.is_Symbol or not _is_found(told, velocity):
        return None
    assert frame.joining is not None
    assert own.joining is not None
    assert own.joining.path is not None
    arm, e, certain = j.point - frame.joining.point, own.joining.path.tangent, told.phrases.certain
    vectors = ((certain(v.x), certain(v.y)) for v in (e, arm, velocity))
    spin, speed = told.phrases.value(turns), told.phrases.value(own.slide)
    return _Slide(frame.joining.place, (turns, own.slide), spin, speed, *vectors)


def _is_found(told: Told, velocity: Vec) -> bool:
    """Is a velocity known before the accelerations are?"""
    inside = velocity.x.free_symbols | velocity.y.free_symbols
    return told.phrases.has_numbers(velocity.x + velocity.y) and not inside & (told.late - told.given - told.zero)


def _slides(edge: Edge) -> bool:
    j = edge.joining
    straight = j is not None and j.path is not None and j.path.curvature == 0
    return edge.particle and straight and not edge.backward and edge.slide_rate is not None


def _turns(edge: Edge) -> bool:
    """Is it a body on a fixed pin?"""
    j = edge.joining
    return edge.parent == GROUND and edge.spin is not None and j is not None and j.only_turns and j.drift is None


def _is_whole(told: Told, j: Joining, n: Sequence[Decimal], sizes: Sequence[Decimal]) -> bool:
    """Is all of the acceleration that is known in the components but the first?"""
    a = told.motion.acceleration(j.point, j.mover)
    rates = dict.fromkeys(told.system.tree.acceleration_unknowns(), sp.S.Zero)
    known = _dot([told.phrases.value(sp.sympify(p).xreplace(rates)) for p in (a.x, a.y)], n)
    return abs(known - sum(sizes[1:])) < NEARLY * max(map(abs, sizes))


def _dot(one: Sequence[Decimal], other: Sequence[Decimal]) -> Decimal:
    return one[0] * other[0] + one[1] * other[1]


def _lines(
    told: Told,
    place: str,
    parts: tuple[_Circle, _Slide],
    sizes: Sequence[Decimal],
    products: tuple[Decimal, Decimal],
) -> Iterator[Block]:
    """`sizes`: of the components; `products`: (k × e) · n, and that of the arm."""
    (circle, slide), (across, out), phrases = parts, products, told.phrases
    n, index = Name("n"), place.replace("_", ",")
    arm = Name(f"r_{index}/{slide.reference.replace('_', ',')}")
    spin, speed = slide.letters
    figures = figures_of(sizes, lambda x: x[0] - x[1] - x[2], phrases.figures)

    def value(size: Decimal) -> Value:
        shown = phrases.of_dimension(size, ACCELERATION)
        return Value(shown.number, shown.unit, figures)

    def pure(number: Decimal, dimension: Dimension = PURE) -> Value:
        shown = phrases.of_dimension(number, dimension)
        return Value(shown.number, shown.unit, figures)

    beside = line(
        "towards ", Name(circle.centre), ": ", Name("e"), " · ", n, " = ", pure(_dot(slide.along, circle.inward))
    )
    beside += line(", (", Name("k"), " × ", Name("e"), ") · ", n, " = ", pure(across))
    beside += line(", ", arm, " · ", n, " = ", pure(out, LENGTH))
    yield Equation((line(n), phrases.vector(*circle.inward, PURE)), None, note=beside)

    def put(formula: sp.Expr, *numbers: tuple[Decimal, Dimension]) -> Math:
        """A formula in places for numbers, with these."""
        shown = (phrases.of_dimension(size, dimension).number for size, dimension in numbers)
        return Math(formula, {s: significant(x, figures) for s, x in zip(PLACES, shown, strict=False)})

    own = [(v, VELOCITY) for v in slide.velocity if abs(v) > NEARLY]
    squares = sp.Add(*(s**2 for s in PLACES[1 : len(own) + 1]), evaluate=False) if len(own) > 1 else PLACES[1] ** 2
    radius = (phrases.certain(circle.radius), LENGTH)
    quotient = sp.Mul(squares, sp.Pow(PLACES[0], -1), evaluate=False)
    by_letter = line(Name(f"v_{index}"), "²/", phrases.math(circle.radius))
    sides = [by_letter] if circle.radius.is_Symbol else []
    yield Equation((line(Name(f"a_{index}"), " · ", n), *sides, put(quotient, radius, *own), value(sizes[0])))
    one, two, three = PLACES
    carried = sp.Mul(-1, one**2, two, evaluate=False)
    name = line("-", phrases.math(spin**2), " ", arm, " · ", n)
    yield Equation((name, put(carried, (slide.spin, RATE), (out, LENGTH)), value(sizes[1])))
    name = line("(2 ", phrases.math(spin), " × ", phrases.math(speed), " ", Name("e"), ") · ", n)
    numbers = ((slide.spin, RATE), (slide.speed, VELOCITY), (across, PURE))
    yield Equation((name, put(sp.Mul(2, one, two, three, evaluate=False), *numbers), value(sizes[2])))


PLACES = tuple(sp.Symbol(f"{NUMBER}circle{i}", real=True) for i in range(3))
"""Stand for numbers in a formula."""
