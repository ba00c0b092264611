"""What a figure is made of, without saying how it is drawn on paper.

Places are in metres, x to the right, y upward; angles in radians, counterclockwise from the x axis. What has a size on
paper alone (arrows, supports, hatching) gets it from whoever draws. Words of a mark are a `Line` of neutral pieces, so
that each format sets them as it sets the page.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from planar_cli.records import record
from planar_cli.report.document.graphs import Graph
from planar_cli.report.document.lines import Line

Spot = tuple[float, float]
"""A place, m."""
Style = Literal[
    "body",
    "slim",
    "thin",
    "hidden",
    "dashed",
    "ground",
    "rope",
    "way",
    "force",
    "inertia",
    "velocity",
    "acceleration",
    "axis",
    "chain",
    "lane",
]
"""What a line stands for; each has its own look. A lane is a way between two edges, seen from above."""
SymbolKind = Literal[
    "pin",
    "support",
    "edge",
    "particle",
    "block",
    "centre",
    "point",
    "slider",
    "rail",
    "weld",
    "wall",
    "place",
    "origin",
    "plate",
    "hanger",
    "break",
    "ring",
    "later",
    "guides",
]


@record
class Polyline:
    """Straight strokes from place to place; `closed`: back to the first one, with the area of a body."""

    places: tuple[Spot, ...]
    style: Style
    closed: bool = False


@record
class Arc:
    """Part of a circle, from the angle `start` on through `sweep` (2π: all of it, with the area of a body, unless it
    is `hollow`, as a hoop).
    """

    center: Spot
    radius: float
    style: Style
    start: float = 0.0
    sweep: float = 6.283185307179586
    hollow: bool = False


@record
class Hatched:
    """A fixed edge, through these places; its hatching lies to the right of the way along it. `aside`: on paper it lies
    so far to the left of its way, px.
    """

    places: tuple[Spot, ...]
    aside: float = 0.0


@record
class Coil:
    """A helical spring between two places; `like`: with as many turns as one of this length has, m (0: its own).
    `words`: its stiffness. `aside`, `lane`, `cuts`, `later`: as of a damper.
    """

    start: Spot
    end: Spot
    like: float = 0.0
    aside: float = 0.0
    lane: float = 0.0
    cuts: tuple[float, float] = (0.0, 0.0)
    words: Line = ()
    later: bool = False


@record
class Dashpot:
    """A viscous damper between two places; `words`: its force per speed. On paper, px: `aside`: it lies so far to the
    left of the way from one to the other; `lane`: so far beside another one, held with it at both ends; `cuts`: so much
    shorter it is at each end. `later`: it is so in a later state, dashed.
    """

    start: Spot
    end: Spot
    aside: float = 0.0
    lane: float = 0.0
    cuts: tuple[float, float] = (0.0, 0.0)
    words: Line = ()
    later: bool = False


@record
class Slot:
    """A slot from `start` along the direction `angle` to `end`, as wide as a sign, closed by half circles. `fixed`: in
    the ground, with hatching beside it, and longer by that much that a slider at its end has room.
    """

    start: Spot
    end: Spot
    angle: float
    fixed: bool


@record
class Symbol:
    """A sign of fixed size at a place: a pin, a fixed support below one as seen along `angle`, a particle, a block that
    stands on what lies along `angle`, a mass centre, a slider that lies along `angle`, the same on a fixed rail, a
    weld, a piece of wall behind the end of something that goes on along `angle`, what holds a wheel from there, the
    plate at the end of a spring that goes on along `angle`, where coordinates are measured from, the place where a
    particle is later, a break in what is too long to be drawn, along `angle`, a point on a bar, where a block is later,
    fixed walls on both sides of a block that slides along `angle`.
    """

    kind: SymbolKind
    at: Spot
    angle: float = 0.0
    aside: float = 0.0
    """So far to the left of the place, as seen along `angle`, it is on paper, px."""
    lean: float = 0.0
    """By so much the sides of a block are turned from upright on what it stands on."""


@record
class Arrow:
    """A vector at a place, in the direction `angle`. `reach`: its length in parts of the usual one. `inward`: its tip
    is at the place, as that of what pushes. `assumed`: its direction may be the opposite one. `aside`: on paper it lies
    so far to the left of its way, px.
    """

    at: Spot
    angle: float
    style: Style
    words: Line = ()
    reach: float = 1.0
    inward: bool = False
    assumed: bool = False
    aside: float = 0.0


@record
class Span:
    """An arrow from one place to another, to the scale of the figure, as in a polygon of velocities. `aside`: on paper
    it lies so far to the left of its way, px.
    """

    start: Spot
    end: Spot
    style: Style
    words: Line = ()
    aside: float = 0.0


@record
class Turn:
    """A couple, or a rotation, about a place: +1 counterclockwise, -1 clockwise. `radius`: of its arrow on paper, px
    (0: what is usual).
    """

    at: Spot
    sense: int
    style: Style
    words: Line = ()
    radius: float = 0.0


@record
class Dimension:
    """A distance between two places, drawn beside them on the left of the way from one to the other (`side` 1), on the
    right (-1), or from the first to the second (0, a radius). `level`: it is along an axis, and drawn beside all else.
    `row`: so many others lie between it and its way; `broken`: it is longer than it is drawn.
    """

    start: Spot
    end: Spot
    words: Line
    side: int = 1
    level: bool = False
    row: int = 0
    broken: bool = False


@record
class Angle:
    """An angle at a vertex, from the direction `start` through `sweep`. On paper, px: `radius`: of its arc (0: what is
    usual); `shift`: it is so far to the right and up of its vertex.
    """

    vertex: Spot
    start: float
    sweep: float
    words: Line
    radius: float = 0.0
    shift: Spot = (0.0, 0.0)


@record
class Tag:
    """The name of a place."""

    at: Spot
    words: Line


@record
class Axes:
    """The directions x and y, beside everything, and that of the weight where there is one."""

    heavy: bool


Mark = (
    Graph
    | Axes
    | Polyline
    | Arc
    | Hatched
    | Coil
    | Dashpot
    | Slot
    | Symbol
    | Arrow
    | Span
    | Turn
    | Dimension
    | Angle
    | Tag
)


@record
class Panel:
    """One drawing, and what stands over it. `least`: it is at least so wide, m."""

    marks: tuple[Mark, ...]
    head: Line = ()
    least: float = 0.0


@record
class Figure:
    """Panels side by side, in one scale; `between`: the signs between them, a letter each (an = of two diagrams that
    are equal).

    `words`: what it shows, for who cannot see it; `name`: for its own file; `note`: what stands under it.
    """

    panels: tuple[Panel, ...]
    words: str
    between: str = ""
    name: str = "figure"
    note: Line = ()


def spots_of(mark: Mark) -> Iterator[Spot]:
    """The places, to scale, between which a mark lies."""
    match mark:
        case Polyline(places=places) | Hatched(places=places):
            yield from places
        case Arc(center=(x, y), radius=r):
            yield from ((x - r, y - r), (x + r, y + r))
        case (
            Coil(start=a, end=b)
            | Dashpot(start=a, end=b)
            | Slot(start=a, end=b)
            | Span(start=a, end=b)
            | Dimension(start=a, end=b)
        ):
            yield from (a, b)
        case Symbol(at=at) | Arrow(at=at) | Turn(at=at) | Tag(at=at) | Angle(vertex=at):
            yield at
