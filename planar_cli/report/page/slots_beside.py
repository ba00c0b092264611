"""Slots of rods beside the line of the rod: as drawn they are parallel to it, through the point that slides."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.scene import Rod
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.words import Phrases
from planar_cli.units import LENGTH


def slots_beside(scene: Scene, phrases: Phrases) -> Iterator[Line]:
    """Each with the distance of the point from the line of its rod: a slip of the drawing shows there."""
    rods = {b.name for b in scene.problem.bodies if isinstance(b.shape, Rod)}
    for joint in scene.problem.joints:
        along, point = getattr(joint, "along", None), getattr(joint, "point", None)
        rod = along if isinstance(along, str) else getattr(along, "name", "")
        during = joint.during
        if point is None or rod not in rods or (during is not None and not scene.problem.holds_at_first(during)):
            continue
        off = scene.as_drawn((scene.point(point) - scene.center(rod)).cross(scene.direction(rod)))
        number = None if scene.is_zero(off) else phrases.value.known(off)
        if number is None:
            continue
        # A drawn number is no distance: of letters it is only said that the slot lies beside the line.
        away = () if phrases.symbolic else (", ", phrases.of_dimension(abs(number), LENGTH), " beside it")
        yield line(f"slot of {rod} through {point} parallel to its line", *away)
