"""Where a component of a velocity is given: first the vector equation of that point, of which it is one."""

from __future__ import annotations

import re

from planar_cli.report.blocks import Block
from planar_cli.report.vectors import VectorTelling
from planar_cli.solve.instant.written import Written

COMPONENT = re.compile(r"([va])\((\w+)\)\.[xy] = ")
LEVELS = {"v": "velocity", "a": "acceleration"}


def vector_before(w: Written, vectors: VectorTelling, level: str) -> list[Block]:
    """v_O = ω × r_O/C before the given v_O, where O is a point of a body that turns."""
    found = COMPONENT.match(w.lead) if w.source == "given" and not w.place and not w.times else None
    scene = vectors.system.scene
    if found is None or LEVELS[found[1]] != level or found[2] not in scene.points:
        return []
    body = scene.owner(found[2])
    if body not in scene.bodies or not scene.rigid(body):
        return []
    return list(vectors.point(body, scene.point(found[2]), found[2], level))
