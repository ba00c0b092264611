"""The scene at the top of a page, and in each case in which it looks different: a cord that is cut, another height."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.figures.arrangement import arrangement, followed_arrangement
from planar_cli.figures.asked_curves import whole_paths
from planar_cli.figures.broken import scene
from planar_cli.figures.rings import extent_of
from planar_cli.report.document.marks import (
    Arc,
    Axes,
    Coil,
    Dashpot,
    Figure,
    Hatched,
    Mark,
    Panel,
    Polyline,
    Symbol,
    spots_of,
)
from planar_cli.solve.solved_problem import PartSolution, Solution

SEEN = 0.03
"""What differs by less, in parts of the size of the scene, looks the same."""
LINES = (Arc, Coil, Dashpot, Hatched, Polyline)
Look = list[tuple[str, tuple[float, ...]]]


class Scenes:
    """Those of a page. `first`: where the first part is worked out at an instant, or else in numbers; None: none is, or
    the file does not draw it.
    """

    def __init__(self, solution: Solution) -> None:
        self.title = solution.problem.title
        self.parts = {part.case.replace("_", " "): part for part in solution.parts}
        found = ((part.case, panel) for part in solution.parts if (panel := _panel(part)) is not None)
        self.case, panel = next(found, ("", None))
        self.drawn = [panel] if panel is not None else []
        self.first = scene(panel, self.title) if panel is not None else None

    def of_case(self, name: str) -> Iterator[Figure]:
        """That of a case, where no scene above looks like it."""
        part = self.parts.get(name)
        panel = _panel(part) if part is not None and part.case != self.case and self.drawn else None
        # Nothing but a point somewhere else is no other scene.
        lines = panel is not None and any(isinstance(m, LINES) for m in panel.marks)
        if panel is not None and lines and not any(_alike(panel, other) for other in self.drawn):
            self.drawn.append(panel)
            yield scene(panel, f"{self.title}: {name}")


def _panel(part: PartSolution) -> Panel | None:
    if part.instants:
        panel: Panel | None = arrangement(part, whole_paths(part))
    else:
        panel = followed_arrangement(part.followed.run) if part.followed is not None else None
    return None if panel is None or all(isinstance(m, Axes) for m in panel.marks) else panel


def _alike(one: Panel, other: Panel) -> bool:
    """Do two scenes show the same bodies, joints and places, whatever the words say?"""
    size = max(extent_of([s for m in p.marks for s in spots_of(m)]) for p in (one, other))
    left = _look(other.marks)
    for kind, numbers in _look(one.marks):
        found = next((x for x in left if x[0] == kind and _near(x[1], numbers, SEEN * size)), None)
        if found is None:
            return False
        left.remove(found)
    return not left


def _near(one: tuple[float, ...], other: tuple[float, ...], near: float) -> bool:
    return len(one) == len(other) and all(math.fabs(a - b) <= near for a, b in zip(one, other, strict=True))


def _look(marks: tuple[Mark, ...]) -> Look:
    """What is seen of lines and signs: their kinds, and their places."""
    seen = [m for m in marks if isinstance(m, (*LINES, Symbol))]
    return [(_kind(m), tuple(number for spot in spots_of(m) for number in spot)) for m in seen]


def _kind(mark: Mark) -> str:
    match mark:
        case Symbol(kind=kind):
            return kind
        case Arc(style=style) | Polyline(style=style):
            return f"{type(mark).__name__} {style}"
        case _:
            return type(mark).__name__
