"""The kinetic energy that is asked of one instant: of each body by the velocity of its mass centre and its turning."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Protocol

import sympy as sp

from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import ALL
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.given.given_vectors import GIVEN, size_of
from planar_cli.report.in_numbers.sums import added
from planar_cli.report.kinematics.by_centre import speed_about
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.kinetics.inertias import alike_together, inertia_line
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.units import VELOCITY

HALF = sp.Rational(1, 2)


class Telling(Protocol):
    """What tells velocities of points."""

    @property
    def phrases(self) -> Phrases: ...
    @property
    def scene(self) -> Scene: ...
    @property
    def vectors(self) -> VectorTelling: ...

    def absolute(self, point: str, word: str) -> Iterator[Block]: ...


@record
class _Energy:
    """The kinetic energy of one body. `sizes`: the speed of its mass centre, in base units."""

    body: str
    formula: sp.Expr
    sizes: dict[sp.Symbol, Decimal]


def kinetic_energy(answer: Found, q: Quantity, telling: Telling) -> list[Block]:
    """v of each mass centre, then T = ½ m v² + ½ I ω² of each body, and their sum; empty where no vector equation
    leads to a velocity.
    """
    phrases, scene = telling.phrases, telling.scene
    if phrases.symbolic or answer.values is None:
        return []
    blocks: list[Block] = []
    energies: list[_Energy] = []
    for name, body in scene.bodies.items():
        if body.mass == 0 or (name not in q.things and ALL not in q.things):
            continue
        found = _of_body(name, telling)
        if found is None:
            return []
        blocks += found[0]
        energies += found[1]
    if not energies:
        return []
    whole = sp.Add(*(e.formula for e in energies))
    inside = (s for b in scene.bodies.values() for s in sp.sympify(b.inertia).free_symbols & whole.free_symbols)
    made = {s: scene.ledger.definitions[s] for s in inside if s in scene.ledger.definitions}
    new = [inertia_line(s, e, scene, phrases) for s, e in made.items() if s not in telling.vectors.named]
    head = Paragraph(line("Kinetic energy of each body:"))
    return [head, *blocks, *alike_together(new), *_summed(answer, energies, phrases)]


def _of_body(name: str, telling: Telling) -> tuple[list[Block], list[_Energy]] | None:
    """The lines of the speed of a mass centre, and the energy that it makes with turning; None: nothing tells it."""
    scene, motion, certain = telling.scene, telling.vectors.motion, telling.phrases.certain
    body = scene.bodies[name]
    v = motion.velocity(body.center, name)
    x, y = certain(v.x), certain(v.y)
    omega = motion.velocities[name].angular if body.rigid else sp.S.Zero
    blocks: list[Block] = []
    parts, sizes = [], {}
    if x or y:
        place = centre_of(scene, name)
        own = index_of(place)
        if (centre := telling.vectors.centres.get(name)) is not None:
            blocks = [*speed_about(centre, body.center, place, line(Name(f"v_{own}")), telling.vectors)]
        else:
            told = list(telling.absolute(name, "v"))
            if not told:
                return None
            # A speed that the file calls so is under Given.
            known = f"v_{own}" in scene.ledger.symbols
            told = [b for b in told if not (known and isinstance(b, Equation) and b.note == line(GIVEN))]
            blocks = [*told, *_size(own, (x, y), telling)]
        speed = sp.Symbol(f"v_{own}", positive=True)
        sizes[speed] = (x * x + y * y).sqrt()
        parts.append(sp.Mul(HALF, body.mass, speed**2, evaluate=False))
    if omega != 0 and body.inertia != 0:
        parts.append(sp.Mul(HALF, body.inertia, omega**2, evaluate=False))
    return blocks, [_Energy(name, sp.Add(*parts, evaluate=False), sizes)] if parts else []


def _summed(answer: Found, energies: list[_Energy], phrases: Phrases) -> Iterator[Equation]:
    """The energy of each body with its numbers, and what all of them have."""
    assert answer.values is not None
    values = phrases.in_units(answer.values[0], answer.unit, answer.energy)
    told = line(Name(answer.name))
    amounts = [phrases.value.extended(e.sizes)(e.formula) for e in energies]
    for e, amount in zip(energies, amounts, strict=True):
        sizes = {s: phrases.of_dimension(v, VELOCITY).number for s, v in e.sizes.items()}
        numbers = phrases.numbers(e.formula, sizes, turns=False)
        put = () if numbers is None else (numbers,)
        alone = len(energies) == 1
        own = values if alone else phrases.in_units(amount, answer.unit, answer.energy)[:1]
        yield Equation((told if alone else line(*told, f" of {e.body}"), phrases.math(e.formula), *put, *own))
    if len(energies) > 1:
        yield Equation((told, line(*added(amounts, phrases.page_unit(answer.unit), phrases)), *values))


def _size(index: str, parts: tuple[Decimal, Decimal], telling: Telling) -> Iterator[Block]:
    """|v| = √(x² + y²) of an oblique velocity."""
    if all(parts):
        size = size_of(parts, VELOCITY, telling.phrases)
        value = telling.phrases.of_dimension(sum((p * p for p in parts), Decimal(0)).sqrt(), VELOCITY)
        yield Equation((line(Name(f"v_{index}")), size, value))
