"""What slides along a straight line through the fixed pin about which that line turns: polar coordinates about the pin.

v_P = ṙ e_r + r ω e_θ                    e_r from the pin to P, e_θ 90° counterclockwise from it
a_r = r̈ - r ω²,  a_θ = r α + 2 ṙ ω       (An Introduction to Planar Dynamics, 1.5)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Value, line
from planar_cli.report.kinematics.along_slots import by_angle
from planar_cli.report.kinematics.component_sums import Term, along_unit, both_told, sum_of_products
from planar_cli.report.kinematics.told import RATES, Told
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.units import ACCELERATION, LENGTH, PURE

LETTERS = sp.symbols("r r_dot r_ddot", real=True)
RADIUS, RATE, SECOND = Name("r"), Name("r_dot"), Name("r_ddot")
"""The length r, how fast the length r changes, and how fast that changes."""
SAME = Decimal("1e-9")
"""How closely two unit vectors agree that are one."""


@record
class PolarSlide:
    """A point that slides on a line of `frame` through the fixed `pin`; numbers in the units of the page.

    `outward`: the unit vector from the pin to the point; `sense`: 1 where its rate along the line counts outward, else
    -1; `slide`, `rate`: the letters of ṙ and r̈ up to that sense; `numbers`: r, ṙ, r̈, ω, α.
    """

    place: str
    frame: str
    pin: str
    outward: tuple[Decimal, Decimal]
    sense: int
    slide: sp.Symbol
    rate: sp.Symbol
    spin: sp.Expr
    turning: sp.Expr
    numbers: tuple[Decimal, Decimal, Decimal, Decimal, Decimal]

    def parts(self, level: str) -> tuple[Decimal, Decimal]:
        """The components along e_r and e_θ."""
        r, slide, rate, omega, alpha = self.numbers
        if level == "velocity":
            return slide, r * omega
        return rate - r * omega**2, r * alpha + 2 * slide * omega


def polar_slide(system: System, phrases: Phrases, body: str, place: str, frame: str) -> PolarSlide | None:
    """None: its line turns about a point that moves, or passes beside it; letters remain; or another joint tells how it
    moves, so that a component across that is what is needed; or the file calls something else r.
    """
    edges = {e.body: e for e in system.tree.edges}
    edge, carrier = edges[body], edges[frame]
    joining, pinned, motion = edge.joining, carrier.joining, system.motion
    if phrases.symbolic or motion is None or "r" in system.scene.ledger.symbols:
        return None
    if joining is None or joining.path is None or pinned is None or pinned.base != GROUND:
        return None
    if joining.path.curvature != 0 or edge.slide is None or edge.slide_rate is None:
        return None
    if pinned.rolling is not None or pinned.drift is not None or pinned.path is not None:
        return None
    if any(body in (j.mover, j.base) for j in system.tree.closures):
        return None
    way, arm = joining.path.tangent, system.scene.arms.between(pinned.point, joining.point)
    twist, pace = motion.velocities[frame].angular, motion.accelerations[frame].angular
    letters = (edge.slide, edge.slide_rate, twist, pace, arm.x, arm.y, way.x, way.y)
    if not all(phrases.has_numbers(sp.sympify(x)) for x in letters) or not phrases.value.is_zero(arm.cross(way)):
        return None
    x, y, omega = phrases.certain(arm.x), phrases.certain(arm.y), phrases.certain(twist)
    reach = (x * x + y * y).sqrt()
    if not reach or not omega:
        return None
    sense = 1 if phrases.certain(arm.dot(way)) > 0 else -1
    velocity, second = (
        sense * phrases.of_dimension(phrases.certain(s), RATES[n]).number
        for s, n in ((edge.slide, "velocity"), (edge.slide_rate, "acceleration"))
    )
    numbers = (phrases.of_dimension(reach, LENGTH).number, velocity, second, omega, phrases.certain(pace))
    outward = (x / reach, y / reach)
    return PolarSlide(place, frame, pinned.place, outward, sense, edge.slide, edge.slide_rate, twist, pace, numbers)


class SlideTelling:
    """Lines of what slides along bodies, and of the parts of its acceleration that are asked after these."""

    def __init__(self, told: Told, phrases: Phrases) -> None:
        self._vectors, self._phrases = told, phrases
        self._slides: dict[str, PolarSlide] = {}
        """What was told, by the index of the point."""

    def told(self, body: str, place: str, frame: str, level: str) -> tuple[list[Block], tuple[Line, ...]] | None:
        """What stands before the vector of a place, and the sides of its equation; None: it is not told in polar
        coordinates.
        """
        one = polar_slide(self._vectors.system, self._phrases, body, place, frame)
        if one is None:
            return None
        first = index_of(place) not in self._slides
        self._slides[index_of(place)] = one
        (c, s), (outer, beside) = one.outward, one.parts(level)
        tell = _velocity if level == "velocity" else _acceleration
        before, *sides = tell(self._vectors, one)
        rows = [(c, outer), (-s, beside)], [(s, outer), (c, beside)]
        terms = [[t for unit, x in row for t in _along(unit, x)] for row in rows]
        components = both_told(terms, self._phrases.figures)
        name, vector = line(Name(f"{level[0]}_{index_of(place)}")), self._phrases.vector
        radial = line(Name("e_r"), " = ", *by_angle((c, s), (c, s)), *vector(c, s, PURE))
        units = line(*radial, ", ", Name("e_theta"), " = ", *by_angle((-s, c), (c, s)), *vector(-s, c, PURE))
        opened: list[Block] = [Paragraph(_opened(self._vectors, one)), Equation((units,))] if first else []
        return [*opened, *before], (name, *sides, *([components] if components else []))

    def coriolis(self, answer: str, q: Quantity, values: Sequence[Value]) -> Equation | None:
        """The size of the Coriolis acceleration, where that is asked after it was told."""
        one = self._slides.get(index_of(q.things[0]))
        if one is None or q.word != "coriolis" or [p.kind for p in q.parts] != ["mag"]:
            return None
        return _coriolis(self._vectors, one, answer, values)

    def size(self, name: str) -> Math | None:
        """√(a_r² + a_θ²) for the acceleration of that name."""
        one = self._slides.get(name.removeprefix("a_"))
        return None if one is None else _size(one, self._phrases)

    def part(self, name: str, axis: Sequence[Decimal]) -> Line:
        """a_θ or -a_r, where an axis is along or across the line; empty: it is neither."""
        one = self._slides.get(name.removeprefix("a_"))
        if one is None:
            return ()
        (c, s), (x, y) = one.outward, axis
        for letter, along in (("r", c * x + s * y), ("theta", c * y - s * x)):
            if abs(abs(along) - 1) < SAME:
                return line("" if along > 0 else "-", Name(f"a_{letter}"))
        return ()


def _velocity(told: Told, one: PolarSlide) -> tuple[list[Block], Line, Line]:
    """ṙ e_r + r ω e_θ, and the same with its numbers."""
    r, slide, _, omega, _ = one.numbers
    spin, radial, across = told.phrases.math(one.spin), Name("e_r"), Name("e_theta")
    outward = line(RATE, " ", radial, " + ") if slide else ()
    shown = line(_sum([(1, ((slide, 1),))], told), " ", radial, " + ") if slide else ()
    turned = _sum([(1, ((r, 1), (omega, 1)))], told)
    return [], line(*outward, RADIUS, " ", spin, " ", across), line(*shown, turned, " ", across)


def _acceleration(told: Told, one: PolarSlide) -> tuple[list[Block], Line]:
    """a_r and a_θ with their numbers, and a_r e_r + a_θ e_θ."""
    r, slide, rate, omega, alpha = one.numbers
    outer, beside = one.parts("acceleration")
    first = [LETTERS[2]] if rate else []
    outward = Math(sp.Add(*first, -LETTERS[0] * one.spin**2, evaluate=False) if rate else -LETTERS[0] * one.spin**2)
    numbers: list[Term] = [(1, ((rate, 1),)), (-1, ((r, 1), (omega, 2)))]
    blocks: list[Block] = [_component(told, "a_r", outward, numbers, outer)]
    parts = ([LETTERS[0] * one.turning] if alpha else []) + ([2 * LETTERS[1] * one.spin] if slide else [])
    across = Math(sp.Add(*parts, evaluate=False) if len(parts) > 1 else (parts or [sp.S.Zero])[0])
    vector = line(Name("a_r"), " ", Name("e_r"))
    if not alpha and not slide:
        return blocks, vector
    terms: list[Term] = [(1, ((r, 1), (alpha, 1))), (1, ((Decimal(2), 1), (slide, 1), (omega, 1)))]
    blocks.append(_component(told, "a_theta", across, terms, beside))
    return blocks, line(*vector, " + ", Name("a_theta"), " ", Name("e_theta"))


def _along(unit: Decimal, number: Decimal) -> Iterator[Term]:
    """What points along a unit vector, by the size of its component."""
    return along_unit(abs(unit), ((number, 1),), 1 if unit > 0 else -1)


def _component(told: Told, name: str, letters: Math, numbers: list[Term], value: Decimal) -> Equation:
    unit = told.phrases.of_dimension(Decimal(1), ACCELERATION)
    return Equation((line(Name(name)), letters, line(_sum(numbers, told)), Value(value, unit.unit, unit.figures)))


def _opened(told: Told, one: PolarSlide) -> Line:
    """P slides along rod, which turns about O: e_r from O to P, e_θ at 90° counterclockwise; r = OP = 0.5 m, ..."""
    phrases, (r, slide, rate, _, _) = told.phrases, one.numbers
    minus, length = ("" if one.sense > 0 else "-"), phrases.of_dimension(Decimal(1), LENGTH)
    return line(
        f"{one.place} slides along {one.frame}, which turns about {one.pin}: ", Name("e_r"),
        f" from {one.pin} to {one.place}, ", Name("e_theta"), " 90° counterclockwise from it; ",
        RADIUS,
        f" = {one.pin}{one.place} = ",
        Value(r, length.unit, length.figures),
        *((", ", RATE, " = ", minus, phrases.math(one.slide)) if slide else ()),
        *((", ", SECOND, " = ", minus, phrases.math(one.rate)) if rate else ()),
    )  # fmt: skip


def _sum(terms: list[Term], told: Told) -> Math:
    return sum_of_products([t for t in terms if all(number for number, _ in t[1])], told.phrases.figures)


def _coriolis(told: Told, one: PolarSlide, answer: str, shown: Sequence[Value]) -> Equation:
    """The size of the Coriolis acceleration: |2 ṙ ω|."""
    _, slide, _, omega, _ = one.numbers
    if slide * omega > 0:
        letters = Math(2 * LETTERS[1] * one.spin)
        numbers = _sum([(1, ((Decimal(2), 1), (slide, 1), (omega, 1)))], told)
    else:
        letters = Math(2 * sp.Abs(LETTERS[1]) * sp.Abs(one.spin))
        numbers = _sum([(1, ((Decimal(2), 1), (abs(slide), 1), (abs(omega), 1)))], told)
    way = "" if slide * omega > 0 else "-"
    return Equation(
        (line(Name(answer)), letters, line(numbers), *shown), None, note=line(f"along {way}", Name("e_theta"))
    )


def _size(one: PolarSlide, phrases: Phrases) -> Math:
    """√(a_r² + a_θ²) with the numbers."""
    parts = one.parts("acceleration")
    figures = figures_of(parts, lambda v: (v[0] ** 2 + v[1] ** 2).sqrt(), phrases.figures)
    letters = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in range(2)]
    texts = {s: significant(x, figures) for s, x in zip(letters, parts, strict=True)}
    return Math(sp.sqrt(sp.Add(*(s**2 for s in letters), evaluate=False), evaluate=False), texts)
