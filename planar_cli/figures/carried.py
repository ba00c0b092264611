"""Marks that go with something from one place to another, and turn with it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from planar_cli.figures.shapes import moved
from planar_cli.records import record
from planar_cli.report.document.marks import Arc, Mark, Polyline, Slot, Spot, Symbol


@record
class Pose:
    """A place and an angle, as of a body."""

    at: Spot
    turn: float

    def seen(self, spot: Spot) -> Spot:
        """A place in axes that go with it."""
        return moved((0.0, 0.0), -self.turn, spot[0] - self.at[0], spot[1] - self.at[1])

    def there(self, seen: Spot) -> Spot:
        """The place that is seen so from it."""
        return moved(self.at, self.turn, *seen)


def carried(marks: Iterable[Mark], before: Pose, after: Pose) -> list[Mark]:
    """Marks that go with something from one pose to another."""
    turn = after.turn - before.turn

    def to(spot: Spot) -> Spot:
        return after.there(before.seen(spot))

    found: list[Mark] = []
    for mark in marks:
        match mark:
            case Polyline(places=places):
                found.append(replace(mark, places=tuple(map(to, places))))
            case Arc(center=center, start=start):
                found.append(replace(mark, center=to(center), start=start + turn))
            case Slot(start=start, end=end, angle=angle):
                found.append(replace(mark, start=to(start), end=to(end), angle=angle + turn))
            case Symbol(at=at, angle=angle):
                found.append(replace(mark, at=to(at), angle=angle + turn))
            case _:
                found.append(mark)
    return found


def shifted(mark: Mark, by: Spot) -> Mark:
    """A mark somewhere else."""
    (found,) = carried((mark,), Pose((0.0, 0.0), 0.0), Pose(by, 0.0))
    return found
