"""What a file prescribes of its motion, as constraints: relations of places, velocities or accelerations."""

from __future__ import annotations

from planar_cli.motion.constraints import Constraint, of_accelerations, of_places, of_velocities
from planar_cli.motion.layout import Layout
from planar_cli.motion.quantities import Quantities
from planar_cli.motion.scene import MovingScene
from planar_cli.motion.terms import ordered
from planar_cli.problem.expression import Relation


def drives_of(scene: MovingScene, layout: Layout) -> tuple[Constraint, ...]:
    """The equations of `motion` that hold at all times."""
    graph = scene.graph
    accelerations = [graph.variable(scene.free_name(f"a{i}"), 0.0) for i in range(layout.count)]
    asked = Quantities(scene, scene.stored_energy, dict(zip(layout.speeds, accelerations, strict=True)))
    found = []
    for law in scene.problem.motion:
        relation = law.statement
        if law.during is not None or not isinstance(relation, Relation) or relation.operator != "=":
            continue
        off = asked.sides.value(relation.left) - asked.sides.value(relation.right)
        inside = set(ordered([off]))
        title = "what the file prescribes of the motion"
        if inside & set(accelerations):
            found.append(of_accelerations(layout, title, off, accelerations))
        elif inside & set(layout.speeds):
            found.append(of_velocities(layout, title, off))
        elif inside & set(layout.coordinates):
            found.append(of_places(layout, "", title, off))
    return tuple(found)
