"""The outlines with which things touch where they are drawn: round ones, and straight edges."""

from __future__ import annotations

from planar_cli.equation.scene.scene import Scene
from planar_cli.errors import NOWHERE
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Circle, Composite, Line, Sector
from planar_cli.problem.scene.shapes import rim_of


def round_center(scene: Scene, partner: str, place: Vec) -> Vec | None:
    """The centre of a disk, of a circular surface, or of the arc of a body that is round at a place."""
    surface = scene.surfaces.get(partner)
    if surface is not None:
        return scene.point(surface.shape.center) if isinstance(surface.shape, Circle) else None
    body = scene.bodies.get(partner)
    if body is not None and (rim := rim_of(body.shape)) is not None:
        return scene.point(rim.center)
    if body is not None and isinstance(body.shape, Composite | Sector):
        outline = scene.outline(partner, place, NOWHERE)
        return outline.center if outline.kind == "arc" else None
    return None


def is_straight(scene: Scene, partner: str, place: Vec) -> bool:
    """Is it a line or an edge that a rim touches here? A corner or a particle takes the point along itself."""
    surface = scene.surfaces.get(partner)
    if surface is not None:
        return isinstance(surface.shape, Line)
    return scene.outline(partner, place, NOWHERE).kind == "straight"
