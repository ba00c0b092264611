"""What the mass centre of a rigid body is called that the file does not name."""

from __future__ import annotations

from collections.abc import Container, Mapping

from planar_cli.equation.scene.bodies import BodyModel


def mark_of(bodies: Mapping[str, BodyModel], points: Container[str], body: str) -> str:
    """G of the only rigid body, G_AB of one beside others."""
    alone = sum(b.rigid for b in bodies.values()) == 1 and "G" not in points
    return "G" if alone else f"G_{body}"


def own_mark(bodies: Mapping[str, BodyModel], points: Container[str], body: str) -> str:
    """The name of what a body's mass centre has alone, as an index: of bodies that have theirs at one point, the
    body's; of a rigid body whose mass centre the file does not name G, or G,AB beside others.
    """
    model = bodies[body]
    if not model.center_name:
        return mark_of(bodies, points, body).replace("_", ",") if model.rigid and model.mass != 0 else body
    shared = sum(b.center_name == model.center_name for b in bodies.values()) > 1
    return body if shared else model.center_name
