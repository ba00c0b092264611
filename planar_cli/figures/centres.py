"""The instantaneous centre I of a body where a page reasons with it: the dashed perpendiculars to the velocities of
points of the body cross there.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.scene.centres import centre_of
from planar_cli.figures.diagrams import slim
from planar_cli.figures.drawn import TINY, Drawn
from planar_cli.figures.given_motion import Found
from planar_cli.figures.joints_drawn import sketch_marks
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.rings import extent_of
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Find
from planar_cli.problem.scene.sketches import Slide
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Check, Equation, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.document.marks import Arrow, Figure, Mark, Panel, Polyline, Spot, Symbol, Tag, Turn, spots_of
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.notation.names import index_of
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import Solution

TOLD = re.compile(r"instantaneous centre of (?P<body>[^\s:]+):")
"""What a page says before it works with a centre: `…, the instantaneous centre of AB:`."""
SPEED = re.compile(r"v_(?P<point>.+)")
ASKED, PRIME = "IC", "′"
FASTEST = 2.0
"""The length of the arrow of the fastest point, in parts of a usual one; the others are to its scale."""
FARTHEST = 5.0
"""A centre that is so many times farther away than the scene is wide is beyond the paper."""
CORNER, NEAR = 0.035, 1e-6
"""The side of the mark of a right angle, and what is one place, in parts of the size of the figure."""


@record
class Centre:
    """A body with its centre I, and points of it with their velocities [m/s]."""

    body: str
    at: Spot
    points: tuple[tuple[Line, str, Spot, Spot], ...]
    """Velocity in words, index, place, velocity."""
    turning: float
    """ω [rad/s], counterclockwise."""
    turn: Line
    """The same in words, where it is a letter."""


class Centres:
    """The figures of a page, each body once in one position."""

    def __init__(self, solution: Solution, page: Sequence[Block]) -> None:
        self.motions = [part.motion for part in solution.parts if part.motion is not None]
        self.named = {
            p.name for block in page if isinstance(block, Equation) for p in pieces_of(block) if isinstance(p, Name)
        }
        self.drawn = set[tuple[int, str | None, str]]()

    def told(self, blocks: Sequence[Block], instant: InstantSolution | None) -> Iterator[Figure]:
        """Of the centres by which these blocks find velocities, or check them."""
        moving = _moving(instant)
        if moving is None:
            return
        for block in blocks:
            pieces = block.line if isinstance(block, Paragraph | Check) else ()
            told = next((m for p in pieces if isinstance(p, Text) and (m := TOLD.search(p.text)) is not None), None)
            if told is not None and told["body"] in moving.drawn.scene.bodies:
                speeds = (SPEED.fullmatch(p.name) for p in pieces if isinstance(p, Name))
                points = dict.fromkeys(m["point"] for m in speeds if m is not None)
                yield from self._once(moving, None, told["body"], list(points))

    def asked(self, instant: InstantSolution | None) -> Iterator[Figure]:
        """Of the centres that the file asks for, with points of the body whose velocities the page names."""
        moving = _moving(instant)
        if moving is not None:
            yield from self._asked(moving, moving.drawn.scene.problem.find, None)
            return
        for motion in self.motions:
            for state in motion.states:
                later = _moving_in(motion, state)
                if later is not None:
                    yield from self._asked(later, motion.problem.find, state)

    def _asked(self, moving: Found, finds: Sequence[Find], state: str | None) -> Iterator[Figure]:
        scene = moving.drawn.scene
        for find in finds:
            asked = find.found.what
            if isinstance(asked, Quantity) and asked.word == ASKED and asked.at == state:
                (body,) = asked.things
                points = [index_of(n) for n in scene.points if body in scene.owners.get(n, ())]
                spoken = [n for n in points if f"v_{n}" in self.named]
                yield from self._once(moving, state, body, spoken or [index_of(centre_of(scene, body))])

    def _once(self, moving: Found, state: str | None, body: str, points: Sequence[str]) -> Iterator[Figure]:
        key = (id(moving.motion), state, body)
        figure = None if key in self.drawn else _figure(moving, body, points)
        if figure is not None:
            self.drawn.add(key)
            yield figure


def _moving(instant: InstantSolution | None) -> Found | None:
    return Found.of(Drawn.as_in_the_file(instant), (instant,)) if instant is not None else None


def _moving_in(motion: MotionTrace, state: str) -> Found | None:
    """A motion in one of its states; None: nothing tells where its bodies are then."""
    drawn = Drawn.in_state(motion, state)
    return Found.of(drawn, (r.solution for r in motion.regimes)) if drawn is not None else None


def _figure(moving: Found, body: str, names: Sequence[str]) -> Figure | None:
    centre = _centre(moving, body, names)
    if centre is None:
        return None
    drawn = moving.drawn
    around = list(_around(drawn))
    size = extent_of([*(s for m in around for s in spots_of(m)), *(p for _, _, p, _ in centre.points)])
    if any(math.dist(centre.at, p) > FARTHEST * size for _, _, p, _ in centre.points):
        return None
    size = extent_of([centre.at, *(s for m in around for s in spots_of(m))])
    words = f"instantaneous centre of {body.replace('_', ' ')}"
    return Figure((Panel((*around, *_marks(centre, size)), line(f"{words}: I")),), words, name=f"centre of {body}")


def _around(drawn: Drawn) -> Iterator[Mark]:
    """The bodies, and what holds them."""
    for body in drawn.scene.bodies.values():
        yield from map(slim, body_marks(drawn, body))
    for joint in drawn.scene.problem.joints:
        for sketch in sketch_of(drawn, joint):
            yield from sketch_marks(drawn, sketch, ())


def _centre(moving: Found, body: str, names: Sequence[str]) -> Centre | None:
    """None: the body does not turn, or nothing tells where its points are."""
    spin = sp.sympify(moving.motion.velocities[body].angular)
    omega = moving.drawn.number(spin)
    places = [(name, p) for name in names if (p := _place(moving.drawn, body, name)) is not None]
    if not omega or not places:
        return None
    found = []
    for name, place in places:
        at, v = moving.drawn.spot(place), moving.drawn.spot(moving.motion.velocity(place, body))
        if at is None or v is None:
            return None
        if math.hypot(*v) > TINY:
            found.append((line(Name(f"v_{name}")), name, at, v))
    if not found:
        return None
    for name, place in _slides_over(moving.drawn, body):
        at, v = moving.drawn.spot(place), moving.drawn.spot(moving.motion.velocity(place, body))
        if at is not None and v is not None and math.hypot(*v) > TINY:
            found.append((line(Name(f"v_{index_of(name)}{PRIME}")), index_of(name), at, v))
    (_, _, (x, y), (vx, vy)) = found[0]
    return Centre(
        body, (x - vy / omega, y + vx / omega), tuple(found), omega, line(Math(spin)) if spin.is_Symbol else ()
    )


def _slides_over(drawn: Drawn, body: str) -> Iterator[tuple[str, Vec]]:
    """Fixed points over which a body slides: there it moves along itself."""
    for joint in drawn.scene.problem.joints:
        for sketch in sketch_of(drawn, joint):
            if isinstance(sketch, Slide) and sketch.pinned and sketch.track == body:
                yield str(getattr(joint, "point", "")), sketch.at


def _place(drawn: Drawn, body: str, name: str) -> Vec | None:
    """A point, or the mass centre of the body, by its index on the page."""
    scene = drawn.scene
    if name == index_of(centre_of(scene, body)):
        return scene.bodies[body].center
    found = next((n for n in scene.points if index_of(n) == name), None)
    return None if found is None or scene.owner(found) == GROUND else scene.point(found)


def _marks(centre: Centre, size: float) -> Iterator[Mark]:
    fastest = max(math.hypot(*v) for _, _, _, v in centre.points)
    for words, name, at, v in centre.points:
        angle = math.atan2(v[1], v[0])
        far, inward = math.dist(at, centre.at), math.atan2(centre.at[1] - at[1], centre.at[0] - at[0])
        if far > NEAR * size:
            yield Polyline((at, centre.at), "dashed")
            yield from _corner(at, inward, angle, min(CORNER * size, far / 2))
            yield Tag(moved(at, inward, far / 2), line("I", *_distance(name)))
        yield Symbol("point", at)
        yield Tag(at, line(Name(name)))
        yield Arrow(at, angle, "velocity", words, FASTEST * math.hypot(*v) / fastest)
    yield Symbol("point", centre.at)
    yield Tag(centre.at, line("I"))
    yield Turn(centre.at, 1 if centre.turning > 0 else -1, "velocity", centre.turn)


def _distance(name: str) -> Line:
    """G of IG, whose index the figure does not need."""
    return line(name.partition(",")[0])


def _corner(at: Spot, one: float, other: float, side: float) -> Iterator[Mark]:
    """The mark of a right angle."""
    first, last = moved(at, one, side), moved(at, other, side)
    yield Polyline((first, moved(first, other, side), last), "thin")
