"""Free-body diagram = kinetic diagram: each list of forces of a page as a pair of drawings, in the position in which
the page tells their ways.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from typing import TypeGuard

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.angles_in_diagrams import with_angles
from planar_cli.figures.broken import NOT_TO_SCALE, broken_together
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.found_ways import given_turned, note_of
from planar_cli.figures.lanes import in_lanes
from planar_cli.figures.moment_centres import with_centres
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.pulling import Pulling
from planar_cli.figures.rings import across, ends_of, extent_of, inside, meets, middle_of, off, sides, way_of
from planar_cli.figures.ropes import ropes_within
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.sketches import Slide
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Forces, Inline, Line, Math, Name, Text, Way, line
from planar_cli.report.document.marks import (
    Arrow,
    Dimension,
    Figure,
    Mark,
    Panel,
    Polyline,
    Spot,
    Style,
    Symbol,
    Tag,
    Turn,
)
from planar_cli.report.kinetics.entries import ASSUMED
from planar_cli.report.kinetics.open_lines import NOT_NEEDED
from planar_cli.report.momentum.impulse_rows import IMPULSES
from planar_cli.solve.solved_problem import Solution

AND = " + "
"""Between what stands over one side of the diagrams of a blow, which are drawn by themselves."""
BREAK = ",  "
"""Between two vectors of a list."""
ARROWS = "→↗↑↖←↙↓↘"
"""In the order in which they turn, an eighth of a turn from one to the next."""
_AT = re.compile(r" at (?!the )([^ ,()]+)")
DEEP = 0.15
"""A force that acts beside its body is drawn within its edge by this part of its width."""
LEVEL = 1e-6
"""What rises by no more than this part of its length is level."""
FLAT = 0.25
"""So near to its edge is the middle of a thin body, in parts of its size."""
TENSION = "tension"
PRESSING, PULLING = ("normal", "friction"), ("force", TENSION)
"""Kinds of forces at the edge on which a body stands, and of those at a side of it."""
INWARD = 0.35
"""The cosine of the angle to the way to the mass centre from which on a force at the edge is drawn as a push."""


@record
class _Vector:
    """One entry of a list: its size, where it is and which way."""

    words: Line
    told: str
    way: Way
    where: Line = ()
    """What stands behind it: at x to the right of C."""


@record
class _Inside:
    """A body that has only sides, and what is taken as its mass centre."""

    middle: Spot
    ring: tuple[Spot, ...]
    foot: Spot
    """Where it stands."""


@record
class _Side:
    """What is drawn together. `sign`: between it and what stands before it."""

    vectors: list[_Vector]
    style: Style
    head: str
    sign: str


def diagram(row: Forces, below: Sequence[Block], solution: Solution) -> Figure | None:
    """A list of forces as drawings; None: nothing of it can be drawn. `below`: what stands behind it on the page."""
    left, right = list(_vectors(row.left)), list(_vectors(row.right))
    if row.scene is None or not left:
        return None
    drawn = Drawn(row.scene, left[0].way.value, {})
    # In equilibrium there is nothing on the other side; before a blow there is no momentum of what is at rest.
    sides = [s for s in _sides(row, left, right) if s.vectors]
    panels = [_panel(drawn, row, s, solution) for s in sides]
    signs = "".join(s.sign for s in sides[1:])
    told = note_of(panels, row, solution)
    centred, cut = broken_together(with_angles(drawn, row, below, with_centres(drawn, row, below, panels)))
    parts = [part for part in (line(row.posed) if row.posed else (), told, line(NOT_TO_SCALE) if cut else ()) if part]
    note = line(*[piece for part in parts for piece in ("; ", *part)][1:])
    return Figure(centred, f"{row.heads[0]} of {row.body}", signs, note=note)


def _sides(row: Forces, left: list[_Vector], right: list[_Vector]) -> Iterator[_Side]:
    """Free-body diagram = kinetic diagram, or of a blow momentum before + impulses = momentum after."""
    before, plus, impulses = row.heads[0].partition(AND)
    if not plus:
        momenta = row.heads == IMPULSES
        yield _Side(left, "force", row.heads[0], "")
        yield _Side(right, "velocity" if momenta else "inertia", row.heads[1], "=")
        return
    yield _Side([v for v in left if v.way.before], "velocity", before, "")
    yield _Side([v for v in left if not v.way.before], "force", impulses, AND.strip())
    yield _Side(right, "velocity", row.heads[1], "=")


def _vectors(listed: Line) -> Iterator[_Vector]:
    """The entries of a list that have a way. Where a force acts may stand behind it: N ↑ at x to the right of C."""
    for apart, pieces in groupby(listed, key=lambda p: isinstance(p, Text) and p.text == BREAK):
        entry: list[Inline] = [] if apart else list(pieces)
        for i, piece in enumerate(entry):
            if isinstance(piece, Text) and piece.way is not None:
                yield _Vector(tuple(entry[:i]), piece.text, piece.way, tuple(entry[i + 1 :]))


def _panel(drawn: Drawn, row: Forces, side: _Side, solution: Solution) -> Panel:
    bodies = [drawn.scene.bodies[name] for name in row.body.split(", ")]
    marks: list[Mark] = [slim(m) for b in bodies for m in body_marks(drawn, b)]
    marks += ropes_within(drawn, frozenset(b.name for b in bodies))
    centers = [(spot, b.rigid) for b in bodies if (spot := drawn.spot(b.center)) is not None]
    pulling = Pulling.of(drawn, bodies, list(_pulls(drawn, row)))
    marks = [*pulling.wheels(), *marks]
    marks += [Symbol("centre", spot) for spot, rigid in centers if rigid]
    insides = dict(_insides(drawn, bodies))
    marks += [Symbol("centre", own.middle) for own in insides.values()]
    centers += [(own.middle, False) for own in insides.values()]
    tags: dict[str, Spot] = {}
    areas = [m.places for m in marks if _is_area(m)]
    for vector in side.vectors:
        at = _spot(drawn, vector.way, vector.way.place)
        if at is None:
            continue
        if (named := _AT.search(vector.told)) is not None:
            tags[named[1]] = at
        center = min((c for c, _ in centers), key=lambda c: math.dist(c, at), default=None)
        made = list(_mark(drawn, vector, at, center, side.style))
        if at in insides:
            middle = insides[at].middle
            made = [_put(m, insides[at], vector.way.kind) for m in _mark(drawn, vector, at, middle, side.style)]
        elif led := _led(drawn, vector, row, at):
            made = [_on_edge(m, [r.places for r in body_marks(drawn, led) if _is_area(r)]) for m in made]
        elif at == center and vector.way.kind == "normal":
            made = [_touched(m, areas) for m in made]
        elif named is None and at != center:
            near = NOT_NEEDED in vector.told
            made = [_on_edge(_within(m, areas) if near else m, areas) for m in made]
        if vector.way.kind == TENSION and at not in insides:
            made = [pulling.placed(m, at) for m in made]
        tags |= {
            p.name: spot for p in vector.where if isinstance(p, Name) and (spot := drawn.named(p.name)) is not None
        }
        turned = [given_turned(m, row, solution) for m in made]
        marks += (*turned, *_distance(vector, made, tags))
    marks += [Symbol("point", at) for at in tags.values() if at not in (c for c, _ in centers)]
    marks += [Tag(at, line(Name(name))) for name, at in tags.items()]
    return Panel(tuple(in_lanes(marks)), line(side.head), pulling.least)


def _pulls(drawn: Drawn, row: Forces) -> Iterator[Spot]:
    """Where a list has tensions."""
    ways = (v.way for v in _vectors(row.left) if v.way.kind == TENSION)
    yield from (s for way in ways if (s := _spot(drawn, way, way.place)) is not None)


def _insides(drawn: Drawn, bodies: Sequence[BodyModel]) -> Iterator[tuple[Spot, _Inside]]:
    """Of bodies that the file has as points at an edge of what is drawn of them, by these points."""
    for body in bodies:
        at = drawn.spot(body.center)
        rings = [m.places for m in body_marks(drawn, body) if isinstance(m, Polyline) and m.closed]
        if body.rigid or at is None or len(rings) != 1 or inside(rings[0], at, DEEP * extent_of(rings[0])):
            continue
        ring, middle = rings[0], middle_of(rings[0])
        a, b = min(sides(ring), key=lambda ends: off(ends[0], way_of(*ends), at))
        # In a thin body the weight would run into what presses from below.
        aside = DEEP * math.dist(a, b) if math.dist(at, middle) < FLAT * extent_of(ring) else 0.0
        yield at, _Inside(middle, ring, moved(at, way_of(a, b), -aside))


def _put(mark: Mark, body: _Inside, kind: str) -> Mark:
    """What acts on a body that has only sides: a contact at its edge, what pulls at the side to which it pulls, all
    else in its middle.
    """
    if not isinstance(mark, Arrow):
        return mark
    if kind in PRESSING:
        return replace(mark, at=body.foot)
    ahead = meets(body.ring, body.middle, mark.angle) if kind in PULLING else []
    return replace(mark, at=moved(body.middle, mark.angle, max(ahead, default=0.0)), inward=False)


def _mark(drawn: Drawn, vector: _Vector, at: Spot, center: Spot | None, style: Style) -> Iterator[Mark]:
    if vector.way.direction is None:
        yield Turn(at, -1 if "↻" in vector.told else 1, style, vector.words)
        return
    way = _spot(drawn, vector.way, vector.way.direction)
    glyph = next((c for c in vector.told if c in ARROWS), "")
    if way is None or not any(way):
        # A spring at its own length in the position that is drawn: as the page tells it.
        if not glyph:
            return
        way = _told_way(glyph)
    if glyph and sum(a * b for a, b in zip(way, _told_way(glyph), strict=True)) < 0:
        way = (-way[0], -way[1])
    angle = math.atan2(way[1], way[0])
    inward = _is_push(way, at, center)
    yield Arrow(at, angle, style, vector.words, 1.0, inward, ASSUMED in vector.told)


def _told_way(glyph: str) -> Spot:
    turned = ARROWS.index(glyph) * math.pi / 4
    return round(math.cos(turned), 9), round(math.sin(turned), 9)


def _distance(vector: _Vector, made: Sequence[Mark], tags: Mapping[str, Spot]) -> Iterator[Mark]:
    """How far from a point a force acts, where its list tells that by a letter."""
    letters = [p for p in vector.where if isinstance(p, Math)]
    starts = [tags[p.name] for p in vector.where if isinstance(p, Name) and p.name in tags]
    for start, letter, arrow in zip(starts, letters, made, strict=False):
        if isinstance(arrow, Arrow) and math.dist(start, arrow.at) > 0:
            level = abs(arrow.at[1] - start[1]) < LEVEL * math.dist(start, arrow.at)
            # On the side from which the force comes, as that of a floor.
            left = math.sin(arrow.angle - math.atan2(arrow.at[1] - start[1], arrow.at[0] - start[0])) > 0
            yield Dimension(start, arrow.at, (letter,), -1 if left else 1, level)


def slim(mark: Mark) -> Mark:
    """A bar that leaves an arrow or a line along it to be seen."""
    bar = isinstance(mark, Polyline) and not mark.closed and mark.style == "body"
    return replace(mark, style="slim") if isinstance(mark, Polyline) and bar else mark


def _on_edge(mark: Mark, areas: Sequence[Sequence[Spot]]) -> Mark:
    """A force at no named place, such as that of a floor, brought along its line to the edge on which it presses."""
    if not isinstance(mark, Arrow):
        return mark
    # Where its line goes into an area, and not where it leaves it.
    found = [far for ring in areas for far in meets(ring, mark.at, mark.angle)[::2]]
    behind = [far for far in found if far < 1e-9]
    if not found:
        return mark
    far = max(behind) if behind else min(found)
    return replace(mark, at=moved(mark.at, mark.angle, far), inward=True)


def _led(drawn: Drawn, vector: _Vector, row: Forces, at: Spot) -> BodyModel | None:
    """The body of a list that slides as a whole in a guide which presses on it with a force: that is at its edge."""
    if vector.way.kind != "normal" or vector.way.direction is None:
        return None
    way, bodies = _spot(drawn, vector.way, vector.way.direction), row.body.split(", ")
    slides = (s for j in drawn.scene.problem.joints for s in sketch_of(drawn, j) if isinstance(s, Slide))
    for slide in (s for s in slides if s.grounded and s.body in bodies):
        along, place = drawn.angle(slide.along), drawn.spot(slide.at)
        if way is not None and along is not None and place is not None and math.dist(place, at) < LEVEL:
            upright = abs(way[0] * math.cos(along) + way[1] * math.sin(along)) < LEVEL * math.hypot(*way)
            return drawn.scene.bodies[slide.body] if upright and slide.body is not None else None
    return None


def _is_area(mark: Mark) -> TypeGuard[Polyline]:
    return isinstance(mark, Polyline) and mark.closed


def _touched(mark: Mark, areas: Sequence[Sequence[Spot]]) -> Mark:
    """A force from outside, where it acts on an edge: a body may have no other place than that, and no mass centre."""
    there = _on_edge(mark, areas)
    near = isinstance(mark, Arrow) and isinstance(there, Arrow) and math.dist(there.at, mark.at) < LEVEL
    return there if near else mark


def _within(mark: Mark, areas: Sequence[Sequence[Spot]]) -> Mark:
    """A force of which only the direction counts, and which acts beside its body, on the body."""
    if not isinstance(mark, Arrow) or not areas or any(meets(ring, mark.at, mark.angle) for ring in areas):
        return mark
    far = [across(mark.at, mark.angle, corner) for ring in areas for corner in ring]
    low, high = ends_of(far)
    aside = low + DEEP * (high - low) if low > 0 else high - DEEP * (high - low)
    return replace(mark, at=moved(mark.at, mark.angle, 0.0, aside))


def _spot(drawn: Drawn, way: Way, place: Vec) -> Spot | None:
    return Drawn(drawn.scene, way.value, {}).spot(place)


def _is_push(way: Spot, at: Spot, center: Spot | None) -> bool:
    """Does it press on the edge, towards the mass centre?"""
    if center is None or math.dist(at, center) < 1e-9:
        return False
    inside = (center[0] - at[0], center[1] - at[1])
    cosine = (way[0] * inside[0] + way[1] * inside[1]) / (math.hypot(*way) * math.hypot(*inside))
    return cosine > INWARD
