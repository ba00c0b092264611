"""What goes one way along a straight line through a whole motion: that way counts as positive."""

from __future__ import annotations

from planar_cli.records import record

AGAINST = {"x": "to the left", "y": "downward"}
"""The ways against the axes."""


@record
class Going:
    """How a body goes: a unit vector that way."""

    x: float
    y: float
    past_zero: bool
    """Does its place pass the origin of the file? Then that is the origin of its way, else where it starts."""
    from_zero: bool = False
    """Does it start at that origin?"""
    until: str = ""
    """The state with which that ends, as a blow sends it elsewhere; "": it goes so to the end."""

    @property
    def senses(self) -> tuple[int, int]:
        """In which sense its velocity counts along x and along y: -1 along the one against which it goes."""
        return (-1 if self.x < 0 == self.y else 1), (-1 if self.y < 0 == self.x else 1)
