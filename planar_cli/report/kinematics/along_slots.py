"""What slides along a straight line of a body, through the point about which that body turns: along the line the body
itself has neither velocity nor Coriolis acceleration, so that one component tells what is relative.

v_rel = v_P · e                                        e along the line; less v_A · e where A moves
a_cor · n = 2 ω v_rel                                  n across it
a_rel = a_P · e + ω² AP                                (An Introduction to Planar Dynamics, 2.4)
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Equation, Line, Math, Name, line
from planar_cli.report.kinematics.component_sums import Power, sum_of_products
from planar_cli.report.kinematics.told import RATES, Told
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.units import LENGTH, PURE, VELOCITY

NEARLY = Decimal("1e-12")
ROUND = 1e-9
"""Degrees by which a round angle may be off."""
LETTERS = ("e", "u", "e′", "u′")
"""For unit vectors, in the order in which they are taken."""


@record
class Slot:
    """A point that slides along a line of `frame`: `unit` along the line, `reference` the point of the line about which
    the frame turns, and `reach` how far along it the point is from there [m].
    """

    point: str
    frame: str
    unit: tuple[Decimal, Decimal]
    reference: str
    reach: Decimal

    @property
    def arm(self) -> Line:
        """The name of the distance from there: AP."""
        return distance_named(self.reference, self.point)


def distance_named(start: str, end: str) -> Line:
    """AP; |r_P2/A| of points whose names have several letters."""
    if len(start) == len(end) == 1:
        return line(f"{start}{end}")
    return line("|", Name(f"r_{index_of(end)}/{index_of(start)}"), "|")


def unit_letter(told: Told, frame: str) -> Name:
    """The letter for the unit vector along the line of a body: e, or another beside an e of the file or of a line along
    which a coordinate counts, and for each body its own.
    """
    tree, symbols = told.system.tree, told.system.scene.ledger.symbols
    counted = any(edge.slide is not None and edge.parent != GROUND for edge in tree.edges)
    letters = [x for x in LETTERS if x not in symbols and not (x == "e" and counted)]
    frames = list(dict.fromkeys(j.base for j in tree.closures if j.path is not None and j.base != GROUND))
    return Name(letters[frames.index(frame)] if frames.index(frame) < len(letters) else f"e_{frame}")


def slot_of(told: Told, point: str, frame: str) -> Slot | None:
    """None: it slides otherwise, the line passes beside the point of reference, or a whole vector is asked."""
    joining = next((j for j in told.system.tree.closures if j.place == point and j.base == frame), None)
    edge = next((e for e in told.system.tree.edges if e.body == frame), None)
    if joining is None or edge is None or not _is_plain(joining, edge) or told.phrases.symbolic:
        return None
    assert joining.path is not None
    assert edge.joining is not None
    certain, scene = told.phrases.certain, told.system.scene
    arm, way = scene.arms.between(told.motion.velocities[frame].point, joining.point), joining.path.tangent
    if not all(told.phrases.has_numbers(p) for p in (arm.x, arm.y, way.x, way.y)):
        return None
    if not told.phrases.value.is_zero(arm.cross(way)):
        return None
    along, axes = (certain(way.x), certain(way.y)), _asked(told, point, frame)
    if axes is None or any(not told.phrases.value.is_zero(axis.cross(way)) for axis in axes):
        return None
    size = (along[0] ** 2 + along[1] ** 2).sqrt()
    sense = -1 if axes and certain(axes[0].dot(way)) < 0 else 1
    unit = (sense * along[0] / size, sense * along[1] / size)
    reach = certain(arm.x) * unit[0] + certain(arm.y) * unit[1]
    return Slot(point, frame, unit, edge.joining.place, reach)


def _is_plain(joining: Joining, edge: Edge) -> bool:
    """Is the line straight, and does the frame simply turn about a point?"""
    straight = joining.path is not None and joining.path.curvature == 0
    if not straight or joining.rolling is not None or joining.drift is not None or joining.base == GROUND:
        return False
    return not edge.particle and edge.joining is not None and edge.joining.rolling is None


def _asked(told: Told, point: str, frame: str) -> list[Vec] | None:
    """The axes along which relative motion is asked; None: another part of it, or the whole vector."""
    axes: list[Vec] = []
    for find in told.system.scene.problem.find:
        q = find.found.what
        if not isinstance(q, Quantity) or q.word not in ("v", "a", "coriolis") or tuple(q.things) != (point, frame):
            continue
        if len(q.parts) != 1 or q.parts[0].kind not in (("mag",) if q.word == "coriolis" else ("along", "mag")):
            return None
        if q.parts[0].kind == "along":
            unit = told.system.quantities().direction(q.parts[0])
            axes.append(Vec(unit.x.value, unit.y.value))
    return axes


def relative_along(told: Told, slot: Slot, level: str) -> tuple[tuple[Line, ...], Decimal]:
    """v_rel = v_P · e = numbers, or a_rel, and its value [SI]; nothing but the name where both points are at rest."""
    phrases, motion, v = told.phrases, told.motion, level[0]
    unit = unit_letter(told, slot.frame)
    place = told.system.quantities().place(slot.point)
    jets = [(p.rate if level == "velocity" else p.second) for p in (place.x, place.y)]
    base = (motion.velocities if level == "velocity" else motion.accelerations)[slot.frame].linear
    terms: list[Any] = []
    parts: list[tuple[int, tuple[Power, ...]]] = []
    for sign, name, vector in ((1, slot.point, jets), (-1, slot.reference, [base.x, base.y])):
        numbers = [phrases.certain(p) for p in vector]
        if not any(numbers):
            continue
        minus = " - " if terms else "-"
        terms += [minus if sign < 0 else "", Name(f"{v}_{index_of(name)}"), " · ", unit]
        shown = [phrases.of_dimension(x, RATES[level]).number for x in numbers]
        parts += [(sign, ((e, 1), (x, 1))) for e, x in zip(slot.unit, shown, strict=True) if e and x]
    spin = phrases.certain(motion.velocities[slot.frame].angular)
    if level == "acceleration" and spin:
        omega = phrases.math(motion.velocities[slot.frame].angular ** 2)
        plus = (" + " if terms else "") if slot.reach > 0 else (" - " if terms else "-")
        terms += [plus, omega, " ", *slot.arm]
        reach = phrases.of_dimension(slot.reach, LENGTH).number
        parts.append((1 if reach > 0 else -1, ((abs(reach), 1), (spin, 2))))
    value = Decimal(0)
    for sign, factors in parts:
        product = Decimal(sign)
        for factor, power in factors:
            product *= factor**power
        value += product
    left = component(told, slot, v)
    if not parts:
        return (left,), value
    put = sum_of_products(parts, phrases.figures)
    # Products that cancel come to a zero that its unit follows at once.
    return (left, line(*terms), *([line(put)] if put.expr != 0 else [])), value


def unit_told(told: Told, slot: Slot, by_arm: bool = False) -> Line:
    """e = [cos 30°, sin 30°] = [0.8660, 0.5] along AB; e = r_P/A/AP = [0.8660, 0.5], where the page has just told the
    arm (`by_arm`), of a line whose angle is no round one.
    """
    value = told.phrases.vector(slot.unit[0], slot.unit[1], PURE)
    way = by_angle(slot.unit, slot.unit)
    if by_arm and not way:
        sign, arm = "" if slot.reach > 0 else "-", Name(f"r_{index_of(slot.point)}/{index_of(slot.reference)}")
        way = line(sign, arm, " / ", *slot.arm, " = ")
    return line(unit_letter(told, slot.frame), " = ", *way, *value, f" along {slot.frame}")


def unit_beside(told: Told, j: Joining) -> Line:
    """e behind v_rel, where the page takes the components along it and across it."""
    slot = slot_of(told, j.place, j.base) if f"n {j.base}" in told.valued else None
    return () if slot is None else line(" ", unit_letter(told, slot.frame))


def by_angle(way: Sequence[Decimal], along: Sequence[Decimal]) -> Line:
    """[cos 30°, sin 30°] = of the direction of a line, [-sin 30°, cos 30°] = across it; nothing where its angle is no
    whole number of degrees.
    """
    degrees = math.degrees(math.atan2(float(along[1]), float(along[0])))
    if abs(degrees - round(degrees)) > ROUND or round(degrees) % 90 == 0:
        return ()
    turn = along[0] * way[1] - along[1] * way[0]
    cos, sin = f"cos {abs(round(degrees))}°", f"sin {abs(round(degrees))}°"
    sin, back = (sin, f"-{sin}") if degrees > 0 else (f"-{sin}", sin)
    if abs(turn) < NEARLY:
        return line(f"[{cos}, {sin}] = ")
    return line(f"[{back}, {cos}] = " if turn > 0 else f"[{sin}, -{cos}] = ")


def along_unit_vector(told: Told, slot: Slot) -> Line:
    """along e:"""
    return line("along ", unit_letter(told, slot.frame), ":")


def whole_component(told: Told, slot: Slot) -> tuple[Line, ...]:
    """a_P · e = a_rel - ω² AP, from which a_rel follows; nothing where the pivot moves or nothing turns."""
    spin = told.motion.velocities[slot.frame].angular
    base = told.motion.accelerations[slot.frame].linear
    if told.phrases.value.is_zero(spin) or not all(told.phrases.value.is_zero(p) for p in (base.x, base.y)):
        return ()
    sign = " - " if slot.reach > 0 else " + "
    whole = line(Name(f"a_{index_of(slot.point)}"), " · ", unit_letter(told, slot.frame))
    return (whole, line(Name("a_rel"), sign, told.phrases.math(spin**2), " ", *slot.arm))


def carried_along(told: Told, slot: Slot, alpha: sp.Symbol) -> Iterator[Equation]:
    """a_P′ · n = α AP and a_P′ · e = -ω² AP of the point of the body itself, with n at 90° to the left of e; nothing
    where the pivot moves, nothing turns, or the point is on the other side of it.
    """
    if slot.reach <= 0 or not whole_component(told, slot):
        return
    omega, unit = told.phrases.math(told.motion.velocities[slot.frame].angular ** 2), unit_letter(told, slot.frame)
    own = line(Name(f"a_{index_of(slot.point)}′"), " · ")
    along = line(*own, unit, " = -", omega, " ", *slot.arm)
    yield Equation((line(*own, Name("n")), line(told.phrases.math(alpha), " ", *slot.arm)), None, note=along)


def component(told: Told, slot: Slot, v: str) -> Line:
    """v_rel or a_rel, counted along e."""
    return line(Name(f"{v}_rel"))


def coriolis_told(spin: Math, e: Line) -> Line:
    """+ a_cor, a_cor = 2 ω × v_rel e, where components along e and across it follow; else the product alone. `e`: with
    the space before it.
    """
    before = (" + ", Name("a_cor"), ", ", Name("a_cor"), " = 2 ") if e else (" + 2 ",)
    return line(*before, spin, " × ", Name("v_rel"), *e)


def coriolis_across(told: Told, slot: Slot, normal: Sequence[Decimal], figures: int) -> tuple[Line, Line, Line]:
    """a_cor · n = 2 ω v_rel, and the same in numbers. `normal`: n; `figures`: of its value."""
    sense = 1 if slot.unit[0] * normal[1] - slot.unit[1] * normal[0] > 0 else -1
    spin, numbers = _turning(told, slot)
    omega = told.phrases.math(spin)
    own = line(Name("a_cor"), " · ", Name("n"))
    letters = line("-" if sense < 0 else "", "2 ", omega, " ", *component(told, slot, "v"))
    return own, letters, line(_doubled(sense, numbers, figures))


def coriolis_size(told: Told, slot: Slot) -> tuple[Line, Line, Line]:
    """|2 ω × v_rel| = 2 |ω| |v_rel|, and the same in numbers."""
    spin, numbers = _turning(told, slot)
    omega, v = told.phrases.math(spin), Name("v_rel")
    letters = line("2 |", omega, "| |", v, "|")
    return (
        line("|2 ", omega, " × ", v, " ", unit_letter(told, slot.frame), "|"),
        letters,
        line(_doubled(1, [abs(x) for x in numbers], told.phrases.figures)),
    )


def coriolis_way(told: Told, slot: Slot) -> Line:
    """at -60°: v_rel turned by 90° clockwise, as AB turns"""
    _, numbers = _turning(told, slot)
    turn = 1 if numbers[0] > 0 else -1
    ahead = turn if numbers[1] > 0 else -turn
    way = math.degrees(math.atan2(ahead * slot.unit[0], -ahead * slot.unit[1]))
    # A rounded -0.0 is 0, and -180 is 180.
    shown = 180.0 if round(way, 1) == -180 else round(way, 1) + 0.0
    turned = line(f"at {shown}".removesuffix(".0"), "°: ", Name("v_rel"), " turned by 90° ")
    return line(*turned, f"{'counterclockwise' if turn > 0 else 'clockwise'}, as {slot.frame} turns")


def _turning(told: Told, slot: Slot) -> tuple[sp.Expr, list[Decimal]]:
    """ω, and the numbers of ω and v_rel in the units of the page."""
    relative, _ = told.system.quantities().seen_from(slot.point, slot.frame)
    parts = zip(slot.unit, (relative.x, relative.y), strict=True)
    along = sum((e * told.phrases.certain(x) for e, x in parts), Decimal(0))
    spin = told.motion.velocities[slot.frame].angular
    return spin, [told.phrases.certain(spin), told.phrases.of_dimension(along, VELOCITY).number]


def _doubled(sense: int, numbers: Sequence[Decimal], figures: int) -> Math:
    figures = figures_of(numbers, lambda x: 2 * x[0] * x[1], figures)
    letters = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in range(2)]
    texts = {s: significant(x, figures) for s, x in zip(letters, numbers, strict=True)}
    return Math(sp.Mul(2 * sense, *letters, evaluate=False), texts)
