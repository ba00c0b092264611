"""A motion that was followed as a film: the arrangement at many moments, drawn as in a figure."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from planar_cli.errors import PlanarError
from planar_cli.figures.arrangement import ALONE
from planar_cli.figures.belts import belt_marks
from planar_cli.figures.carried import Pose, carried
from planar_cli.figures.drawn import named_body
from planar_cli.figures.hanging import hanging, hangs_along
from planar_cli.figures.joints_drawn import sketch_marks
from planar_cli.figures.outlines import edges, lying
from planar_cli.figures.over_time import reached
from planar_cli.figures.parallel import moving_beside, parallel
from planar_cli.figures.partners import is_lane, is_slot, partners, sketch_of, sliders, touching
from planar_cli.figures.posed import Posed, variables_of
from planar_cli.figures.rings import extent_of, side_of, way_of
from planar_cli.figures.shapes import body_marks, moved
from planar_cli.figures.springs import settled
from planar_cli.figures.surfaces import surface_marks
from planar_cli.figures.unguided import is_idle, led_blocks
from planar_cli.figures.within import within
from planar_cli.motion.scene.curves import Formula, formula_of
from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Body, Curve, Round, Surface
from planar_cli.problem.scene.shapes import rim_of
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.film import Film, Thing
from planar_cli.report.document.marks import Coil, Hatched, Mark, Polyline, Slot, Spot, Symbol, Tag, spots_of
from planar_cli.simulate.run import Run

FEWEST, MOST, EACH_SECOND = 60, 240, 25
"""Moments of a film at least and at most; so many in a second on the screen."""
LONGEST, SHORTEST, USUAL = 30.0, 1.0, 5.0
"""A motion is shown in real time unless it takes longer or shorter than this [s]; then it takes so long."""
STROBED = 24
"""At so many moments bodies are looked at for how far surfaces go."""
BEYOND, REACH, STEPS = 0.25, math.radians(65), 60
"""A curve goes on by this part of the size of the scene, or by this angle, and is drawn by so many strokes."""
TURNS = 6
"""So many turns of a spiral are tried."""
MOST_SUDDEN = 40
"""So many moments at which something is sudden have a picture of their own."""


def film(run: Run, speed: float | None = None) -> Film:
    """The motion as it was followed. `speed`: how many times as fast as it is; None: as it is, unless that is too fast
    or too slow to be seen. PlanarError: nothing of it can be drawn.
    """
    duration = run.trajectory.t1 - run.trajectory.t0
    if duration <= 0 or not run.problem.bodies:
        raise PlanarError("there is no motion to be shown: it ends where it begins")
    seconds = duration / speed if speed else duration if SHORTEST <= duration <= LONGEST else USUAL
    times = _times(run, min(MOST, max(FEWEST, math.ceil(seconds * EACH_SECOND))))
    stage = _Stage(run, times)
    title = run.problem.title or run.problem.file
    return Film(
        tuple(times), tuple(stage.things()), tuple(reached(run)), seconds, title, run.problem.plane == "vertical"
    )


def _times(run: Run, count: int) -> list[float]:
    """Evenly spread, and when something is sudden."""
    t0, t1 = run.trajectory.t0, run.trajectory.t1
    sudden = sorted({x.t for x in run.trajectory.transitions if t0 < x.t < t1})
    near = (t1 - t0) / count / 4
    even = [t0 + (t1 - t0) * k / count for k in range(count)] + [t1]
    if len(sudden) > MOST_SUDDEN:
        return even
    return sorted({*sudden, *(t for t in even if t in (t0, t1) or all(abs(t - s) > near for s in sudden))})


class _Stage:
    """What is there at each moment."""

    def __init__(self, run: Run, times: Sequence[float]) -> None:
        self.run, self.times, self.problem = run, times, run.problem
        layout = run.model.layout
        self.poses: list[Posed] = []
        at_first = Posed(run.model.scene, variables_of(layout, times[0], run.trajectory.at(times[0])))
        beside = parallel(at_first, run.problem.joints)
        self.scene = moving_beside(run.model.scene, beside)
        for t in times:
            run.measures.wind(t)
            first = self.poses[0] if self.poses else None
            self.poses.append(Posed(self.scene, variables_of(layout, t, run.trajectory.at(t)), first, beside))
        every = max(1, len(times) // STROBED)
        self.strobed = self.poses[::every]
        centers = [s for p in self.strobed for s in self._centers(p)]
        self.size = extent_of(centers) or extent_of([s for p in self.poses[:1] for s in self._spots(p)]) or ALONE

    def _centers(self, pose: Posed) -> Iterator[Spot]:
        yield from (s for b in self.problem.bodies if (s := pose.spot(pose.model(b).center)) is not None)

    def _spots(self, pose: Posed) -> Iterator[Spot]:
        yield from (s for b in self.problem.bodies for m in body_marks(pose, pose.model(b)) for s in spots_of(m))

    def things(self) -> Iterator[Thing]:
        """Surfaces, bodies, what joins and moves them, points with their names."""
        first_pose, models = self.poses[0], [self.poses[0].model(b) for b in self.problem.bodies]
        lie = {n: (first_pose.spot(self.scene.center(n)), a) for n, a in lying(first_pose).items()}
        standing = {**led_blocks(first_pose), **hanging(first_pose)}
        standing |= {n: Symbol("block", spot, angle) for n, (spot, angle) in lie.items() if spot is not None}
        shaped = frozenset[str]().union(*(edges(first_pose, model) for model in models))
        for surface in self.problem.surfaces:
            if surface.name in shaped:
                continue
            marks = self._surface(surface)
            if surface.body is not None:
                carrier = next(m for m in models if m.name == surface.body)
                slotted = is_slot(surface, self.problem.joints)
                marks = [w for m in marks for w in within(m, [*body_marks(first_pose, carrier)], slotted)]
            yield self._with_carrier(surface.body, marks)
            for mark in marks:
                if isinstance(mark, Hatched):
                    along = way_of(mark.places[0], mark.places[-1])
                    block = Symbol("block", mark.places[0], along)
                    standing |= dict.fromkeys(sliders(self.problem, surface), block)
        entries = [(entry, self._sketched(entry)) for entry in (*self.problem.joints, *self.problem.loads)]
        entries = [*zip((e for e, _ in entries), self._settled([shots for _, shots in entries], standing), strict=True)]
        first = [m for _, shots in entries for m in shots[0]]
        sliding = {m.at for m in first if isinstance(m, Symbol) and m.kind in ("slider", "rail", "block")}
        for body in self.problem.bodies:
            marks = list(self._body(self.poses[0], body, standing))
            hidden = len(marks) == 1 and isinstance(marks[0], Symbol) and marks[0].at in sliding
            if not hidden:
                yield self._with_carrier(body.name, marks)
        for _, shots in entries:
            yield Thing(tuple(_with_even_turns(shots)))
        yield from self._points()

    # --- surfaces ----------------------------------------------------------------------------------------------------

    def _surface(self, surface: Surface) -> list[Mark]:
        """A surface where it is at first, as far as bodies come to it."""
        first = self.poses[0]
        home = first.pose(surface.body)
        near_it = set(partners(self.problem, surface))
        seen = [
            carried(body_marks(pose, pose.model(b)), pose.pose(surface.body), home)
            for pose in self.strobed
            for b in self.problem.bodies
            if b.name != surface.body and (b.name in near_it or surface.body is None)
        ]
        points = [p for p in touching(self.problem, surface) if p not in near_it]
        places = [s for p in points if (s := first.spot(first.moving.point(p))) is not None]
        bodies = [s for b in self.problem.bodies if b.name in near_it for s in _center(first, b)]
        if isinstance(surface.shape, Curve):
            spots = [home.seen(s) for marks in seen for m in marks for s in spots_of(m)] + [*map(home.seen, places)]
            return self._curve(surface, surface.shape, spots, bodies or [*self._centers(first)])
        near = bodies or [*self._centers(first)]
        return [
            b
            for m in surface_marks(first, surface, places, seen, near, self.size)
            for b in belt_marks(first, surface, m)
        ]

    def _curve(self, surface: Surface, shape: Curve, spots: Sequence[Spot], bodies: Sequence[Spot]) -> list[Mark]:
        """A curve, along the part of its variable that is passed."""
        scene, first = self.scene, self.poses[0]
        formula, origin = formula_of(scene, shape), self._origin(surface)
        own = [origin.seen(first.pose(surface.body).there(s)) for s in spots] or [(0.0, 0.0)]
        ways = [x if shape.kind == "y" else _turned(formula, x, y) for x, y in own]
        low, high = min(ways), max(ways)
        more = BEYOND * self.size if shape.kind == "y" else REACH
        places: list[Spot] = []
        for k in range(STEPS + 1):
            at = low - more + (high - low + 2 * more) * k / STEPS
            try:
                value = formula.numbers(at)[0]
            except ArithmeticError:
                continue
            if math.isfinite(value):
                spot = (at, value) if shape.kind == "y" else (value * math.cos(at), value * math.sin(at))
                places.append(origin.there(spot))
        if len(places) < 2:
            return []
        if surface.body is not None:
            return [Polyline(tuple(places), "body")]
        if is_lane(self.problem, surface.name):
            return [Polyline(tuple(places), "lane")]
        above = side_of(places, bodies) >= 0
        return [Hatched(tuple(places if above else places[::-1]))]

    def _origin(self, surface: Surface) -> Pose:
        """The axes in which a curve is drawn, where its carrier is now."""
        first, scene = self.poses[0], self.scene
        zero = scene.graph.number(0.0)
        at = first.spot(scene.carried_from(surface.body or "", Vec(zero, zero))) or (0.0, 0.0)
        return Pose(at, first.number(scene.turned_by(surface.body or "")) or 0.0)

    def _with_carrier(self, body: str | None, marks: Sequence[Mark]) -> Thing:
        home = self.poses[0].pose(body)
        return Thing(tuple(tuple(carried(marks, home, pose.pose(body))) for pose in self.poses))

    # --- bodies and what joins them ----------------------------------------------------------------------------------

    def _body(self, pose: Posed, body: Body, standing: Mapping[str, Symbol]) -> Iterator[Mark]:
        model = pose.model(body)
        for mark in body_marks(pose, model):
            block = standing.get(body.name)
            yield replace(block, at=mark.at) if block is not None and isinstance(mark, Symbol) else mark
        yield from _spoke(pose, body, rim_of(body.shape))

    def _sketched(self, entry: Entry) -> list[tuple[Mark, ...]]:
        """What a joint or load looks like at each moment; nothing while it does not act."""
        first, name = self.poses[0], line(entry.name)
        hung = hanging(first)
        held = (s for s in sketch_of(first, entry) if not hangs_along(first, s, hung))
        sketches = [s for s in held if not is_idle(first, entry, s)]
        shots = [
            tuple(m for s in sketches for m in sketch_marks(pose, s, name)) if self._acts(entry, t) else ()
            for t, pose in zip(self.times, self.poses, strict=True)
        ]
        return list(_with_still_floors(shots))

    def _settled(
        self, sketched: Sequence[list[tuple[Mark, ...]]], standing: Mapping[str, Symbol]
    ) -> Iterator[list[tuple[Mark, ...]]]:
        """Springs and dampers beside each other and up to the bodies that they hold, at each moment."""
        whole = []
        for k, pose in enumerate(self.poses):
            bodies = [m for b in self.problem.bodies for m in self._body(pose, b, standing)]
            whole.append(list(settled([*(m for shots in sketched for m in shots[k]), *bodies])))
        begun = [0] * len(self.poses)
        for shots in sketched:
            ends = [begin + len(marks) for begin, marks in zip(begun, shots, strict=True)]
            yield [tuple(marks[a:b]) for marks, a, b in zip(whole, begun, ends, strict=True)]
            begun = ends

    def _acts(self, entry: Entry, t: float) -> bool:
        if entry.during is None:
            return True
        moments = self.run.measures.moments
        begin, end = (moments.get(name) for name in entry.during)
        return (begin is not None and t >= begin.t) and (end is None or t <= end.t)

    def _points(self) -> Iterator[Thing]:
        """The named points, and the bodies that are not called by them."""
        problem, scene = self.problem, self.scene
        named = [p.name for p in problem.points if not p.unnamed and p.name not in problem.hidden]
        for name in named:
            spots = [pose.spot(scene.point(name)) for pose in self.poses]
            shots = tuple(() if s is None else (Symbol("point", s), Tag(s, line(Name(name)))) for s in spots)
            yield Thing(shots)
        for body in problem.bodies:
            called = body.name in named or any(a + b == body.name for a in named for b in named)
            if not called and body.name not in problem.hidden:
                words = named_body(body.name)
                yield Thing(tuple(tuple(Tag(s, words) for s in _center(pose, body)) for pose in self.poses))


def _center(pose: Posed, body: Body) -> Iterator[Spot]:
    spot = pose.spot(pose.model(body).center)
    if spot is not None:
        yield spot


def _spoke(pose: Posed, body: Body, rim: Round | None) -> Iterator[Mark]:
    """A radius, by which the turning of something round is seen."""
    center = None if rim is None else pose.carried(body.name, rim.center)
    radius = None if rim is None else pose.length(rim.radius)
    if center is not None and radius:
        yield Polyline((center, moved(center, pose.pose(body.name).turn, radius)), "thin")


def _with_still_floors(shots: Sequence[tuple[Mark, ...]]) -> Iterator[tuple[Mark, ...]]:
    """The floor or slot of what slides stays where it is, as far as that comes."""
    floors = [[m for m in marks if _is_still(m)] for marks in shots]
    first = next((f for f in floors if f), [])
    if any(f and len(f) != len(first) for f in floors):
        yield from shots
        return
    whole: list[Mark] = []
    for i, floor in enumerate(first):
        (x0, y0), (x1, y1) = (s := list(spots_of(floor)))[0], s[-1]
        along = floor.angle if isinstance(floor, Slot) else math.atan2(y1 - y0, x1 - x0)
        ends = [moved((0.0, 0.0), -along, x - x0, y - y0)[0] for f in floors if f for x, y in spots_of(f[i])]
        low, high = moved((x0, y0), along, min(ends)), moved((x0, y0), along, max(ends))
        whole.append(Slot(low, high, along, True) if isinstance(floor, Slot) else Hatched((low, high)))
    for marks in shots:
        yield (*(whole if marks else ()), *(m for m in marks if not _is_still(m)))


def _is_still(mark: Mark) -> bool:
    return isinstance(mark, Hatched) or (isinstance(mark, Slot) and mark.fixed)


def _with_even_turns(shots: Sequence[tuple[Mark, ...]]) -> Iterator[tuple[Mark, ...]]:
    """Springs with the same number of turns all the time: as many as at their middle length."""
    lengths = [math.dist(m.start, m.end) for marks in shots for m in marks if isinstance(m, Coil)]
    middle = sorted(lengths)[len(lengths) // 2] if lengths else 0.0
    for marks in shots:
        yield tuple(replace(m, like=middle) if isinstance(m, Coil) else m for m in marks)


def _turned(formula: Formula, x: float, y: float) -> float:
    """The angle of a place of r(theta), with the turns that it takes to come so far out."""
    angle, reach = math.atan2(y, x), math.hypot(x, y)

    def off(turns: int) -> float:
        try:
            value = formula.numbers(angle + 2 * math.pi * turns)[0]
        except ArithmeticError:
            return math.inf
        return abs(value - reach) if math.isfinite(value) else math.inf

    # Of several that fit, as on a closed curve, the one without turns.
    return angle + 2 * math.pi * min(
        range(-TURNS, TURNS + 1), key=lambda n: (round(off(n) / (reach or 1.0), 6), abs(n))
    )
