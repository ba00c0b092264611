"""Where the mass centre of a body of several parts lies, x_G = Σ m x/m in numbers, and how far from its parts.

For lines whose formula would hide the units of numbers that the file gives.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.part_names import part_names
from planar_cli.problem.scene.scene import Composite
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.units import LENGTH, MASS

CENTRE = re.compile(r"([xy]) of the mass centre of (\w+)$")
ARM = "from the mass centre to that of "
MOST = 5
"""A sum over more parts is not written out."""


def in_parts(title: str, scene: Scene, phrases: Phrases) -> tuple[Line | Math, ...]:
    """The sides between a coordinate of a mass centre, or the arm of a part, and its value; empty of other lines."""
    if found := CENTRE.match(title):
        return _centre(found[1], found[2], scene, phrases)
    whole = (b for b in scene.problem.bodies if title.startswith(ARM) and isinstance(b.shape, Composite))
    arms = ((i, b.name) for b in whole for i, name in enumerate(part_names(b, scene.problem)) if title == ARM + name)
    return next((_arm(i, name, scene, phrases) for i, name in arms), ())


def _centre(axis: str, body: str, scene: Scene, phrases: Phrases) -> tuple[Line | Math, ...]:
    """Σ m x/m = (18.84 · 0.2 + (-2.774) · 0.25)/16.07, without parts that lie at 0."""
    model = scene.bodies[body]
    masses = [_size(mass, MASS, phrases) for mass, _, _ in model.parts]
    places = [_size(getattr(center, axis), LENGTH, phrases) for _, _, center in model.parts]
    pairs = [(m, x) for m, x in zip(masses, places, strict=True) if x]
    if len(pairs) > MOST or not pairs:
        return ()

    def worked(n: Sequence[Decimal]) -> Decimal:
        return sum((m * x for m, x in zip(n[1::2], n[2::2], strict=True)), Decimal(0)) / n[0]

    def told(s: Sequence[sp.Symbol]) -> sp.Expr:
        terms = [sp.Mul(m, x, evaluate=False) for m, x in zip(s[1::2], s[2::2], strict=True)]
        return sp.Mul(sp.Add(*terms, evaluate=False), 1 / s[0], evaluate=False)

    sizes = [_size(model.mass, MASS, phrases), *(n for pair in pairs for n in pair)]
    total = line("Σ ", Name("m_i"), " ", Name(f"{axis}_i"), "/", Name("m"))
    return total, _numbers(sizes, worked, told, phrases)


def _arm(number: int, body: str, scene: Scene, phrases: Phrases) -> tuple[Line | Math, ...]:
    """√((0.25 - 0.1914)² + (0.15 - 0.2)²), without an axis along which there is no distance."""
    model = scene.bodies[body]
    ends = [model.parts[number][2], model.center]
    reaches = [[_size(getattr(end, axis), LENGTH, phrases) for end in ends] for axis in ("x", "y")]
    sizes = [n for one, other in reaches if one != other for n in (one, other)]
    if len(sizes) == len(ends):
        sizes.sort(reverse=True)
        return (_numbers(sizes, lambda n: n[0] - n[1], lambda s: sp.Add(s[0], -s[1], evaluate=False), phrases),)
    if not sizes:
        return ()

    def worked(n: Sequence[Decimal]) -> Decimal:
        return sum(((a - b) ** 2 for a, b in zip(n[::2], n[1::2], strict=True)), Decimal(0)).sqrt()

    def told(s: Sequence[sp.Symbol]) -> sp.Expr:
        squares = (sp.Add(a, -b, evaluate=False) ** 2 for a, b in zip(s[::2], s[1::2], strict=True))
        return sp.sqrt(sp.Add(*squares, evaluate=False), evaluate=False)

    return (_numbers(sizes, worked, told, phrases),)


def _numbers(
    sizes: Sequence[Decimal],
    worked: Callable[[Sequence[Decimal]], Decimal],
    told: Callable[[Sequence[sp.Symbol]], sp.Expr],
    phrases: Phrases,
) -> Math:
    """Numbers in a formula, with as many figures as its value needs."""
    figures = figures_of(sizes, worked, phrases.figures)
    symbols = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in range(len(sizes))]
    texts = {s: significant(n, figures) for s, n in zip(symbols, sizes, strict=True)}
    return Math(told(symbols), texts)


def _size(expr: Any, dimension: Any, phrases: Phrases) -> Decimal:
    """A value in the unit of the page, zero where it is that to all certain digits."""
    return phrases.of_dimension(phrases.certain(sp.sympify(expr)), dimension).number
