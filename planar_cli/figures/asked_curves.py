"""The curves that a file asks for, whole: the path of a point with the point on it, and its hodograph, the curve of the
tip of its velocity, with that velocity from the pole o.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import takewhile

import sympy as sp

from planar_cli.calculus.curve_words import LINE, PARABOLA, POINT
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.paths import value_in
from planar_cli.figures.rings import extent_of
from planar_cli.figures.shapes import moved
from planar_cli.figures.smooth import smooth
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.marks import Arrow, Figure, Mark, Panel, Polyline, Span, Spot, Symbol, Tag
from planar_cli.report.notation.names import index_of
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

STEPS, FEW, LEAST = 120, 10, 0.1
"""Places of a curve, and of a straight one; in these parts of it at least it is told."""
ASIDE = 0.15
"""So near to an axis, in parts of a quarter of a turn, no point is drawn."""
PATH, HODOGRAPH = "path", "hodograph"
AXES = {PATH: ("x", "y"), HODOGRAPH: ("v_x", "v_y")}
BEYOND, TIP = 0.12, 0.5
"""An axis goes on beyond the curve by this part of its size; the arrow at its end in parts of a usual one."""
SAME = 1e-6
FURTHER = 2.0
"""A parabola is drawn through so many times what the states span, and each open curve through so many times what lies
between its begin and where the point is drawn.
"""


@record
class Course:
    """A curve in numbers. `places`: those at which the point is drawn, with the names of their states."""

    found: Found
    asked: Quantity
    way: tuple[Spot, ...]
    places: tuple[tuple[str, Spot], ...]


def curve_figures(part: PartSolution) -> Iterator[tuple[frozenset[str], Figure]]:
    """Path and hodograph of each point, side by side, with the answers that they show."""
    courses = [c for f in part.found if (c := _course(part, f)) is not None]
    for point in dict.fromkeys(c.asked.things[0] for c in courses):
        own = [c for c in courses if c.asked.things[0] == point and not _is_seen(c)]
        if own:
            words = " and ".join(f"{c.asked.word} of {index_of(point)}" for c in own)
            figure = Figure(tuple(map(_panel, own)), words, name=f"curves of {point}")
            yield frozenset(c.found.name for c in own), figure


def _is_seen(c: Course) -> bool:
    """Needs it no figure: a straight path, or a point?"""
    kind = c.found.curve.kind if c.found.curve is not None else ""
    return kind.startswith(POINT) or (kind.startswith(LINE) and c.asked.word == PATH)


def whole_paths(part: PartSolution) -> dict[str, tuple[Spot, ...]]:
    """The paths over the ground that are asked for, by their points."""
    courses = (c for f in part.found if (c := _course(part, f)) is not None)
    return {c.asked.things[0]: c.way for c in courses if c.asked.word == PATH and c.asked.things[1:] in ((), (GROUND,))}


# --- in numbers ------------------------------------------------------------------------------------------------------


def _course(part: PartSolution, found: Found) -> Course | None:
    asked = found.find.found.what if found.find is not None else None
    curve, drawn = found.curve, _drawn(part)
    if not isinstance(asked, Quantity) or curve is None or drawn is None:
        return None
    if curve.course is None or curve.parameter is None or asked.word not in AXES:
        return None
    at = _Along(drawn, Vec(*curve.course), curve.parameter)
    known = _known(part.motion, curve.parameter)
    curves = [f.curve.kind for f in part.found if f.curve is not None and f.curve.parameter == curve.parameter]
    low, high = at.span([p for _, p in known], PARABOLA in curves)
    # A straight line needs no more than its ends.
    steps = FEW if curve.kind.startswith(LINE) else STEPS
    way = at.through(low, high, steps)
    if len(way) < LEAST * steps:
        return None
    own = known or ((("", at.drawn_at(high)),))
    return Course(found, asked, way, tuple((n, s) for n, p in own if (s := at(p)) is not None))


def _drawn(part: PartSolution) -> Drawn | None:
    if part.motion is not None:
        scenes = (r.solution.instant.scene for r in part.motion.regimes)
        return next((Drawn(s, part.motion.value, {}) for s in scenes), None)
    return Drawn.as_in_the_file(part.instants[0]) if part.instants else None


def _known(motion: MotionTrace | None, parameter: sp.Symbol) -> list[tuple[str, float]]:
    """What the parameter is in each state."""
    states = motion.states if motion is not None else ()
    found = ((s, value_in(motion, parameter, s)) for s in states if motion is not None)
    return [(state, value) for state, value in found if value is not None]


class _Along:
    """Places of a curve by its parameter."""

    def __init__(self, drawn: Drawn, course: Vec, parameter: sp.Symbol) -> None:
        self.drawn, self.course, self.parameter = drawn, course, parameter

    def __call__(self, value: float) -> Spot | None:
        here = {self.parameter: sp.Rational(f"{value:.9g}")}
        return self.drawn.spot(Vec(self.course.x.xreplace(here), self.course.y.xreplace(here)))

    def span(self, known: Sequence[float], is_parabola: bool) -> tuple[float, float]:
        """From where to where it is drawn: all of it where it repeats itself, or through the states and a bit on."""
        turn = self._turn()
        if turn and self._repeats(turn):
            return 0.0, turn
        if len(known) > 1:
            first, last = min(known), max(known)
            return first, first + (last - first) * (FURTHER if is_parabola else 1.0)
        end = abs(self.drawn_at(0.0) if not known else known[0]) * FURTHER
        return 0.0, turn or end or 1.0

    def through(self, low: float, high: float, steps: int) -> tuple[Spot, ...]:
        """The curve from one value to another; of a linkage that does not go all the way round, as far as it goes from
        where it is drawn.
        """
        drawn = self.drawn.number(self.parameter)
        spots = self._spots(low, high, steps) if steps > FEW or drawn is None else []
        if spots and None not in spots:
            return smooth(lambda share: self(low + (high - low) * share), steps)
        if drawn is None:
            return tuple(s for s in spots if s is not None)
        half = (high - low) / 2
        spots = self._spots(drawn - half, drawn + half, steps)
        middle = steps // 2
        before = takewhile(lambda s: s is not None, spots[middle::-1])
        after = takewhile(lambda s: s is not None, spots[middle + 1 :])
        return tuple(s for s in (*[*before][::-1], *after) if s is not None)

    def _spots(self, low: float, high: float, steps: int) -> list[Spot | None]:
        return [self(low + (high - low) * i / steps) for i in range(steps + 1)]

    def drawn_at(self, high: float) -> float:
        """The parameter where the point is drawn; on a curve with waves not on an axis, where nothing is seen apart."""
        turn, drawn = self._turn(), self.drawn.number(self.parameter)
        if turn and (drawn is None or not ASIDE < math.fmod(abs(drawn), turn / 4) / (turn / 4) < 1 - ASIDE):
            return turn / 8
        return drawn or high / FURTHER

    def _turn(self) -> float:
        """The parameter through one turn of its slowest wave; 0: it has none."""
        waves = self.course.x.atoms(sp.sin, sp.cos) | self.course.y.atoms(sp.sin, sp.cos)
        rates = [self.drawn.number(sp.diff(w.args[0], self.parameter)) for w in waves]
        told = [abs(r) for r in rates if r]
        return 2 * math.pi / min(told) if told and len(told) == len(rates) else 0.0

    def _repeats(self, turn: float) -> bool:
        """Is it the same again, or the same farther on, after one turn?"""
        steps = []
        for i in (0.1, 0.35, 0.8):
            one, other = self(turn * i), self(turn * (1 + i))
            if one is None or other is None:
                return False
            steps.append((other[0] - one[0], other[1] - one[1]))
        size = max(math.hypot(*s) for s in steps) + 1e-9
        return all(math.dist(s, steps[0]) < SAME * size or math.dist(s, steps[0]) < SAME for s in steps)


# --- how it is drawn -------------------------------------------------------------------------------------------------


def _panel(c: Course) -> Panel:
    """To a scale of its own: the curve is as large as one."""
    size = extent_of([*c.way, (0.0, 0.0)]) or 1.0
    way = tuple((x / size, y / size) for x, y in c.way)
    marks: list[Mark] = [*_axes(c, way), Polyline(way, "way"), *_origin(c)]
    for state, spot in c.places:
        at = (spot[0] / size, spot[1] / size)
        index = index_of(c.asked.things[0])
        if c.asked.word == HODOGRAPH:
            name = f"v_{index}" if not state else f"v_{index}__{state}"
            marks += [Span((0.0, 0.0), at, "velocity", line(Name(name)))] if math.hypot(*at) > SAME else []
        else:
            marks += [Symbol("particle", at), Tag(at, line(state.replace("_", " ") if state else Name(index)))]
    return Panel(tuple(marks), _head(c))


def _head(c: Course) -> Line:
    seen = f" seen from {c.asked.things[1]}" if len(c.asked.things) > 1 and c.asked.things[1] != GROUND else ""
    pole = ", pole o" if c.asked.word == HODOGRAPH else ""
    return line(f"{c.asked.word} of {index_of(c.asked.things[0])}{seen}{pole}")


def _origin(c: Course) -> Iterator[Mark]:
    name = "o" if c.asked.word == HODOGRAPH else c.asked.things[1] if len(c.asked.things) > 1 else "O"
    yield Symbol("point", (0.0, 0.0))
    yield Tag((0.0, 0.0), line(Name(index_of(name)) if name not in ("o", "O") else name))


def _axes(c: Course, way: Sequence[Spot]) -> Iterator[Mark]:
    """Both axes through the origin, as far as the curve reaches."""
    for i, (name, angle) in enumerate(zip(AXES[c.asked.word], (0.0, math.pi / 2), strict=True)):
        low, high = min(0.0, *(s[i] for s in way)), max(0.0, *(s[i] for s in way))
        start, end = moved((0.0, 0.0), angle, low - BEYOND / 2), moved((0.0, 0.0), angle, high + BEYOND)
        yield Polyline((start, end), "thin")
        yield Arrow(end, angle, "axis", line(Name(name)), TIP)
