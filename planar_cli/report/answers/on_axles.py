"""The size of a vector by what the page knows better than its components along x and y.

A point of a body on a fixed pin has the speed r ω, at right angles to its arm; an acceleration whose tangential and
normal parts are asked as well has √(a_t² + a_n²).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import display
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, Name, Paragraph, Value, line
from planar_cli.report.instant.on_circle import angle_of, components, unit_vectors
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

KINDS = ("t", "n")
SHORT = 3
"""An arm of more operations is no radius."""
SAME = Decimal("1e-9")
RIGHT = 90


@record
class Sized:
    """The sides of a size before its value; those of the direction, with what stands beside them, where it is told by
    the arm.
    """

    size: tuple[Any, ...]
    direction: tuple[Any, ...] = ()
    beside: Line = ()
    parts: tuple[str, ...] = ()
    """The answers that the size is told by."""
    angle: sp.Symbol | None = None
    """That of the arm, where it has a letter in the state, and how large it is, in radians."""
    theta: Decimal = Decimal(0)
    components: tuple[tuple[Math, Math], ...] = ()
    """Formula and numbers of each component, where they are told by the parts."""
    vectors: Paragraph | None = None
    """The unit vectors along and across the path, by which they are."""


def sized(found: Found, part: PartSolution, phrases: Phrases) -> Sized | None:
    """None: the components along x and y are all there is."""
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.parts or len(what.things) != 1 or found.values is None:
        return None
    if what.word == "a":
        return _by_parts(found, what, part, phrases)
    return _about_pin(found, what, part, phrases) if what.word == "v" else None


def _by_parts(found: Found, q: Quantity, part: PartSolution, phrases: Phrases) -> Sized | None:
    """√(a_t² + a_n²) of the parts that are answers as well."""
    parts: dict[str, Decimal] = {}
    names: dict[str, Name] = {}
    for one in part.found:
        what = one.find.found.what if one.find is not None else None
        same = isinstance(what, Quantity) and (what.word, what.things, what.at) == (q.word, q.things, q.at)
        if not same or not isinstance(what, Quantity) or len(what.parts) != 1 or one.values is None:
            continue
        if what.parts[0].kind in KINDS and one.unit.text == found.unit.text:
            parts[what.parts[0].kind] = abs(display(one.values[0], found.unit, phrases.ledger.us))
            names[what.parts[0].kind] = Name(one.name)
    if len(parts) < len(KINDS):
        return None
    numbers = [parts[k] for k in KINDS]
    figures = figures_of(numbers, lambda x: (x[0] ** 2 + x[1] ** 2).sqrt(), phrases.figures)
    letters = [sp.Symbol(f"{NUMBER}{k}", positive=True) for k in KINDS]
    texts = {s: significant(x, figures) for s, x in zip(letters, numbers, strict=True)}
    root = sp.sqrt(sp.Add(*(s**2 for s in letters), evaluate=False), evaluate=False)
    size = (line("√(", names["t"], "² + ", names["n"], "²)"), Math(root, texts))
    return _with_components(Sized(size, parts=tuple(n.name for n in names.values())), found, q, part, parts, phrases)


def _with_components(
    size: Sized,
    found: Found,
    q: Quantity,
    part: PartSolution,
    told: Mapping[str, Decimal],
    phrases: Phrases,
) -> Sized:
    """With the components by a_t and a_n, where the arm has an angle. `told`: the sizes of these."""
    if part.motion is None or not part.instants or found.values is None:
        return size
    scene, (thing,) = part.instants[-1].instant.scene, q.things
    edge = next((e for e in part.instants[-1].trial.system.tree.edges if e.body == scene.owner(thing)), None)
    if edge is None or edge.joining is None or edge.parent != GROUND or not edge.joining.only_turns or edge.particle:
        return size
    angle = angle_of(scene.point(thing) - edge.joining.point)
    own = None if angle is None else _at(angle, q.at, part)
    theta = None if own is None else part.motion.value.known(own)
    if own is None or theta is None or own == angle:
        return size
    whole = [display(v, found.unit, phrases.ledger.us) for v in found.values]
    parts = components(size.parts, [told[k] for k in KINDS], own, theta, whole, phrases.figures)
    if parts is None:
        return size
    vectors = unit_vectors(own, found.name, size.parts, (edge.joining.place, thing))
    return replace(size, angle=own, theta=theta, components=tuple(parts), vectors=vectors)


def _about_pin(found: Found, q: Quantity, part: PartSolution, phrases: Phrases) -> Sized | None:
    """r ω, and the direction of the arm turned by 90°."""
    if not part.instants or found.values is None:
        return None
    instant = part.instants[-1]
    scene, tree, (thing,) = instant.instant.scene, instant.trial.system.tree, q.things
    edge = next((e for e in tree.edges if thing in scene.points and e.body == scene.owner(thing)), None)
    if edge is None or edge.joining is None or edge.parent != GROUND or edge.spin is None or edge.particle:
        return None
    if not edge.joining.only_turns or phrases.symbolic:
        return None
    arm = scene.point(thing) - edge.joining.point
    radius = simplified(sp.sqrt(simplified(arm.dot(arm))))
    spin = _at(edge.spin, q.at, part)
    value = phrases.value if part.motion is None else part.motion.value
    known = value.known(sp.Abs(radius * spin))
    x, y = found.values
    size = (x * x + y * y).sqrt()
    if longer(radius, SHORT) or radius.is_number or known is None or abs(known - size) > SAME * size:
        return None
    shown = Value(display(size, found.unit, phrases.ledger.us), found.unit.text, phrases.figures)
    turn = 1 if value(spin) > 0 else -1
    formula = turn * radius * spin
    sides = (phrases.math(formula), *phrases.substituted(formula, shown))
    way = math.degrees(math.atan2(float(y), float(x)))
    angle = angle_of(arm)
    own = None if angle is None else _at(angle, q.at, part)
    named = () if own is None else line(phrases.math(own))
    theta = None if own is None or own == angle else value.known(own)
    direction = _turned(named, way, turn, None if theta is None else math.degrees(theta))
    told = Sized(sides, direction, line(f"perpendicular to {edge.joining.place}{thing}"))
    return told if theta is None else replace(told, angle=own, theta=theta)


def _turned(named: Line, way: float, turn: int, theta: float | None) -> tuple[Line, ...]:
    """θ_2 + 90° = 38.2° + 90° = 128.2°. `named`: the angle of the arm, if it has a letter; `way`: that of the velocity,
    in degrees; `turn`: 1 where the body turns counterclockwise, else -1; `theta`: the angle of the arm in the state, in
    degrees, from which whole turns are taken.
    """
    before = way - turn * RIGHT
    if theta is None:
        before %= 4 * RIGHT
        before -= 4 * RIGHT if before + turn * RIGHT >= 4 * RIGHT else 0
    quarter = f" {'+' if turn > 0 else '-'} {RIGHT}°"
    sides = [line(*named, quarter)] if named else []
    rounds = 0 if theta is None else round((theta - before) / (4 * RIGHT))
    if rounds and theta is not None:
        whole = f"{abs(rounds)} · {4 * RIGHT}°" if abs(rounds) > 1 else f"{4 * RIGHT}°"
        sides[0] = line(*sides[0], f" {'-' if rounds > 0 else '+'} {whole}")
        return (*sides, line(f"{theta:.1f}°{quarter} {'-' if rounds > 0 else '+'} {whole}"), line(f"{way:.1f}°"))
    return (*sides, line(f"{before:.1f}°{quarter}"), line(f"{before + turn * RIGHT:.1f}°"))


def _at(letter: sp.Symbol, state: Any, part: PartSolution) -> sp.Symbol:
    """A letter of the general position as it is in a state; itself where it is the same all the time."""
    if part.motion is None or not isinstance(state, str):
        return letter
    roles = part.motion.ledger.roles
    return next((own for own, of in part.motion.general.items() if of == letter and roles[own].at == state), letter)
