"""Points of a body that are written with coordinates, where nothing else tells how the body moves."""

from __future__ import annotations

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.scene import GROUND


def is_written(scene: Scene, motion: Motion, name: str, body: str) -> bool:
    """Is it a point, written with coordinates, of a body without mass that nothing else holds? What the file says of
    such a point is said of its coordinates.
    """
    if body == GROUND or not scene.rigid(body) or scene.bodies[body].mass != 0 or name not in scene.own_points:
        return False
    formula, tree = scene.formulas.get(name), motion.tree
    if formula is None or any(body in (j.mover, j.base) for j in tree.closures):
        return False
    free = any(e.body == body and e.joining is None and e.components is None for e in tree.edges)
    held = any(e.parent == body for e in tree.edges)
    written = formula.x.value.free_symbols | formula.y.value.free_symbols
    return free and not held and bool(written & set(scene.ledger.coordinates))
