"""What a joint says of places alone: residuals that vanish as long as the joint holds, written from geometry.

The independent check of a solution assembles a scene from these and differentiates them itself; nothing here knows of
velocities or accelerations. A residual is a function of the poses of the bodies near the drawn configuration.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from planar_cli.problem.scene.facts import Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record


class Poses(Protocol):
    """The poses of all bodies a moment before or after the drawn one; its numbers know + - * / among themselves.

    Arguments called `drawn` are exact expressions of the scene; results vary with the poses. `time` is counted from the
    drawn instant [s].
    """

    @property
    def time(self) -> Any: ...

    def number(self, drawn: Any) -> Any:
        """A constant."""

    def vector(self, drawn: Vec) -> Vec:
        """A constant vector."""

    def point(self, body: str, drawn: Vec) -> Vec:
        """Where the body's material point is that was drawn there."""

    def direction(self, body: str, drawn: Vec) -> Vec:
        """A direction that turns with the body."""

    def angle(self, body: str) -> Any:
        """The angle by which the body has turned, counterclockwise; 0 for the ground and for particles."""

    def length(self, v: Vec) -> Any:
        """|v|, which is not zero as drawn."""

    def root(self, square: Any) -> Any:
        """The square root of a number, or of what is positive as drawn."""

    def turned(self, v: Vec) -> Any:
        """The angle by which a direction has turned since it was drawn, counterclockwise."""

    def positive(self, number: Any) -> bool:
        """Is a number, as drawn, not negative?"""

    def change(self, number: Any) -> Any:
        """A number less its value as drawn."""

    def off_curve(self, curve: Outline, other: Outline, place: Vec) -> Any:
        """How far an outline that was drawn touching a curve at a place has come off it: a corner, or a rim."""

    def foot(self, curve: Outline, rim: Outline, place: Vec) -> tuple[Any, Any]:
        """The arc from the place, where a rim was drawn on a curve, to the foot of its centre; the angle by which the
        tangent there has turned from the drawn one.
        """

    def along_curve(self, curve: Outline, body: str, place: Vec) -> Vec:
        """A vector that keeps its angle with the curve where the body's point is that was drawn there."""


@record
class Residual:
    """`of` gives a number that stays zero, or a Vec of which both parts do; `title` says what it keeps. `anywhere`: it
    vanishes wherever the joint begins to hold, not only from where things are drawn. `turns`: it is an angle, others
    are lengths.
    """

    title: str
    of: Callable[[Poses], Any]
    anywhere: bool = False
    turns: bool = False
