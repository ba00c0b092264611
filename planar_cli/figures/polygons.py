"""Polygons of velocities and of accelerations: the vector equations of a page, tip to tail from one pole.

v_B = v_A + ω × r_B/A: from the pole o to the tip of v_A, from there across AB to that of v_B. With a moving frame
v_P = v_P′ + v_rel; of accelerations the relative part in two, -ω² r and α × r, and behind a_P′ the Coriolis part.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from planar_cli.equation.motion import Motion
from planar_cli.figures.drawn import Drawn
from planar_cli.problem.geometry import Vec
from planar_cli.records import record
from planar_cli.report.blocks import Block, Equation, Inline, Line, Math, Name, line
from planar_cli.report.marks import Figure, Mark, Panel, Span, Spot, Style, Symbol, Tag
from planar_cli.solve.solution import InstantSolution

_VECTOR = re.compile(r"(?P<letter>[va])_(?P<point>[A-Z]\w*?)(?P<prime>′?)(?:_vec)?")
_ARM = re.compile(r"r_(?P<end>[A-Z][\w,]*)/(?P<start>[A-Z][\w,]*)(?:_vec)?")
STYLES: dict[str, Style] = {"v": "velocity", "a": "acceleration"}
POLE: Spot = (0.0, 0.0)
SMALL = 0.02
"""A vector that is smaller than this part of the largest one is not drawn."""


@record
class _Sum:
    """One vector equation: its left side by name, the vector that it begins with (""), and the body that turns."""

    name: str
    letter: str
    point: str
    base: str
    start: str
    body: str


def polygons(blocks: Sequence[Block], instant: InstantSolution) -> list[Figure]:
    """The polygons of the vector equations among some blocks, of velocities and of accelerations."""
    motion = instant.trial.system.motion
    if motion is None:
        return []
    told = (s for b in blocks if isinstance(b, Equation) and (s := _sum(b, motion, instant)) is not None)
    sums = list(dict.fromkeys(told))
    drawn = Drawn(instant.instant.scene, instant.value, {})
    made = (_polygon([s for s in sums if s.letter == letter], drawn, motion) for letter in STYLES)
    return [figure for figure in made if figure is not None]


def _names(side: Inline | Line) -> list[str]:
    return [p.name for p in (side if isinstance(side, tuple) else (side,)) if isinstance(p, Name)]


def _sum(block: Equation, motion: Motion, instant: InstantSolution) -> _Sum | None:
    """A vector equation with an arm; None: it is something else."""
    left = _names(block.sides[0])
    if len(block.sides) < 2 or len(left) != 1 or (vector := _VECTOR.fullmatch(left[0])) is None:
        return None
    right = block.sides[1]
    arms = [m for name in _names(right) if (m := _ARM.fullmatch(name)) is not None]
    begun = [name for name in _names(right) if _VECTOR.fullmatch(name)]
    rates = {s for p in (right if isinstance(right, tuple) else ()) if isinstance(p, Math) for s in p.expr.free_symbols}
    turns = {b: {motion.velocities[b].angular, motion.accelerations[b].angular} for b in instant.instant.scene.bodies}
    turning = [b for b, own in turns.items() if own & rates]
    if not arms or len(turning) != 1 or len(begun) > 1:
        return None
    return _Sum(left[0], vector["letter"], arms[0]["end"], begun[0] if begun else "", arms[0]["start"], turning[0])


def _polygon(sums: Sequence[_Sum], drawn: Drawn, motion: Motion) -> Figure | None:
    """Nothing where no vector is a sum of others."""
    tips = {s.name: tip for s in sums if (tip := _tip(s, drawn, motion)) is not None}
    spans = [span for s in sums if s.name in tips for span in _spans(s, tips, drawn, motion)]
    spans += list(_relative(sums, tips))
    largest = max((math.dist(s.start, s.end) for s in spans), default=0.0)
    spans = [s for s in spans if math.dist(s.start, s.end) > SMALL * largest]
    if len(spans) < 3:
        return None
    kind = "velocities" if sums[0].letter == "v" else "accelerations"
    marks: list[Mark] = [*spans, Symbol("point", POLE), Tag(POLE, line("o"))]
    return Figure((Panel(tuple(marks), line(f"polygon of {kind}, pole o")),), f"polygon of {kind}", name=kind)


def _tip(s: _Sum, drawn: Drawn, motion: Motion) -> Spot | None:
    """Where the vector of the left side ends."""
    scene = drawn.scene
    point = scene.points.get(s.point)
    if point is None:
        return None
    found: Vec = motion.velocity(point, s.body) if s.letter == "v" else motion.acceleration(point, s.body)
    return drawn.spot(found)


def _spans(s: _Sum, tips: dict[str, Spot], drawn: Drawn, motion: Motion) -> Iterator[Span]:
    """The vector itself from the pole, and what it is made of."""
    style, tip = STYLES[s.letter], tips[s.name]
    yield Span(POLE, tip, style, line(Name(s.name)))
    if s.base not in tips:
        return
    begin = tips[s.base]
    ends = [drawn.scene.points.get(n) for n in (s.point, s.start)]
    if s.letter == "v" or None in ends:
        yield Span(begin, tip, style, line(Name(f"{s.letter}_{s.point}/{s.start}")))
        return
    arm = drawn.spot(ends[0] - ends[1]) if ends[0] is not None and ends[1] is not None else None
    omega = drawn.number(motion.velocities[s.body].angular)
    if arm is None or omega is None:
        return
    middle = (begin[0] - omega**2 * arm[0], begin[1] - omega**2 * arm[1])
    rate = motion.velocities[s.body].angular
    yield Span(begin, middle, style, line(Math(rate**2), f" {s.point}{s.start}"))
    yield Span(middle, tip, style, line(Math(motion.accelerations[s.body].angular), f" {s.point}{s.start}"))


def _relative(sums: Sequence[_Sum], tips: dict[str, Spot]) -> Iterator[Span]:
    """v_rel of what slides, between the point of the moving frame and the one that slides there."""
    for name, tip in tips.items():
        slides = name.replace("′", "")
        if "′" in name and slides in tips and name.startswith("v"):
            yield Span(tip, tips[slides], STYLES["v"], line(Name("v_rel")))
