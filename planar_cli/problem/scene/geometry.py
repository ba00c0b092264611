"""Plane vectors over any kind of number: exact expressions, decimals, or jets.

x points right, y up; rotation is positive counterclockwise. No formula here needs more than + - *.
"""

from __future__ import annotations

from typing import Any

from planar_cli.records import record


@record
class Vec:
    """A vector (x, y); its elements are whatever numbers the caller works with."""

    x: Any
    y: Any

    def __add__(self, other: Vec) -> Vec:
        return Vec(self.x + other.x, self.y + other.y)

    def __sub__(self, other: Vec) -> Vec:
        return Vec(self.x - other.x, self.y - other.y)

    def __neg__(self) -> Vec:
        return Vec(-self.x, -self.y)

    def __mul__(self, factor: Any) -> Vec:
        return Vec(self.x * factor, self.y * factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: Any) -> Vec:
        return Vec(self.x / divisor, self.y / divisor)

    def dot(self, other: Vec) -> Any:
        return self.x * other.x + self.y * other.y

    def cross(self, other: Vec) -> Any:
        """The z component of self × other, positive counterclockwise."""
        return self.x * other.y - self.y * other.x

    def turned(self) -> Vec:
        """k × self: the vector turned by 90° counterclockwise."""
        return Vec(-self.y, self.x)
