"""How far two solutions of one instant agree."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.equation.values.exact import ZERO
from planar_cli.joints.base import Joint
from planar_cli.records import record
from planar_cli.solve.multibody.time_jets import ONE

FULL = 50
"""More digits than this are not claimed."""
ENOUGH = 15
"""Values that agree to fewer digits disagree."""
NOTHING = Decimal(10) ** -FULL
FEW = Decimal(10) ** -ENOUGH
CANCELLED = Decimal(10) ** (ENOUGH - FULL)
"""Beside the largest of its kind a smaller number has not enough digits left."""


@record
class Agreement:
    """How far two solutions agree.

    `velocities_ok`: the largest rate of a residual, relative to its terms (0: the velocities fit all joints). `digits`:
    to which all determined accelerations and joint forces agree. `disagreements`: what differs, with both values.
    `changed`: a joint that takes for granted what the velocities change, and what it does then; None: none does.
    """

    velocities_ok: Decimal
    digits: int
    disagreements: tuple[str, ...]
    changed: tuple[Joint, str] | None = None

    @property
    def holds(self) -> bool:
        """Does nothing speak against the worked solution?"""
        return not self.disagreements


def agreeing(a: Decimal, b: Decimal, scale: Decimal, driven: Decimal = ZERO) -> int:
    """Common digits of two numbers; all when both are nothing beside the largest of their kind. What has cancelled
    agrees to the digits that it has beside what drives it, or beside that largest.
    """
    difference, size = abs(a - b), max(abs(a), abs(b))
    if size < FEW * driven:
        size = driven
    elif size < CANCELLED * scale:
        size = scale
    if difference <= NOTHING * max(scale, ONE) or not size:
        return FULL
    return max(0, min(FULL, int(-(difference / size).log10())))


def short(value: Decimal) -> str:
    """A number in print."""
    return f"{value:.12g}"
