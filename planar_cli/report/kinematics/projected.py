"""The component of a relation between a point and the body along which it slides, from the vectors that are known.

n = [-sin 30°, cos 30°] = [-0.5, 0.8660] across AB
ω_AB AD = v_D · n = -0.5 · 0.8619 = -0.4309 m/s
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Text, Value, line
from planar_cli.report.given.given_vectors import size_of
from planar_cli.report.kinematics.along_slots import (
    NEARLY,
    by_angle,
    carried_along,
    coriolis_across,
    distance_named,
    slot_of,
    unit_told,
)
from planar_cli.report.kinematics.component_sums import components_told, turned_with
from planar_cli.report.kinematics.known_vectors import is_known, unit_along
from planar_cli.report.kinematics.told import RATES, Across, Told
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.counted import as_vector
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH, PURE, Dimension

FEW = 3
"""Operations at most in a component of a unit vector that is told in letters."""

Known = tuple[str, Vec]
"""The name of a vector whose components are numbers, and these."""


def vector_at(told: Told, body: str, at: Vec, level: str) -> Vec:
    """The velocity or the acceleration of a point of a body."""
    return told.motion.velocity(at, body) if level == "velocity" else told.motion.acceleration(at, body)


def known_sides(told: Told, body: str, at: Vec, arm: Vec, level: str) -> tuple[Line, ...]:
    """[x, y] of what is known as soon as it is told, with its numbers before it; else nothing."""
    vector = vector_at(told, body, at, level)
    if not is_known(told, vector, level):
        return _about_pivot(told, body, at, level)
    put = components_told(turned_with(told, body, arm, level), told.phrases.figures)
    value = told.phrases.vector(told.phrases.certain(vector.x), told.phrases.certain(vector.y), RATES[level])
    return (put, value) if put else (value,)


def _about_pivot(told: Told, body: str, at: Vec, level: str) -> tuple[Line, ...]:
    """OG α e_t + OG ω² e_n of the mass centre of a body of parts in line with its pin: as in its diagram."""
    scene, motion = told.system.scene, told.motion
    model = scene.bodies[body]
    reach = None if model.pivot is None else scene.ledger.symbols.get(f"{model.pivot[0]}{model.center_name}")
    if level == "velocity" or reach is None or at != model.center:
        return ()
    alpha, omega = as_vector(motion.accelerations[body].angular, told.system), motion.velocities[body].angular
    parts: list[Any] = [] if alpha == 0 else [told.phrases.math(reach * alpha), " ", Name("e_t")]
    if omega != 0:
        parts += [" + " if parts else "", told.phrases.math(reach * omega**2), " ", Name("e_n")]
    return (line(*parts),) if parts else ()


def projected(told: Told, j: Joining, w: Written, level: str) -> Iterator[Block]:
    """The components of what is known of a point that slides along a straight line of a body, across that line; of one
    that slides on a fixed circle too, towards its centre.
    """
    if j.base == GROUND and j.path is not None and j.path.curvature != 0:
        from planar_cli.report.kinematics.on_circles import towards_centre

        yield from towards_centre(told, j, w, level)
    if j.base == GROUND or j.path is None or j.path.curvature != 0 or w.along is None or j.rolling is not None:
        return
    own = vector_at(told, j.mover, j.point, level)
    if not is_known(told, own, level):
        return
    name = f"{level[0]}_{j.place.replace('_', ',')}"
    known, spin = [(name, own)], told.motion.velocities[j.base].angular
    if level != "velocity" and spin != 0:
        relative, _ = told.system.quantities().seen_from(j.place, j.base)
        known.append(("a_cor", relative.turned() * (2 * spin)))
    carried = vector_at(told, j.base, j.point, level)
    known = [(n, v) for n, v in known if any(told.phrases.certain(p) for p in (v.x, v.y))]
    unit = unit_along(Vec(*w.along), told.phrases)
    rate = _carried(unit, carried, level, told)
    if not known or rate is None or any(abs(abs(u) - 1) < NEARLY for u in unit):
        return
    unknown, factor = rate
    reach = _reach(told, j, unit)
    if f"n {j.base}" not in told.valued:
        told.valued.add(f"n {j.base}")
        told.preface += _unit_vectors(told, j, unit, reach)
    lines = list(_by_speed(_along(unit, known, RATES[level], told.phrases), told, j, unit))
    told.components = _across(lines, reach, unknown, (factor < 0, (factor < 0) != (known[0][0] != name)), told.phrases)
    if told.components.product and len(lines) == 1:
        return
    if level != "velocity" and reach is not None and reach.sense > 0 and (slot := slot_of(told, j.place, j.base)):
        yield from carried_along(told, slot, unknown)
    yield from lines
    if told.components.product:
        return
    own_name, turns = line(Name(f"{name}′"), " · ", Name("n")), sp.Symbol(f"{NUMBER}arm", real=True)
    product = Math(turns * unknown, {turns: significant(factor, told.phrases.figures)})
    size = () if reach is None else line("-" if factor < 0 else "", told.phrases.math(unknown), " ", *reach.size)
    yield Equation((own_name, *([size] if size else []), product))


def as_product(across: Across | None, sides: Sequence[Any], level: str, phrases: Phrases) -> tuple[Any, ...]:
    """ω AP = v_P · n = numbers = value, in place of an equation in numbers; empty where that is all there is."""
    if across is None or not across.product or not sides:
        return ()
    size = across.sizes[0] - sum(across.sizes[1:], Decimal(0))
    one = phrases.of_dimension(Decimal(1), RATES[level])
    return (across.product, across.known, *across.put, *sides[1:-1], Value(size, one.unit, one.figures))


def with_direction(words: list[Block], w: Written, phrases: Phrases) -> list[Block]:
    """The words before a component, with the unit vector along which it is taken where that is no axis."""
    last = words[-1] if words else None
    if not isinstance(last, Paragraph) or last.line[-1] != Text(":") or w.along is None or phrases.symbolic:
        return words
    if not all(phrases.has_numbers(sp.sympify(p)) for p in w.along):
        return words
    unit = unit_along(Vec(*w.along), phrases)
    if any(abs(abs(u) - 1) < NEARLY for u in unit):
        return words
    return [
        *words[:-1],
        Paragraph(line(*last.line[:-1], " (unit vector ", *phrases.vector(unit[0], unit[1], PURE), "):")),
    ]


@record
class _Reach:
    """The arm to a point on a line through the place about which its body turns, `start`: the name of its length, and
    both in SI units; `sense`: 1 where n is 90° to the left of it, else -1.
    """

    start: str
    size: Line
    arm: tuple[Decimal, Decimal]
    length: Decimal
    sense: int


def _reach(told: Told, j: Joining, unit: Sequence[Decimal]) -> _Reach | None:
    """None: the line passes beside that place."""
    edge = next((e for e in told.system.tree.edges if e.body == j.base), None)
    if edge is None or edge.joining is None:
        return None
    arm = told.system.scene.arms.between(told.motion.velocities[j.base].point, j.point)
    x, y = told.phrases.certain(arm.x), told.phrases.certain(arm.y)
    length = (x * x + y * y).sqrt()
    if not length or abs(x * unit[0] + y * unit[1]) > NEARLY * length:
        return None
    sense = 1 if x * unit[1] - y * unit[0] > 0 else -1
    return _Reach(edge.joining.place, distance_named(edge.joining.place, j.place), (x, y), length, sense)


def _unit_vectors(told: Told, j: Joining, unit: Sequence[Decimal], reach: _Reach | None) -> Iterator[Block]:
    """The unit vectors along and across a line, by its angle where this is round, and the length of the arm on it."""
    phrases, slot = told.phrases, slot_of(told, j.place, j.base)
    if reach is not None:
        arm = told.arm_told(
            j.place, reach.start, told.system.scene.arms.between(told.motion.velocities[j.base].point, j.point)
        )
        length = phrases.of_dimension(reach.length, LENGTH)
        yield Equation((reach.size, size_of(reach.arm, LENGTH, phrases), length), None, (), arm)
    along = [unit[1], -unit[0]] if slot is None else slot.unit
    across = line(Name("n"), " = ", *by_angle(unit, along), *phrases.vector(unit[0], unit[1], PURE))
    if slot is None or f"e {slot.frame}" in told.valued:
        yield Paragraph(line(*across, f" across {j.base}"))
    else:
        told.valued.add(f"e {slot.frame}")
        yield Paragraph(line(*unit_told(told, slot, reach is not None), ", ", *across, " across it"))


def _across(
    lines: Sequence[Block], reach: _Reach | None, unknown: sp.Symbol, signs: tuple[bool, bool], phrases: Phrases
) -> Across:
    """The components that were told, and what they give: (a_P · n - (2 ω × v_rel) · n)/AP. `signs`: whether the own
    part is negative, and whether the components count against the sense of ω.
    """
    told = [b for b in lines if isinstance(b, Equation)]
    sizes = tuple(b.sides[-1].number for b in told if isinstance(b.sides[-1], Value))
    if reach is None:
        return Across(sizes, ())
    parts: list[Any] = []
    for b in told:
        parts += [" - " if parts else "", *(b.sides[0] if isinstance(b.sides[0], tuple) else ())]
    quotient = line("-" if signs[1] else "", "(", *parts, ")/", *reach.size)
    if any(signs):
        return Across(sizes, quotient)
    put = tuple(told[0].sides[1:-1]) if len(told) == 1 else ()
    return Across(sizes, quotient, line(phrases.math(unknown), " ", *reach.size), line(*parts[1:]), put)


def _by_speed(lines: Iterable[Block], told: Told, j: Joining, unit: Sequence[Decimal]) -> Iterator[Block]:
    """The same; a_cor · n as 2 ω (v_rel · e), where the page has told v_rel along the line."""
    slot = slot_of(told, j.place, j.base)
    own = line(Name("a_cor"), " · ", Name("n"))
    for b in lines:
        result = b.sides[-1] if isinstance(b, Equation) and b.sides[0] == own else None
        if slot is None or not isinstance(b, Equation) or not isinstance(result, Value):
            yield b
            continue
        yield replace(b, sides=(*coriolis_across(told, slot, unit, result.figures), result))


def as_components(across: Across | None, sides: tuple[Math, Math | None, Math]) -> tuple[Math, ...]:
    """The sides of a relation, its letters, the components that stand above it, and its number, so that these count as
    they are told there; empty where that is no matter, or they do not make its number.
    """
    left, whole, right = sides
    if across is None or not across.as_told or whole is None:
        return ()
    number = across.sizes[0] - sum(across.sizes[1:], Decimal(0))
    if (number < 0) == right.expr.could_extract_minus_sign():
        return left, whole, right
    own = sp.Add(*(-t for t in sp.Add.make_args(whole.expr)), evaluate=False)
    return Math(-left.expr, left.values), Math(own, whole.values), Math(-right.expr, right.values)


def difference_of(sizes: Sequence[Decimal], number: Decimal, figures: int) -> Math | None:
    """-1.450 - (-1.393): the component of the first vector without those of the others; None: it is not `number`, but
    for its sense.
    """
    whole = sizes[0] - sum(sizes[1:], Decimal(0))
    if len(sizes) < 2 or abs(abs(whole) - abs(number)) > NEARLY * max(map(abs, sizes)):
        return None
    sense = 1 if (whole < 0) == (number < 0) else -1
    figures = figures_of(sizes, lambda x: x[0] - sum(x[1:], Decimal(0)), figures)
    letters = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in range(len(sizes))]
    texts = {s: significant(x, figures) for s, x in zip(letters, sizes, strict=True)}
    terms = [sense * s if i == 0 else -sense * s for i, s in enumerate(letters)]
    return Math(sp.Add(*terms, evaluate=False), texts)


def _along(unit: list[Decimal], known: Sequence[Known], dimension: Dimension, phrases: Phrases) -> Iterator[Block]:
    """The component of each known vector along a unit vector."""
    parts = [[phrases.of_dimension(phrases.certain(p), dimension).number for p in (v.x, v.y)] for _, v in known]
    sizes = [sum((e * x for e, x in zip(unit, p, strict=True)), Decimal(0)) for p in parts]
    figures = figures_of(sizes, lambda x: x[0] - sum(x[1:], Decimal(0)), phrases.figures)
    sign = coherent_unit(dimension, us=phrases.ledger.us).text
    for (name, _), shown, size in zip(known, parts, sizes, strict=True):
        result = Value(size, sign, figures)
        yield Equation((line(Name(name), " · ", Name("n")), sum_along(unit, shown, figures), result))


def unit_of(direction: Vec, phrases: Phrases) -> Line:
    """A unit vector in letters or numbers, with the sines of its angle before these."""
    letters = line("[", phrases.math(direction.x), ", ", phrases.math(direction.y), "]")
    if phrases.symbolic:
        return letters
    unit = (phrases.certain(direction.x), phrases.certain(direction.y))
    plain = all(sp.sympify(p).free_symbols and not longer(p, FEW) for p in (direction.x, direction.y))
    way = line(*letters, " = ") if plain else by_angle(unit, unit)
    return line(*way, *phrases.vector(*unit, PURE))


def _carried(unit: Sequence[Decimal], vector: Vec, level: str, told: Told) -> tuple[sp.Symbol, Decimal] | None:
    """The one unknown in the component of the point of the body itself, and its factor; None: there is more in it."""
    phrases, tree = told.phrases, told.system.tree
    every = {*tree.velocity_unknowns()} if level == "velocity" else {*tree.acceleration_unknowns()}
    inside = (vector.x.free_symbols | vector.y.free_symbols) & (every - told.given)
    if len(inside) != 1:
        return None
    (unknown,) = inside
    factors = [phrases.value(sp.diff(p, unknown)) for p in (vector.x, vector.y)]
    rests = [phrases.value(p.xreplace({unknown: sp.S.Zero})) for p in (vector.x, vector.y)]
    factor, rest = (sum((e * x for e, x in zip(unit, parts, strict=True)), Decimal(0)) for parts in (factors, rests))
    return None if abs(rest) > NEARLY or abs(factor) < NEARLY or phrases.ledger.us else (unknown, factor)


def sum_along(unit: Sequence[Decimal], shown: Sequence[Decimal], figures: int) -> Math | Line:
    """-0.5 · 0.8619 + 0.8660 · 0.2, without what is zero."""
    pairs = [(e, v) for e, v in zip(unit, shown, strict=True) if v]
    if not pairs:
        return line("0")
    counted = [x for pair in pairs for x in pair]
    figures = figures_of(
        counted,
        lambda x: sum((x[i] * x[i + 1] for i in range(0, len(x), 2)), Decimal(0)),
        figures,
    )
    texts: dict[sp.Symbol, str] = {}
    terms: list[Any] = []
    for i, (e, v) in enumerate(pairs):
        one, other = (sp.Symbol(f"{NUMBER}{k}{i}", real=True) for k in ("cos", ""))
        texts |= {one: significant(e, figures), other: significant(v, figures)}
        terms.append(sp.Mul(one, other, evaluate=False))
    return Math(terms[0] if len(terms) == 1 else sp.Add(*terms, evaluate=False), texts)


def differences(relative: Vec, others: Sequence[Vec], dimension: Dimension, phrases: Phrases) -> Line:
    """[0.8619 - 0.2155, 0 - (-0.3732)], of the whole vector without all others, with as many figures as that takes."""
    if phrases.symbolic:
        return ()
    whole = relative
    for other in others:
        whole = whole + other
    vectors, told = [whole, *others], list[Any]()
    for axis in ("x", "y"):
        numbers = [phrases.of_dimension(phrases.certain(getattr(v, axis)), dimension).number for v in vectors]
        figures = figures_of(numbers, lambda x: x[0] - sum(x[1:], Decimal(0)), phrases.figures)
        letters = [sp.Symbol(f"{NUMBER}{axis}{i}", real=True) for i in range(len(numbers))]
        texts = {s: significant(x, figures) for s, x in zip(letters, numbers, strict=True)}
        kept = [s if i == 0 else -s for i, (s, x) in enumerate(zip(letters, numbers, strict=True)) if x]
        sides = Math(sp.Add(*kept, evaluate=False), texts) if kept else Text("0")
        told += [", " if told else "[", sides]
    return line(*told, "]")
