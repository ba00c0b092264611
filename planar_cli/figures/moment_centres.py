"""The points about which a page takes moments, in the diagrams of the bodies of which it takes them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import takewhile

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.rings import ends_of, extent_of, way_of
from planar_cli.figures.shapes import moved
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Forces, Heading, Name, Paragraph, Text, Way, line
from planar_cli.report.document.marks import Arrow, Mark, Panel, Polyline, Spot, Symbol, Tag, spots_of
from planar_cli.report.words.pointing import told_centres

ON = 1e-6
"""What passes a place at this part of the distance to it passes through it."""
NEAR = 1.0
"""A point on no line of action is drawn where it is not farther from what is drawn than this part of its size."""
FAR, STUB = 0.9, 0.4
"""Of lines of action that meet farther away only the beginnings are drawn, so long in the same parts."""
_TOTAL = re.compile(r"the total reaction at (\w+)")


@record
class MomentCentre:
    """A point about which moments are taken, by its letter. `through`: the places of total reactions whose lines meet
    there.
    """

    name: str
    way: Way
    through: tuple[str, ...]


def with_centres(drawn: Drawn, row: Forces, below: Sequence[Block], panels: Sequence[Panel]) -> list[Panel]:
    """The diagrams of a body with the points about which moments are taken in its step, and the lines of action that
    meet in those that are not points of the file. `below`: what stands behind the list of forces.
    """
    made = list(panels)
    for centre in _centres(row, below):
        # What is drawn in a position of its own has its centre there too.
        at = (drawn if row.posed else Drawn(drawn.scene, centre.way.value, {})).spot(centre.way.place)
        if at is None:
            continue
        own = centre.name not in drawn.scene.points
        lines = [list(_lines(panel, centre, at)) if own else [] for panel in panels]
        beyond = max(_beyond(panel, at) for panel in panels)
        if any(lines) and beyond > FAR:
            made = [
                replace(p, marks=(*p.marks, *_towards(p, centre.name, met))) for p, met in zip(made, lines, strict=True)
            ]
        elif any(lines) or beyond <= NEAR:
            made = [_with_point(p, centre.name, at, met) for p, met in zip(made, lines, strict=True)]
    return made


def _centres(row: Forces, below: Sequence[Block]) -> list[MomentCentre]:
    step = list(takewhile(lambda b: not isinstance(b, Heading), below))
    found = [c for b in step if isinstance(b, Paragraph) for c in _told(b)]
    own, groups = _bodies(row), [_bodies(b) for b in step if isinstance(b, Forces)]
    # Moments of a group are read off its own diagram, where it has one.
    return list({c.name: c for c in found if own <= set(c.way.bodies) not in groups}.values())


def _bodies(row: Forces) -> set[str]:
    return set(row.body.split(", "))


def _told(block: Paragraph) -> Iterator[MomentCentre]:
    totals = tuple(_TOTAL.findall("".join(p.text for p in block.line if isinstance(p, Text))))
    yield from (MomentCentre(name, way, totals) for name, way in told_centres([block]))


def _lines(panel: Panel, centre: MomentCentre, at: Spot) -> Iterator[Polyline]:
    """The lines of action, from where forces act to the point in which they meet."""
    passing = [m.at for m in panel.marks if isinstance(m, Arrow) and _passes(m, at)]
    named = {line(Name(name)) for name in centre.through}
    passing += [m.at for m in panel.marks if isinstance(m, Tag) and m.words in named]
    yield from (Polyline((spot, at), "way") for spot in dict.fromkeys(passing) if math.dist(spot, at) > 0)


def _with_point(panel: Panel, name: str, at: Spot, lines: Sequence[Mark]) -> Panel:
    tag = Tag(at, line(Name(name)))
    point = () if tag.words in {m.words for m in panel.marks if isinstance(m, Tag)} else (Symbol("point", at), tag)
    return replace(panel, marks=(*panel.marks, *lines, *point))


def _passes(arrow: Arrow, at: Spot) -> bool:
    """Does the line of a force, which acts somewhere else, pass through a place?"""
    far = math.dist(arrow.at, at)
    ends = (moved(arrow.at, arrow.angle, side * far) for side in (-1, 1))
    return far > ON and any(math.dist(end, at) < ON * far for end in ends)


def _towards(panel: Panel, name: str, lines: Sequence[Polyline]) -> Iterator[Mark]:
    """The beginnings of lines that meet far away, each with where it goes: what is drawn would be small beside all."""
    reach = STUB * extent_of([s for m in panel.marks for s in spots_of(m)])
    # Of those that lie in one line the one that comes nearest.
    last = {round(way_of(*m.places), 6): m.places for m in sorted(lines, key=lambda m: -math.dist(*m.places))}
    for start, end in last.values():
        tip = moved(start, way_of(start, end), min(reach, math.dist(start, end)))
        yield Polyline((start, tip), "way")
        yield Tag(tip, line("to ", Name(name)))


def _beyond(panel: Panel, at: Spot) -> float:
    """How far a place is outside what is drawn, in parts of its size."""
    spots = [s for m in panel.marks for s in spots_of(m)]
    (left, right), (low, high) = ends_of(x for x, _ in spots), ends_of(y for _, y in spots)
    return max(left - at[0], at[0] - right, low - at[1], at[1] - high) / (extent_of(spots) or 1.0)
