"""What is large and what is small in a scene: every tolerance of a motion is a part of one of these."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.records import record

ROUNDED = 1e-12
"""A motion as drawn that is slower, by this part, than the numbers of the file say is a rest that was rounded; a force
that is quicker is one that has no size as drawn, as that of a steady power at rest.
"""


@record
class Scales:
    """The usual size of each kind of quantity, in SI units."""

    length: float
    """m: how far the drawing reaches."""
    mass: float
    """kg: the largest of the bodies' masses."""
    time: float
    """s: in which accelerations change places by the length."""

    @property
    def speed(self) -> float:
        """m/s."""
        return self.length / self.time

    @property
    def force(self) -> float:
        """N."""
        return self.mass * self.length / self.time**2

    @property
    def energy(self) -> float:
        """J."""
        return self.force * self.length


def scales_of(
    length: float, masses: Sequence[float], accelerations: Sequence[float], speeds: Sequence[float], time: float
) -> Scales:
    """`accelerations`: gravity, forces by masses [m/s²], and `speeds` [m/s], all without sign; the quickest counts.

    `time`: that of the numbers of the file [s], where nothing pushes or is driven as drawn.
    """
    times = [math.sqrt(length / a) for a in accelerations if a > 0]
    times += [length / v for v in speeds if v > 0]
    times = [t for t in times if time * ROUNDED < t < time / ROUNDED]
    return Scales(length, max(masses, default=0.0) or 1.0, min(times, default=time))
