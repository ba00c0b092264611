"""What the mass centre of a body is called in print."""

from __future__ import annotations

from planar_cli.equation.scene.marks import mark_of
from planar_cli.equation.scene.scene import Scene


def centre_of(scene: Scene, body: str) -> str:
    """What the mass centre of a body is called: its point, of a particle its own name, else G."""
    model = scene.bodies[body]
    if not model.rigid or (model.center_name and (model.center_name != body or body in scene.points)):
        return model.center_name or body
    return mark_of(scene.bodies, scene.points, body)
