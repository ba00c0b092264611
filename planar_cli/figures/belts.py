"""What moves and is no body: a belt over rollers, with its speed, and the axes of a frame of reference."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.figures.drawn import Drawn, size_of
from planar_cli.figures.rings import around, circle, way_of
from planar_cli.figures.shapes import moved
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Line, Outline, Surface
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Arc, Arrow, Hatched, Mark, Polyline

SLENDER = 0.05
"""The radius of its rollers in parts of its length."""


def belt_marks(drawn: Drawn, surface: Surface, mark: Mark) -> Iterator[Mark]:
    """A surface as it is drawn; one that runs as a belt over rollers on its hatched side, with an arrow."""
    speed = surface.speed
    if speed is None or not isinstance(mark, Hatched) or not isinstance(surface.shape, Line):
        yield mark
        return
    (start, end), way = (mark.places[0], mark.places[-1]), way_of(mark.places[0], mark.places[-1])
    radius = SLENDER * math.dist(start, end)
    centers = [moved(at, way, 0.0, -radius) for at in (start, end)]
    ring = around([p for at in centers for p in circle(at, radius)])
    yield Polyline((*ring, ring[0]), "rope")
    yield from (Arc(at, 0.75 * radius, "body") for at in centers)
    along, size = drawn.angle(drawn.scene.surface_direction(surface)), drawn.length(speed)
    if along is not None:
        # A speed without a number goes as it is written.
        heading = along + math.pi if size is not None and size < 0 else along
        backward = math.cos(heading - way) < 0
        at = moved(end if backward else start, way, (-0.3 if backward else 0.3) * math.dist(start, end), -radius)
        yield Arrow(at, heading, "velocity", size_of(speed, size))


def frame_marks(drawn: Drawn) -> Iterator[Mark]:
    """The axes x' and y' of a body without mass from which the motion of something is to be seen."""
    problem = drawn.scene.problem
    seen = {
        n.things[1] for f in problem.find for n in walk(f.found.what) if isinstance(n, Quantity) and len(n.things) == 2
    }
    for body in problem.bodies:
        bare = isinstance(body.shape, Outline) and body.shape.rim is None
        model, spot = drawn.body(body.name), drawn.carried(body.name, body.points[0]) if body.points else None
        theta = drawn.number(model.theta) if model is not None else None
        if bare and body.is_massless and body.name in seen and spot is not None and theta is not None:
            for name, angle in (("x\u2032", theta), ("y\u2032", theta + math.pi / 2)):
                yield Arrow(spot, angle, "axis", line(Name(name)), 0.75)
