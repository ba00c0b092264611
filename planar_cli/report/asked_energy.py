"""The kinetic energy that is asked of one instant: of each body by the velocity of its mass centre and its turning."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Protocol

import sympy as sp

from planar_cli.equation.centres import centre_of
from planar_cli.equation.scene import Scene
from planar_cli.problem.expression import Quantity
from planar_cli.report.blocks import Block, Equation, Math, Name, Paragraph, line
from planar_cli.report.inertias import alike_together, inertia_line
from planar_cli.report.vectors import VectorTelling, index_of
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.units import VELOCITY, Dimension

ALL = "all"


class Telling(Protocol):
    """What tells velocities of points."""

    @property
    def phrases(self) -> Phrases: ...
    @property
    def scene(self) -> Scene: ...
    @property
    def vectors(self) -> VectorTelling: ...

    def absolute(self, point: str, word: str) -> Iterator[Block]: ...
    def size(self, vector: list[Decimal], dimension: Dimension) -> Math: ...


def kinetic_energy(answer: Found, q: Quantity, telling: Telling) -> list[Block]:
    """v of each mass centre, then T = ½ m v² + ½ I ω² + …; empty where no vector equation leads to a velocity."""
    phrases, scene, motion = telling.phrases, telling.scene, telling.vectors.motion
    if phrases.symbolic or answer.values is None:
        return []
    blocks: list[Block] = []
    parts: list[sp.Expr] = []
    sizes: dict[sp.Symbol, Decimal] = {}
    for name, body in scene.bodies.items():
        if body.mass == 0 or (name not in q.things and ALL not in q.things):
            continue
        v = motion.velocity(body.center, name)
        x, y = phrases.certain(v.x), phrases.certain(v.y)
        omega = motion.velocities[name].angular if body.rigid else sp.S.Zero
        if x or y:
            told = list(telling.absolute(name, "v"))
            own = centre_of(scene, name)
            if not told:
                return []
            blocks += [*told, *_size(index_of(own), (x, y), telling)]
            speed = sp.Symbol(f"v_{index_of(own)}", positive=True)
            sizes[speed] = phrases.of_dimension((x * x + y * y).sqrt(), VELOCITY).number
            parts.append(sp.Mul(sp.Rational(1, 2), body.mass, speed**2, evaluate=False))
        if omega != 0 and body.inertia != 0:
            parts.append(sp.Mul(sp.Rational(1, 2), body.inertia, omega**2, evaluate=False))
    if not parts:
        return []
    whole = sp.Add(*parts, evaluate=False)
    inside = (s for b in scene.bodies.values() for s in sp.sympify(b.inertia).free_symbols & whole.free_symbols)
    made = {s: scene.ledger.definitions[s] for s in inside if s in scene.ledger.definitions}
    new = [inertia_line(s, e, scene, phrases) for s, e in made.items() if s not in telling.vectors.named]
    numbers = phrases.numbers(whole, sizes, turns=False)
    values = phrases.in_units(answer.values[0], answer.unit, answer.energy)
    put = () if numbers is None else (numbers,)
    head = Paragraph(line("Kinetic energy, of each body by its mass centre and its turning:"))
    return [
        head,
        *blocks,
        *alike_together(new),
        Equation((line(Name(answer.name)), phrases.math(whole), *put, *values)),
    ]


def _size(index: str, parts: tuple[Decimal, Decimal], telling: Telling) -> Iterator[Block]:
    """|v| = √(x² + y²) of an oblique velocity."""
    if all(parts):
        size = telling.size(list(parts), VELOCITY)
        value = telling.phrases.of_dimension(sum((p * p for p in parts), Decimal(0)).sqrt(), VELOCITY)
        yield Equation((line(Name(f"v_{index}")), size, value))
