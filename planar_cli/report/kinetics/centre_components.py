"""The accelerations of mass centres: the vector equation of each, then its components. Of many centres the components
of the first ones are told; those of the others are read from their vector equations and arms in the same way.

(1)  a_G,DE,x = 0.4924 α_OA + 0.3064 α_AB + 0.1026 α_BC - 0.06946 α_CD + 0.1607 α_DE - 4.812   in m/s²
Likewise the components of a_G,BC, a_G,AB, a_G,OA: (5) to (10).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.scene.centres import centre_of
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.equations.numeric import OF_CENTRE
from planar_cli.report.equations.results import LIKEWISE, numbered
from planar_cli.report.kinematics.rolled_points import is_named, rolling
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.notation.names import index_of
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Explicit

TOLD, LEAST = 2, 3
"""Of so many centres the components are told, if there are at least so many others."""


def centre_blocks(stage: Stage, vectors: VectorTelling) -> Iterator[Block]:
    """The acceleration of each mass centre that consists of several parts, or turns with its body."""
    system = vectors.system
    scene = system.scene
    for body in dict.fromkeys(body for block in stage.blocks for w in block.equations for body in w.bodies):
        heavy = scene.bodies[body].mass != 0 and scene.rigid(body)
        if heavy and not is_named(stage.accelerations.get(body, ()), vectors.motion.accelerations[body]):
            yield from rolling(system, body, vectors.phrases)
            yield from vectors.point(body, scene.center(body), centre_of(scene, body), "acceleration")


def read_off_arms(stage: Stage | None, vectors: VectorTelling) -> dict[sp.Symbol, str]:
    """The components of accelerations that are told by those of other mass centres, and the name of each centre."""
    if stage is None or len(stage.lines) <= TOLD + LEAST:
        return {}
    own = {x.symbol for x in stage.lines if x.words.startswith(OF_CENTRE)}
    of: dict[str, set[sp.Symbol]] = {}
    for body, parts in stage.accelerations.items():
        letters = {s for _, e in parts for s in e.free_symbols & own}
        if letters and _turns_about_pin(body, vectors):
            of[body] = letters
    first = {x.symbol: i for i, x in enumerate(stage.lines)}
    others = sorted(of, key=lambda body: min(first[s] for s in of[body]))[TOLD:]
    if len(others) < LEAST:
        return {}
    return {s: centre_of(vectors.system.scene, body) for body in others for s in of[body]}


def _turns_about_pin(body: str, vectors: VectorTelling) -> bool:
    """Is the acceleration of the mass centre that of a point at which the body is joined, and what turning adds?"""
    edge = vectors.edges.get(body)
    joined = edge is not None and not edge.particle and edge.joining is not None and edge.joining.rolling is None
    return joined and vectors.motion.accelerations[body].angular != 0


def component_lines(
    lines: Iterable[Explicit],
    others: Mapping[sp.Symbol, str],
    above: Collection[Block],
    tell: Callable[[Explicit], Equation],
    number: Callable[[int], int],
) -> Iterator[Block]:
    """The lines of components; of the `others`, whose vector equations stand `above`, their numbers alone."""
    vectors = {_letter(b.sides[0]) for b in above if isinstance(b, Equation)}
    alike = {s for s, centre in others.items() if f"a_{index_of(centre)}" in vectors}
    waiting: list[Explicit] = []
    for x in lines:
        if x.symbol in alike:
            waiting.append(x)
            continue
        yield from _likewise(waiting, others, number)
        waiting = []
        told = tell(x)
        bare = alike and x.words.startswith(OF_CENTRE)
        yield replace(told, lead=()) if bare else told
    yield from _likewise(waiting, others, number)


def _likewise(
    waiting: Sequence[Explicit], others: Mapping[sp.Symbol, str], number: Callable[[int], int]
) -> Iterator[Block]:
    if not waiting:
        return
    names = dict.fromkeys(others[x.symbol] for x in waiting)
    listed = [piece for centre in names for piece in (", ", Name(f"a_{index_of(centre)}"))][1:]
    numbers = numbered([number(x.number) for x in waiting])
    yield Paragraph(line(f"{LIKEWISE}the components of ", *listed, f": {numbers}."))


def _letter(side: object) -> str:
    """The name of the vector that an equation begins with; empty: it begins with something else."""
    first = side[0] if isinstance(side, tuple) and side else side
    return first.name if isinstance(first, Name) else ""
