"""What the points of a drawing are, where nothing rests on its lengths: rear: centre O_A, on road at A."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.problem.scene.scene import Problem, Round
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.mentioned import Mentioned


def points_by_bodies(problem: Problem, page: Mentioned) -> Iterator[Line]:
    """The points of which the page speaks, body by body: its centre, and where it touches."""
    for body in problem.bodies:
        centre = body.shape.center if isinstance(body.shape, Round) else getattr(body.shape, "center", None)
        what = "centre" if isinstance(body.shape, Round) else "mass centre"
        told = [line(f"{what} ", Name(centre))] if centre in page.words and centre != body.name else []
        for joint in problem.joints:
            place, pair = getattr(joint, "at", None), getattr(joint, "between", ())
            if joint.touches and isinstance(place, str) and place in page.words and body.name in pair:
                told.append(line(f"on {next(other for other in pair if other != body.name)} at ", Name(place)))
        if told:
            yield line(f"{body.name}: ", *(p for i, t in enumerate(told) for p in (", " * bool(i), *t)))
