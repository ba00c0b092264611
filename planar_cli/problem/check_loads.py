"""Checks of where loads act."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.errors import Diagnostic
from planar_cli.problem.scene import Body
from planar_cli.problem.scope import Scope
from planar_cli.problem.shapes import own_points


def particles_have_one_point(scope: Scope) -> Iterator[Diagnostic]:
    """What acts on a particle acts where it is, not at a point of another body that nothing joins to it."""
    particles = {b.name: b for b in scope.problem.bodies if b.is_particle}
    for load in scope.problem.loads:
        for point, name in load.attachments():
            if name not in particles or point in _points(particles[name]):
                continue
            others = [b.name for b in scope.problem.bodies if b.name != name and point in _points(b)]
            joined = any({name, point} <= scope.mentioned(joint) for joint in scope.problem.joints)
            if others and not joined:
                text = f"{point} is a point of {others[0]}; {load.called} acts on {name}, which is a particle elsewhere"
                hint = f"leave `at` out, or let it act on {others[0]}"
                yield Diagnostic(load.mark, "PL465", text, hint)


def _points(body: Body) -> set[str]:
    """The body and its points, by name."""
    return {body.name, *own_points(body.shape), *body.points}
