"""Mechanisms in a dead position, in which their links lie on one line and nothing is seen of their angles."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.rings import off, way_of
from planar_cli.figures.shapes import body_marks
from planar_cli.report.document.marks import spots_of
from planar_cli.solve.between.trace.trace import MotionTrace

FLAT = 1e-3
"""As near to a line, in parts of its length, all links lie on it."""


def out_of_line(motion: MotionTrace, there: Drawn, states: Sequence[str]) -> Drawn:
    """A position of a mechanism that the file drives in which its links are seen, if there is one in its states. What
    drives it is given in any of them.
    """
    laws = [law for _, _, own in motion.stretches for law in own]
    if not laws or any(law.order != 1 for law in laws) or not _is_in_line(there):
        return there
    others = (Drawn.in_state(motion, s) for s in states)
    return next((d for d in others if d is not None and not _is_in_line(d)), there)


def _is_in_line(drawn: Drawn) -> bool:
    """Do several links lie on one line?"""
    links = [b for b in drawn.scene.bodies.values() if b.rigid]
    spots = [s for b in links for m in body_marks(drawn, b) for s in spots_of(m)]
    if len(links) < 2 or len(spots) < 2:
        return False
    start, end = max(((a, b) for a in spots for b in spots), key=lambda ends: math.dist(*ends))
    way, length = way_of(start, end), math.dist(start, end)
    return all(off(start, way, s) <= FLAT * length for s in spots)
