"""Where a point is that lies so far from two others: the foot of its perpendicular on their line, and its height.

H: the foot of the perpendicular from C on BD
BD = √(0.5² + 0.1732²) = 0.5292 m
BH = (BC² + BD² - DC²)/(2 BD) = 0.3496 m
HC = √(0.5² - 0.3496²) = 0.3574 m         BH² + HC² = BC²
C = [0.1 + 0.3496 · 0.9449 + 0.3574 · 0.3273, …]
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.scene import TwoFacts
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, Text, line
from planar_cli.report.kinematics.along_slots import distance_named
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.units import LENGTH, PURE

FEET = "HFKLMNQ"
FLAT = Decimal("1e-9")
"""In parts of the distance, a height below it is none."""
ZERO = Decimal(0)
Numbers = Sequence[Decimal]


def with_triangle(place: Equation, name: str, scene: Scene, phrases: Phrases) -> Iterator[Block]:
    """The line that says where a point is, with the triangle that gives it before its numbers, where two distances
    give it.
    """
    found = next((p.place for p in scene.problem.points if p.name == name), None)
    plain = isinstance(found, TwoFacts) and not found.lines and found.x is None and found.y is None
    if not isinstance(found, TwoFacts) or not plain or len(found.distances) != 2 or scene.displacement is not None:
        yield place
        return
    ends = [one for one, _ in found.distances]
    taken = {*scene.points, *scene.bodies, *scene.ledger.symbols}
    foot = next((letter for letter in FEET if letter not in taken), "")
    (a, b), (c, d), (x, y) = (_at(scene, n, phrases) for n in (*ends, name))
    base = ((c - a) ** 2 + (d - b) ** 2).sqrt()
    if not foot or not base:
        yield place
        return
    u, v = (c - a) / base, (d - b) / base
    along, up = (x - a) * u + (y - b) * v, (y - b) * u - (x - a) * v
    first, second = (((x - p) ** 2 + (y - q) ** 2).sqrt() for p, q in ((a, b), (c, d)))
    if abs(up) < FLAT * base:
        yield place
        return
    *before, last = place.lead
    told = last.text.removesuffix(":") if isinstance(last, Text) else ""
    known = (first, second, base, abs(c - a), abs(d - b))
    if abs(along) < FLAT * base:
        along = ZERO
        yield Paragraph(line(*before, told, *_at_right_angles(ends, name)))
        yield _base(ends, known, phrases)
    else:
        head = f"; {foot}: the foot of the perpendicular from {name} on {ends[0]}{ends[1]}"
        yield Paragraph(line(*before, told, head))
        yield from _sides(ends, name, foot, known, (along, abs(up)), phrases)
    sense = 1 if up > 0 else -1
    unit, across = (u, v), (-v * sense, u * sense)
    shown = [_sum((start, along, e, abs(up), n), phrases) for start, e, n in zip((a, b), unit, across, strict=True)]
    words = line(f"Unit vectors from {ends[0]} to {ends[1]}: ", *phrases.vector(*unit, PURE), ", across, towards ")
    yield Paragraph(line(*words, f"{name}: ", *phrases.vector(*across, PURE)))
    yield replace(place, lead=(), sides=(place.sides[0], line("[", shown[0], ", ", shown[1], "]"), place.sides[-1]))


def _at_right_angles(ends: Sequence[str], name: str) -> Line:
    """; BC is perpendicular to BD, as BC² + BD² = DC²."""
    one, other, both = (distance_named(*pair) for pair in ((ends[0], name), (ends[1], name), tuple(ends)))
    return line("; ", *one, " is perpendicular to ", *both, ", as ", *one, "² + ", *both, "² = ", *other, "²")


def _base(ends: Sequence[str], known: Numbers, phrases: Phrases) -> Equation:
    """The distance of both ends."""
    _, _, base, *legs = known
    legs = [leg for leg in legs if leg > FLAT * base]
    name, value = distance_named(ends[0], ends[1]), phrases.of_dimension(base, LENGTH)
    if len(legs) < 2:
        return Equation((name, value))
    root = _put(lambda s: sp.sqrt(s[0] ** 2 + s[1] ** 2), lambda n: (n[0] ** 2 + n[1] ** 2).sqrt(), legs, phrases)
    return Equation((name, root, value))


def _sides(
    ends: Sequence[str], name: str, foot: str, known: Numbers, found: Numbers, phrases: Phrases
) -> Iterator[Block]:
    """The distance of both ends, that of the foot from the first, and the height."""
    first, second, base, *_ = known
    one, other, both = (distance_named(*pair) for pair in ((ends[0], name), (ends[1], name), tuple(ends)))
    part, height = distance_named(ends[0], foot), distance_named(foot, name)
    yield _base(ends, known, phrases)
    formula = line("(", *one, "² + ", *both, "² - ", *other, "²)/(2 ", *both, ")")
    put = _put(
        lambda s: (s[0] ** 2 + s[1] ** 2 - s[2] ** 2) / (2 * s[1]),
        lambda n: (n[0] ** 2 + n[1] ** 2 - n[2] ** 2) / (2 * n[1]),
        (first, base, second),
        phrases,
    )
    beyond = line(f"negative: {foot} lies beyond {ends[0]}") if found[0] < 0 else ()
    yield Equation((part, formula, put, phrases.of_dimension(found[0], LENGTH)), None, (), beyond)
    put = _put(
        lambda s: sp.sqrt(s[0] ** 2 - s[1] ** 2),
        lambda n: max(n[0] ** 2 - n[1] ** 2, ZERO).sqrt(),
        (first, abs(found[0])),
        phrases,
    )
    by = line(*part, "² + ", *height, "² = ", *one, "²")
    yield Equation((height, put, phrases.of_dimension(found[1], LENGTH)), None, (), by)


def _put(
    written: Callable[[list[sp.Symbol]], sp.Expr],
    worked: Callable[[Numbers], Decimal],
    sizes: Numbers,
    phrases: Phrases,
) -> Math:
    """A formula with lengths in the unit of the page, with as many figures as its result takes."""
    numbers = [phrases.of_dimension(n, LENGTH).number for n in sizes]
    figures = figures_of(numbers, worked, phrases.figures)
    letters = [sp.Symbol(f"{NUMBER}{i}", positive=True) for i in range(len(numbers))]
    return Math(written(letters), {s: significant(n, figures) for s, n in zip(letters, numbers, strict=True)})


def _sum(parts: Numbers, phrases: Phrases) -> Any:
    """0.1 + 0.3496 · 0.9449 + 0.3574 · 0.3273: from where it begins, along and across, each with its slope."""
    start, along, e, up, n = parts
    start, along, up = (phrases.of_dimension(p, LENGTH).number for p in (start, along, up))
    numbers = (start, along, e, up, n)
    figures = figures_of(numbers, lambda x: x[0] + x[1] * x[2] + x[3] * x[4], phrases.figures)
    s = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in range(5)]
    terms: list[sp.Expr] = [s[0]] if start else []
    terms += [sp.Mul(p, q, evaluate=False) for p, q, size in ((s[1], s[2], along * e), (s[3], s[4], up * n)) if size]
    terms = terms or [sp.S.Zero]
    texts = {letter: significant(x, figures) for letter, x in zip(s, numbers, strict=True)}
    return Math(terms[0] if len(terms) == 1 else sp.Add(*terms, evaluate=False), texts)


def _at(scene: Scene, name: str, phrases: Phrases) -> tuple[Decimal, Decimal]:
    at = scene.points[name]
    return phrases.certain(at.x), phrases.certain(at.y)
