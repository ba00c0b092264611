"""Bodies as they are drawn: each by its shape, in the position of the scene."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import singledispatch
from typing import Any

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.axes_of_turning import axis_marks, is_axis
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.outlines import outlines
from planar_cli.figures.partners import between
from planar_cli.figures.rings import around, way_of
from planar_cli.problem.scene.scene import Composite, Outline, Particle, Plate, Rod, Round, Sector
from planar_cli.report.document.marks import Arc, Mark, Polyline, Spot, Style, Symbol

HOOP = "ring"
ASIDE = 1e-6
"""What is farther from a rod, in parts of its length, is not on it."""
SMOOTH = 36
"""So many strokes make an arc."""


def body_marks(drawn: Drawn, body: BodyModel, style: Style = "body") -> Iterator[Mark]:
    """The shape of a body; nothing of one whose place nobody knows."""
    yield from _shape(body.shape, drawn, body, style)


@singledispatch
def _shape(shape: Any, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    raise TypeError(type(shape).__name__)


@_shape.register
def _particle(shape: Particle, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    at = drawn.spot(body.center)
    found = outlines(drawn, body)
    yield from (Polyline(c.places, style, c.closed) for c in found)
    if at is not None and not found:
        yield Symbol("particle", at)


@_shape.register
def _rod(shape: Rod, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    start, center = drawn.carried(body.name, shape.start), drawn.spot(body.center)
    if start is not None and shape.end is None and shape.length is None:
        # One of no length goes a little beyond what slides along it.
        problem = drawn.scene.problem
        guided = {getattr(j, "point", None) for j in problem.joints if body.name in between(j)}
        spots = [s for p in problem.points if p.name in guided and (s := drawn.named(p.name)) is not None]
        far = max(spots, key=lambda s: math.dist(s, start), default=start)
        if math.dist(far, start) > 0:
            yield Polyline((start, moved(far, way_of(start, far), math.dist(start, far) / 8)), style)
    elif start is not None and center is not None:
        end = (2 * center[0] - start[0], 2 * center[1] - start[1])
        if is_axis(drawn.scene.problem, body.name):
            yield from axis_marks(start, end)
            return
        yield Polyline((start, end), style)
        yield from _aside(drawn, body, start, end, style)


def _aside(drawn: Drawn, body: BodyModel, start: Spot, end: Spot, style: Style) -> Iterator[Mark]:
    """What holds points that belong to a rod and are not on it, as the coupler point of a four-bar."""
    written = next((b for b in drawn.scene.problem.bodies if b.name == body.name), None)
    for name in written.points if written is not None else ():
        spot = drawn.carried(body.name, name)
        if spot is not None and math.dist(start, spot) + math.dist(spot, end) > math.dist(start, end) * (1 + ASIDE):
            yield Polyline((start, spot, end), "hidden" if style == "hidden" else "thin")


@_shape.register
def _round(shape: Round, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    center = drawn.carried(body.name, shape.center)
    for side in (shape.radius, shape.hub):
        radius = drawn.length(side) if side is not None else None
        if center is not None and radius:
            yield Arc(center, radius, style if side is shape.radius else "thin", hollow=shape.kind == HOOP)


@_shape.register
def _sector(shape: Sector, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    apex, radius = drawn.carried(body.name, shape.apex), drawn.length(shape.radius)
    span = drawn.length(shape.span)
    axis = drawn.number(body.theta)
    if apex is None or not radius or span is None or axis is None:
        return
    start = axis - span / 2
    rim = tuple(moved(apex, start + span * i / SMOOTH, radius) for i in range(SMOOTH + 1))
    # A half disk has its apex on its edge.
    yield Polyline(rim if abs(span - math.pi) < 1e-9 else (apex, *rim), style, closed=True)


@_shape.register
def _plate(shape: Plate, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    center = drawn.carried(body.name, shape.center)
    along = drawn.angle(drawn.scene.along_plate(body.name, shape))
    width, height = drawn.length(shape.width), drawn.length(shape.height)
    if center is None or along is None or not width or not height:
        return
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    places = tuple(moved(center, along, i * width / 2, j * height / 2) for i, j in corners)
    yield Polyline(places, style, closed=True)


@_shape.register
def _any(shape: Outline, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    if shape.rim is not None:
        yield from _round(shape.rim, drawn, body, style)
        return
    yield from (Polyline(c.places, style, c.closed) for c in outlines(drawn, body))


@_shape.register
def _composite(shape: Composite, drawn: Drawn, body: BodyModel, style: Style) -> Iterator[Mark]:
    for piece in shape.pieces:
        part = BodyModel(
            body.name, piece.shape, True, body.mass, body.inertia, _centre_of(drawn, body, piece), "", body.theta
        )
        yield from _shape(piece.shape, drawn, part, style)
    # Masses at some points are held together by something light.
    points = [p.shape.place for p in shape.pieces if isinstance(p.shape, Particle) and isinstance(p.shape.place, str)]
    places = [s for name in points if (s := drawn.carried(body.name, name)) is not None]
    if len(places) > 1:
        yield Polyline(tuple(around(places)), "hidden" if style == "hidden" else "thin", closed=len(places) > 2)


def _centre_of(drawn: Drawn, body: BodyModel, piece: Any) -> Any:
    """The mass centre of a part, which tells where a rod has its other end."""
    shapes = drawn.scene
    shape = piece.shape
    if isinstance(shape, Rod) and shape.end is not None:
        ends = [shapes.carried(body.name, p) for p in (shape.start, shape.end)]
        return (ends[0] + ends[1]) / 2
    if isinstance(shape, Particle) and isinstance(shape.place, str):
        return shapes.carried(body.name, shape.place)
    for (_, _, center), other in zip(body.parts, getattr(body.shape, "pieces", ()), strict=False):
        if other is piece:
            return center
    return body.center


def moved(start: Spot, along: float, ahead: float, left: float = 0.0) -> Spot:
    """The place `ahead` in a direction, and `left` of it."""
    cos, sin = math.cos(along), math.sin(along)
    return (start[0] + ahead * cos - left * sin, start[1] + ahead * sin + left * cos)
