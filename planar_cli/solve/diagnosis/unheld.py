"""A point that the file draws in a fixed place and gives to a body that nothing holds: it goes with that body."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from planar_cli.equation.system.system import System
from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.check_names import points_of_place
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.scene.shapes import own_points


def unheld(system: System, points: Iterable[str]) -> Diagnostic | None:
    """The refusal for the first body without a joint on whose points the places of `points` rest; None: none is so."""
    problem = system.scene.problem
    rests = list(_beneath(problem, points))
    free = {e.body for e in system.tree.edges if e.joining is None and e.components is None and not e.particle}
    for body in (b for b in problem.bodies if b.name in free):
        carried = next((p for p in rests if p in (*own_points(body.shape), *body.points)), None)
        if carried is not None:
            text = f"{carried} goes with {body.name}, and no joint holds {body.name}"
            hint = f"hold it, `pin: {{at: {carried}, between: [ground, {body.name}]}}`, or leave {body.name} out"
            return Diagnostic(body.mark, "PL651", text, hint)
    return None


def _beneath(problem: Problem, points: Iterable[str]) -> Iterator[str]:
    """The points, and those from which they are drawn."""
    places, seen, waiting = {p.name: p.place for p in problem.points}, set[str](), list(points)
    while waiting:
        point = waiting.pop(0)
        if point not in seen:
            seen.add(point)
            yield point
            waiting += points_of_place(places[point]) if point in places else ()
