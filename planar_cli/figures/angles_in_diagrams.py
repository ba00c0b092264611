"""The angle by which a page tells where a body is, in its free-body diagram: at its mass centre, between the radius and
the direction from which the angle counts, where an equation below has its letter.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import takewhile

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.angles import CIRCLE, angle_from_its_zero
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.rings import way_of
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Polar
from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Name, line
from planar_cli.report.document.marks import Angle, Arrow, Mark, Panel, Polyline, Spot
from planar_cli.report.document.mentioned import names_in

CLOSE = 1e-3
"""Directions that differ by less, rad, are the same."""
LEAST = 0.05
"""A smaller angle, rad, is not seen."""
NEAR = 1e-9


def with_angles(drawn: Drawn, row: Forces, below: Sequence[Block], panels: Sequence[Panel]) -> list[Panel]:
    """The diagrams of a list of forces, the first with such angles. `below`: what stands behind it on the page."""
    step = takewhile(lambda b: not isinstance(b, Heading), below)
    letters = {name for b in step if isinstance(b, Equation) for name in names_in(b)}
    bodies = [drawn.scene.bodies[name] for name in row.body.split(", ")]
    free, *others = panels
    marks = [m for body in bodies for m in _angle(drawn, body, letters, free)]
    return [replace(free, marks=(*free.marks, *marks)), *others]


def _angle(drawn: Drawn, body: BodyModel, letters: set[str], panel: Panel) -> Iterator[Mark]:
    at = drawn.spot(body.center)
    told = list(_from_a_circle(drawn, body, letters) if at is not None else ())
    told = told or list(_from_the_file(drawn, body, letters) if at is not None else ())
    if at is None or not told or abs(told[0].sweep) < LEAST:
        return
    angle = replace(told[0], vertex=at)
    out = angle.start + angle.sweep
    # Its side is a force along the radius, on whichever side of the place that is drawn, or the way to one at the rim.
    for mark in (m for m in panel.marks if isinstance(m, Arrow)):
        far = math.dist(at, mark.at)
        side = way_of(at, mark.at) if far > NEAR else mark.angle + (math.pi if mark.inward else 0.0)
        along = abs(math.sin(mark.angle - side)) < CLOSE
        for turned in (0.0, math.pi):
            if along and abs(math.remainder(side - out - turned, 2 * math.pi)) < CLOSE:
                if far > NEAR:
                    yield Polyline((at, mark.at), "thin")
                yield replace(angle, start=angle.start + turned)
                return


def _from_a_circle(drawn: Drawn, body: BodyModel, letters: set[str]) -> Iterator[Angle]:
    """Of a particle on a circle, as the page counts it: from the x axis."""
    moves = drawn.scene.displacement.coordinates if drawn.scene.displacement is not None else ()
    for c in moves:
        size = drawn.number(c.symbol)
        if c.body == body.name and c.unit == "rad" and c.words.endswith(CIRCLE) and c.symbol.name in letters and size:
            turned = math.remainder(size, 2 * math.pi)
            yield Angle((0.0, 0.0), 0.0, turned, line("-" if turned < 0 else "", Name(c.symbol.name)))


def _from_the_file(drawn: Drawn, body: BodyModel, letters: set[str]) -> Iterator[Angle]:
    """Of a point that the file tells by a coordinate: from where the file counts it."""
    problem, at = drawn.scene.problem, drawn.spot(body.center)
    moving = {c.name for c in problem.coordinates} & letters
    for point in problem.points:
        if isinstance(point.place, Polar) and _is_at(drawn, point.name, at):
            told = {n.name for n in walk(point.place.angle) if isinstance(n, Letter)}
            yield from angle_from_its_zero(drawn, (0.0, 0.0), point.place.angle) if moving & told else ()


def _is_at(drawn: Drawn, point: str, at: Spot | None) -> bool:
    spot = drawn.named(point)
    return spot is not None and at is not None and math.dist(spot, at) < NEAR
