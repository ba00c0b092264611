"""What a file prescribes of its motion, as constraints: relations of places, velocities or accelerations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from planar_cli.errors import refuse
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.scene.stated import Stated, stated
from planar_cli.motion.terms.constraints import Constraint, of_accelerations, of_places, of_velocities
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.problem.language.expression import Quantity, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.records import record

FORCES = frozenset("N tension moment friction reaction force power mode".split())
"""Quantities that only the equations of motion tell."""
PLACES, VELOCITIES, ACCELERATIONS = 0, 1, 2
"""Of what a relation is."""


@record
class Asked:
    """The quantities of a scene with its accelerations as variables."""

    layout: Layout
    accelerations: tuple[Term, ...]
    quantities: Quantities

    def level(self, term: Term) -> int | None:
        """Of what a term is; None: of time and constants alone."""
        inside = set(ordered([term]))
        for level, variables in (
            (ACCELERATIONS, self.accelerations),
            (VELOCITIES, self.layout.speeds),
            (PLACES, self.layout.coordinates),
        ):
            if inside & set(variables):
                return level
        return None

    def said(self, statements: Iterable[Statement]) -> list[Stated]:
        """The equations among them that say nothing of forces."""
        return list(stated((r for r in statements if isinstance(r, Relation) and not of_forces(r)), self.quantities))


def asked_of(scene: MovingScene, layout: Layout) -> Asked:
    """The scene's quantities; made once per scene."""
    graph = scene.graph
    accelerations = tuple(graph.variable(scene.free_name(f"acceleration{i}"), 0.0) for i in range(layout.count))
    by_rate = dict(zip(layout.speeds, accelerations, strict=True))
    return Asked(layout, accelerations, Quantities(scene, scene.stored_energy, by_rate))


def of_forces(relation: Relation) -> bool:
    """Does it speak of forces or modes?"""
    return any(isinstance(node, Quantity) and node.word in FORCES for node in walk(relation))


def drives_of(scene: MovingScene, asked: Asked) -> tuple[Constraint, ...]:
    """The equations of `motion` that hold at all times."""
    statements = [law.statement for law in scene.problem.motion if law.during is None]
    found: list[Constraint] = []
    for relation in asked.said(statements):
        if any(_bent(asked, residual) for residual in relation.residuals):
            text = f"`{relation.text}` leaves open which way the acceleration goes"
            raise refuse(relation.mark, "PL716", text, "give its components, as `a(P).x = …`")
        found += constraints_of(asked, relation.text, relation.residuals)
    return tuple(found)


def _bent(asked: Asked, residual: Term) -> bool:
    """Do accelerations stand in it otherwise than linearly?"""
    if asked.level(residual) != ACCELERATIONS:
        return False
    slopes = asked.layout.graph.gradient(residual)
    return any(asked.level(slopes[a]) == ACCELERATIONS for a in asked.accelerations if a in slopes)


def constraints_of(asked: Asked, title: str, residuals: Sequence[Term]) -> list[Constraint]:
    """Residuals as constraints, at the level at which they are written."""
    found = []
    for residual in residuals:
        match asked.level(residual):
            case 0:
                found.append(of_places(asked.layout, "", title, residual))
            case 1:
                found.append(of_velocities(asked.layout, title, residual))
            case 2:
                found.append(of_accelerations(asked.layout, title, residual, asked.accelerations))
    return found
