"""The component along a unit vector e of a vector relation between two chains of pinned bodies: where its factors come
from.

along DC, where ω_DC does not enter:
    e_DC = [-0.1316, 0.9913]   (k × r_B/A) · e_DC = -0.1316 (-0.1732) + 0.9913 · 0.1 = 0.1219 m   of ω_AB and α_AB
    r_B/A · e_DC = -0.1316 · 0.1 + 0.9913 · 0.1732 = 0.1585 m                                     of ω_AB²
    ω_AB (k × r_B/A) · e_DC + ω_BC (k × r_C/B) · e_DC = 0                  before it is told in numbers

The first product with a unit vector has its numbers; of several more the values stand in one row.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Name, Paragraph, Text, Value, line
from planar_cli.report.kinematics.along_slots import NEARLY
from planar_cli.report.kinematics.known_vectors import unit_along
from planar_cli.report.kinematics.projected import sum_along
from planar_cli.report.kinematics.told import Told
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH, PURE

LEAST = 3
"""So many sides has a product with its numbers; of fewer further ones each has a row."""
ROW, BETWEEN = 92, 5
"""Characters of a row of products, and those of what stands about a value."""


@record
class Arm:
    """From the point at which a body hangs on another to the one at which the next hangs on it, in the unit of the
    page.
    """

    body: str
    start: str
    end: str
    sizes: tuple[Decimal, Decimal]


def with_products(told: Told, words: list[Block], j: Joining | None, w: Written, level: str) -> list[Block]:
    """The words before such a component, with e and the products that it takes; empty: it is of another kind."""
    last = words[-1] if words else None
    if j is None or j.path is not None or j.rolling is not None or w.along is None or told.phrases.symbolic:
        return []
    if not isinstance(last, Paragraph) or last.line[-1] != Text(":"):
        return []
    chains = [list(_arms(told, body, j)) for body in (j.mover, j.base)] if j.base != GROUND else []
    arms = [arm for chain in chains for arm in chain]
    unit = unit_along(Vec(*w.along), told.phrases)
    link = next((arm for arm in arms if _is_along(arm, unit)), None)
    if link is None or "k" in told.system.scene.ledger.symbols or any(abs(abs(u) - 1) < NEARLY for u in unit):
        return []
    x, y = link.sizes
    unit = [u if x * unit[0] + y * unit[1] > 0 else -u for u in unit]
    e, first = line(Name(f"e_{link.start}{link.end}")), list[Equation]()
    if (key := f"unit {e}") not in told.valued:
        told.valued.add(key)
        first = [Equation((e, told.phrases.vector(unit[0], unit[1], PURE)))]
    products = _in_rows([*first, *(b for a in arms for b in _products(told, a, (e, unit), level, a is not link))])
    sides = [line(*_along(told, chain, e, level, link)) or line("0") for chain in sorted(chains, key=len, reverse=True)]
    whole = [Equation(tuple(sides))] if all(chains) else []
    return [*words, *products, *whole]


def _in_rows(told: Sequence[Equation]) -> Iterator[Equation]:
    """The first product beside its unit vector; of several more, and of those with a vector that is known, the values
    in one row.
    """
    vectors = [b for b in told if len(b.sides) < LEAST]
    products = [b for b in told if b not in vectors]
    if not products:
        yield from vectors
        return
    others = products
    if vectors or len(products) < LEAST - 1:
        first, *others = products
        yield replace(vectors[0], note=_written(first)) if vectors else first
    if len(others) < LEAST - 1:
        yield from others
        return
    row: list[Equation] = []
    for b in others:
        if row and sum(map(_length, (*row, b))) > ROW:
            yield _by_values(row)
            row = []
        row.append(b)
    yield _by_values(row)


def _length(product: Equation) -> int:
    """About how many characters a product has by its value."""
    return len(as_text(line(product.sides[0], product.sides[-1]))) + BETWEEN


def _by_values(row: Sequence[Equation]) -> Equation:
    """Products in one row."""
    first, *rest = ((b.sides[0], b.sides[-1]) for b in row)
    beside = [p for i, (name, value) in enumerate(rest) for p in (", " if i else "likewise ", name, " = ", value)]
    return Equation(first, note=line(*beside))


def _written(equation: Equation) -> Line:
    """name = numbers = value, as it stands beside another."""
    return line(*(p for i, side in enumerate(equation.sides) for p in (" = " if i else "", side)))


def _along(told: Told, chain: Sequence[Arm], e: Line, level: str, link: Arm) -> Iterator[Inline | Line | str]:
    """The component along e of the velocity, or acceleration, of the end of a chain that hangs on the ground:
    ω_AB (k × r_B/A) · e + ω_BC (k × r_C/B) · e, of the accelerations α (k × r) · e - ω² r · e.
    """
    motion, idle, opens = told.motion, (0, *told.zero), True
    for arm in chain:
        name, math = _name(arm), told.phrases.math
        turns, begins = motion.velocities[arm.body].angular, motion.accelerations[arm.body].angular
        rate = turns if level == "velocity" else begins
        if rate not in idle and arm is not link:
            yield line("" if opens else " + ", math(rate), " (", Name("k"), " × ", name, ") · ", *e)
            opens = False
        if level != "velocity" and turns not in idle:
            yield line("-" if opens else " - ", math(turns**2), " ", name, " · ", *e)
            opens = False


def _name(arm: Arm) -> Name:
    return Name(f"r_{arm.end.replace('_', ',')}/{arm.start.replace('_', ',')}")


def _is_along(arm: Arm, unit: Sequence[Decimal]) -> bool:
    (x, y), (u, v) = arm.sizes, unit
    return abs(x * v - y * u) < NEARLY * max(abs(x), abs(y))


def _arms(told: Told, body: str, j: Joining) -> Iterator[Arm]:
    """The arms of a chain of pinned bodies, from the ground to the joint; none of a chain of another kind."""
    edges = {e.body: e for e in told.system.tree.edges}
    found, at, place = list[Arm](), j.point, j.place
    while body != GROUND:
        edge = edges.get(body)
        if edge is None or edge.joining is None or edge.spin is None or edge.particle:
            return
        if edge.joining.path is not None or edge.joining.rolling is not None or edge.joining.drift is not None:
            return
        arm = told.system.scene.arms.between(edge.joining.point, at)
        x, y = (told.phrases.of_dimension(told.phrases.certain(p), LENGTH).number for p in (arm.x, arm.y))
        found.append(Arm(body, edge.joining.place, place, (x, y)))
        body, place, at = edge.parent, edge.joining.place, edge.joining.point
    yield from reversed(found)


def _products(
    told: Told, arm: Arm, along: tuple[Line, Sequence[Decimal]], level: str, enters: bool
) -> Iterator[Equation]:
    """(k × r) · e where ω or α of the body stands in the equation, r · e where ω² does; each once. `enters`: it is not
    the link across which e kills what its own rate gives.
    """
    (e, unit), (x, y), motion = along, arm.sizes, told.motion
    turns, begins = motion.velocities[arm.body].angular, motion.accelerations[arm.body].angular
    idle = (0, *told.zero)
    name = _name(arm)
    if (turns if level == "velocity" else begins) not in idle and enters:
        yield from _product(told, line("(", Name("k"), " × ", name, ") · ", *e), (-y, x), unit)
    if level != "velocity" and turns not in idle:
        yield from _product(told, line(name, " · ", *e), (x, y), unit)


def _product(told: Told, name: Line, vector: tuple[Decimal, Decimal], unit: Sequence[Decimal]) -> Iterator[Equation]:
    key = f"product {name}"
    size = vector[0] * unit[0] + vector[1] * unit[1]
    if key in told.valued:
        return
    told.valued.add(key)
    sign, figures = coherent_unit(LENGTH, us=told.phrases.ledger.us).text, told.phrases.figures
    vanishes = abs(size) < NEARLY * max(map(abs, vector))
    yield Equation((name, sum_along(unit, vector, figures), line("0") if vanishes else Value(size, sign, figures)))
