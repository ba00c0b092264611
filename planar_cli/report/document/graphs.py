"""The mark of a graph: curves over an axis. It has its size on paper, and what it measures on its axes alone."""

from __future__ import annotations

from planar_cli.records import record
from planar_cli.report.document.lines import Line

Spot = tuple[float, float]


@record
class Scaled:
    """What is measured along an axis, in `unit` ("" for a pure number), and from where to where at least. `powers`:
    these numbers, and those of the curves, are exponents of ten. `letters`: where numbers rest on letters, what
    stands at some places instead of them.
    """

    words: Line
    unit: str
    low: float
    high: float
    powers: bool = False
    letters: tuple[tuple[float, Line], ...] = ()


@record
class Curve:
    """One curve, in pieces between which it jumps; `words`: its name where there are several; `faint`: of another
    motion, dashed; `total`: the sum of the others; `marked`: its places are measured, and seen.
    """

    pieces: tuple[tuple[Spot, ...], ...]
    words: Line = ()
    faint: bool = False
    total: bool = False
    marked: bool = False


@record
class Dot:
    """Something that happens at a place of a curve, with its name."""

    at: Spot
    words: Line


@record
class Graph:
    """Curves over an axis. `row`: of several graphs, how many stand above it; `equal`: both axes have one scale, as
    ways of points have; `size`: width and height of the field in pixels.
    """

    across: Scaled
    up: Scaled
    curves: tuple[Curve, ...]
    dots: tuple[Dot, ...] = ()
    row: int = 0
    equal: bool = False
    size: tuple[float, float] = (380.0, 190.0)
