"""The angles at which faces lie, each at the foot of its slope: between the face and the level under it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from planar_cli.figures.angles import angle_from_its_zero
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.outlines import outlines
from planar_cli.figures.rings import way_of
from planar_cli.problem.scene.scene import Line, Surface
from planar_cli.report.document.marks import Angle, Spot

NEAR = 1e-6
WIDE = 46.0
"""The radius of an arc under a slope, px: beyond the hatching."""


def slope_angles(drawn: Drawn, edges: Mapping[str, Sequence[Spot]]) -> Iterator[Angle]:
    """`edges`: the fixed lines, as far as they are drawn, by their names."""
    for surface in drawn.scene.problem.surfaces:
        shape = surface.shape
        if not isinstance(shape, Line) or _is_moving(drawn, surface):
            continue
        start = drawn.carried(surface.body, shape.through)
        for angle in angle_from_its_zero(drawn, start, shape.angle) if start is not None else ():
            if surface.body is None:
                yield _under(angle, edges.get(surface.name, ()))
            else:
                yield _at_its_corner(drawn, surface.body, angle)


def _is_moving(drawn: Drawn, surface: Surface) -> bool:
    """Does a face turn with its body, so that the angle of the file is not that of the position?"""
    turn = drawn.number(drawn.scene.turn(surface.body)) if surface.body is not None else 0.0
    return turn is None or abs(turn) > NEAR


def _under(angle: Angle, edge: Sequence[Spot]) -> Angle:
    """At the lower end of a fixed slope."""
    if len(edge) < 2:
        return angle
    foot, top = sorted((edge[0], edge[-1]), key=lambda s: s[1])
    found = _between(angle, foot, way_of(foot, top))
    return replace(found, radius=WIDE) if found is not None else angle


def _at_its_corner(drawn: Drawn, body: str, angle: Angle) -> Angle:
    """At the corner of a body where its face meets the edge from which the angle counts."""
    model = drawn.body(body)
    for contour in outlines(drawn, model) if model is not None else ():
        ring = contour.places
        for i, corner in enumerate(ring) if contour.closed else ():
            ways = [way_of(corner, ring[i - 1]), way_of(corner, ring[(i + 1) % len(ring)])]
            for face, base in (ways, ways[::-1]):
                found = _between(angle, corner, face)
                if found is not None and abs(math.remainder(base - found.start, 2 * math.pi)) < NEAR:
                    return replace(found, radius=WIDE)
    return angle


def _between(angle: Angle, vertex: Spot, face: float) -> Angle | None:
    """The same angle at another place of its face, which goes on from there in a direction; None: it is another one."""
    for start in (angle.start, angle.start + math.pi):
        sweep = math.remainder(face - start, 2 * math.pi)
        if abs(abs(sweep) - abs(angle.sweep)) < NEAR:
            return replace(angle, vertex=vertex, start=start, sweep=sweep)
    return None
