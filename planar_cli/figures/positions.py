"""Where bodies are in later states, dashed beside the position in which the file draws them, and the way there.

A state far away would make all else tiny: it is brought nearer, and its way there is drawn with a break.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import pairwise
from typing import TYPE_CHECKING

from planar_cli.errors import PlanarError
from planar_cli.figures.carried import Pose, carried, shifted
from planar_cli.figures.drawn import TINY, Drawn
from planar_cli.figures.held_later import held_marks
from planar_cli.figures.parallel import drawn_beside, moving_beside
from planar_cli.figures.partners import between, sketch_of
from planar_cli.figures.paths import followed_path, path_of
from planar_cli.figures.posed import Posed, variables_of
from planar_cli.figures.rings import extent_of, moved_by
from planar_cli.figures.shapes import body_marks
from planar_cli.figures.ways import in_shape, lower_by, lowered, round_a_tie
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.scene import GROUND, Line, Problem, Round
from planar_cli.problem.scene.sketches import Sketch, Slide
from planar_cli.records import record
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Arc, Coil, Dashpot, Mark, Polyline, Spot, Symbol, Tag, spots_of
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

if TYPE_CHECKING:
    from planar_cli.simulate.measures import Moment
    from planar_cli.simulate.run import Run

FAR, LEAST = 3.0, 25.0
"""To scale a state is at most so many times the size of the scene away, and so many times that of the smallest body."""
ASIDE, BESIDE = 0.5, 2.0
"""One that is brought nearer is at most by this part of that away from the one before, and by so many times the size of
the scene.
"""
NEAR = 0.03
"""As near to another one in parts of the size, a position is the same."""
NOWHERE: Spot = (0.0, 0.0)
MOVING = ("r", "x", "y", "v", "a")
"""What is asked of a point."""
JOINED = ", "
"""Between the names of states in one position."""


@record
class Later:
    """A position of all bodies in one or more states. `shift`: by so much it is drawn nearer, m."""

    states: tuple[str, ...]
    there: Drawn
    spots: Mapping[str, Spot]
    angles: Mapping[str, float | None]
    shift: Spot = (0.0, 0.0)
    own: Mapping[str, Spot] = field(default_factory=dict)
    """By so much single bodies are besides, so that none is seen to go back that goes ahead or stands, m."""
    lower: Spot = (0.0, 0.0)
    """By so much bodies that flew are drawn lower than where the letters of the scene, as drawn, have them, m."""
    first: Later | None = None
    """The position that is moved and turned into this one, where `there` is not this one."""
    pose: Drawn | None = None
    """Then how things are joined there."""

    @property
    def held(self) -> Drawn | None:
        """How things are joined in it; None: nothing tells."""
        return self.there if self.first is None else self.pose

    @property
    def words(self) -> str:
        """What stands beside it."""
        return JOINED.join(name.replace("_", " ") for name in self.states)

    def marks(self, name: str) -> list[Mark]:
        """A body there, dashed."""
        body = self.there.scene.bodies.get(name)
        if body is None:
            return [Symbol("place", self.at(name))]
        drawn = list(body_marks(self.there, body, "hidden"))
        shapes: list[Mark] = [m for m in drawn if isinstance(m, Arc | Polyline)]
        if shapes:
            shapes += [replace(m, kind="place") for m in drawn if isinstance(m, Symbol) and m.kind == "particle"]
        if self.first is not None:
            turn = (self.angles.get(name) or 0.0) - (self.first.angles.get(name) or 0.0) if body.rigid else 0.0
            shapes = carried(shapes, Pose(self.first.spots[name], 0.0), Pose(self.spots[name], turn))
        return [shifted(m, self._nearer_by(name)) for m in shapes] or [Symbol("place", self.at(name))]

    def is_round(self, name: str) -> bool:
        """Is it a disk, or nothing but a point?"""
        body = self.there.scene.bodies.get(name)
        return body is None or isinstance(body.shape, Round)

    def at(self, name: str) -> Spot:
        """Where a body is drawn."""
        return moved_by(self.spots[name], self._nearer_by(name))

    def _nearer_by(self, name: str) -> Spot:
        return moved_by(self.shift, self.own.get(name, NOWHERE))


def positions(drawn: Drawn, motion: MotionTrace, states: Sequence[str]) -> list[Later]:
    """The different positions of a motion, that of the drawing first, each with the names of its states."""
    told = [(s, there) for s in states if (there := Drawn.in_state(motion, s)) is not None]
    told = [(s, drawn_beside(there, drawn.beside)) for s, there in told]
    places = [position_of((), drawn), *(position_of((state,), there) for state, there in told)]
    return _bent(_different(drawn, places), motion)


def positions_of_instants(drawn: Drawn, instants: Sequence[InstantSolution]) -> list[Later]:
    """The same of states with no motion in between, of which the first one is drawn."""
    told = [(i.state, Drawn.as_in_the_file(i)) for i in instants[1:]]
    told = [(s, drawn_beside(there, drawn.beside)) for s, there in told if there.is_placed]
    own = tuple(i.state for i in instants[:1])
    return _different(drawn, [position_of(own, drawn), *(position_of((state,), there) for state, there in told)])


def _different(drawn: Drawn, all_: Sequence[Later | None]) -> list[Later]:
    """Those of some positions that are not the same as another one."""
    found: list[Later] = []
    spots = [s for p in all_ if p is not None for s in p.spots.values()]
    near = NEAR * max(extent_of(spots), max((_own(drawn, n) for n in drawn.scene.bodies), default=0.0))
    for new in all_:
        if new is not None:
            _put(found, new, near)
    return found


def _bent(places: list[Later], motion: MotionTrace) -> list[Later]:
    """The same with flights that are seen to be bent, where letters leave open how long they are."""
    scene = places[0].there.scene if places else None
    alone = scene is not None and scene.ledger.symbolic and not (scene.problem.joints or scene.problem.surfaces)
    if scene is None or not alone or len(places) != 2 or not (places[0].states and places[1].states):
        return places
    first, last = places
    names = [n for n in first.spots if n in last.spots and _moved(n, first, last)]
    ways = [path_of(motion, None, n, first.states[-1], last.states[0]) for n in names]
    if not all(len(w) > 2 for w in ways):
        return places
    lower = lower_by(ways, [*first.spots.values(), *last.spots.values()])
    spots = {n: moved_by(s, lower) if n in names else s for n, s in last.spots.items()}
    return [first, replace(last, spots=spots, lower=lower)]


def followed_positions(drawn: Drawn, run: Run) -> list[Later]:
    """The same of a motion that was followed in numbers alone."""
    first = position_of((), drawn)
    if first is None:
        return []
    found, size = [first], max((_own(drawn, n) for n in drawn.scene.bodies), default=0.0)
    for state, moment in run.measures.moments.items():
        asked = {n: s for n in first.spots if (s := _asked(run, "r", n, moment))}
        spots = {n: moved_by((x, y), drawn.beside.moves.get(n, NOWHERE)) for n, (x, y) in asked.items()}
        turns = {n: t[0] for n in drawn.scene.bodies if (t := _asked(run, "theta", n, moment))}
        if not state or spots.keys() != first.spots.keys():
            continue
        scene = moving_beside(run.model.scene, drawn.beside)
        pose = Posed(scene, variables_of(run.model.layout, moment.t, moment.y), beside=drawn.beside)
        new = Later((state,), drawn, spots, {**first.angles, **turns}, first=first, pose=pose)
        _put(found, new, NEAR * max(size, _reach(new, first)))
    return found


def _put(found: list[Later], new: Later, near: float) -> None:
    """One more position; of one that is there already, the names of its states."""
    for i, old in enumerate(found):
        if _same(old, new, near):
            found[i] = replace(old, states=(*old.states, *new.states))
            return
    found.append(new)


def _asked(run: Run, word: str, name: str, moment: Moment) -> tuple[float, ...]:
    """A place [m] or an angle [rad] of a motion that was followed; nothing where it has none."""
    try:
        return run.measures.at(Quantity(word, (name,), None, (), None, run.problem.states[0].mark), moment)
    except (PlanarError, ArithmeticError):
        return ()


def position_of(states: tuple[str, ...], there: Drawn) -> Later | None:
    """Where all bodies are in some states; None: nothing tells it of any."""
    scene = there.scene
    spots = {name: spot for name, body in scene.bodies.items() if (spot := there.spot(body.center)) is not None}
    angles = {name: there.number(scene.bodies[name].theta) for name in spots}
    moving = (p.name for p in scene.problem.points if not p.unnamed and scene.owner(p.name) == GROUND)
    alone = {name: spot for name in moving if (spot := there.spot(scene.points[name])) is not None}
    spots |= {name: spot for name, spot in alone.items() if name not in spots}
    return Later(states, there, spots, angles) if spots else None


def _same(a: Later, b: Later, near: float) -> bool:
    return a.spots.keys() == b.spots.keys() and all(
        math.dist(a.spots[n], b.spots[n]) <= near and (a.is_round(n) or _same_way(a.angles.get(n), b.angles.get(n)))
        for n in a.spots
    )


def brought_near(places: Sequence[Later], size: float) -> list[Later]:
    """The same with those that are too far away drawn nearer, along the way from the position before. `size`: that of
    the scene as drawn, m; 0: it is a point, and nothing is far away.
    """
    if not places or not size:
        return list(places)
    first = places[0]
    bodies = first.there.scene.bodies
    rigid = [own for name, body in bodies.items() if body.rigid and (own := _own(first.there, name))]
    most = max(2 * size, min(FAR * 4 * size, LEAST * min(rigid)) if rigid else FAR * size)
    apart = min(ASIDE * most, BESIDE * size)
    found = [first]
    for before, p in pairwise(places):
        found.append(
            _nearer(p, replace(before, shift=found[-1].shift, own=found[-1].own), apart)
            if _reach(p, first) > most
            else p
        )
    return found


def _nearer(p: Later, before: Later, apart: float) -> Later:
    """A position that is drawn no farther `apart` from the one before; one body that goes another way than the
    farthest, as a carriage on which that one slides, in its own sense.
    """
    ways = {n: (p.spots[n][0] - x, p.spots[n][1] - y) for n, (x, y) in before.spots.items() if n in p.spots}
    farthest = max(ways.values(), key=lambda way: math.hypot(*way))
    back = 1 - min(apart / math.hypot(*farthest), 1)
    own = dict(before.own)
    for name, (x, y) in ways.items():
        behind = farthest[0] - x, farthest[1] - y
        seen = x - farthest[0] * back, y - farthest[1] * back
        if math.hypot(x, y) <= apart < math.hypot(*farthest):
            # What goes no farther than that is where it is.
            own[name] = moved_by(before.own.get(name, NOWHERE), (farthest[0] * back, farthest[1] * back))
        elif math.hypot(*behind) > apart and x * seen[0] + y * seen[1] <= 0:
            own[name] = moved_by(before.own.get(name, NOWHERE), (behind[0] * back, behind[1] * back))
    x, y = before.shift
    return replace(p, shift=(x - farthest[0] * back, y - farthest[1] * back), own=own)


def slid_to(places: Sequence[Later], entry: Entry, sketch: Sketch) -> list[Spot]:
    """Where what slides along a track, or its outline, is in some positions."""
    if not isinstance(sketch, Slide):
        return []
    if sketch.body is not None:
        return [s for p in places if sketch.body in p.spots for m in p.marks(sketch.body) for s in spots_of(m)]
    held = [(p, p.held) for p in places if p.held is not None]
    found = [(p, there.spot(s.at)) for p, there in held for s in sketch_of(there, entry) if isinstance(s, Slide)]
    return [moved_by(s, p.shift) for p, s in found if s is not None]


def position_marks(
    places: Sequence[Later], motion: MotionTrace | None, run: Run | None, shown: Sequence[Mark]
) -> Iterator[Mark]:
    """The ways of the bodies that move, and where they are in each position. `shown`: the first one, as it is drawn."""
    blocks = {m.at: m.angle for m in shown if isinstance(m, Symbol) and m.kind == "block"}
    yield from _ways(places, motion, run)
    # Where something only swings to has no name.
    named = [p for p in places if p.states or p is places[0]]
    for p in places:
        first = p is places[0]
        seen = [n for n in p.spots if any(_moved(n, p, q) for q in named) and (first or _moved(n, places[0], p))]
        for name in seen if not first else ():
            angle = blocks.get(places[0].spots[name])
            yield from p.marks(name) if angle is None else [Symbol("later", p.at(name), _lies(p, name, angle))]
        if p.held is not None and places[0].held is not None and not first and not any(p.shift):
            between = [q.held for q in places[1 : places.index(p)] if q.held is not None]
            held = held_marks(p.held, places[0].held, between)
            # How springs are where something only swings to is not of interest.
            yield from (m for m in held if p in named or not isinstance(m, Coil | Dashpot))
        for name in _apart(p, seen, places) if p.words else ():
            yield Tag(p.at(name), line(p.words))


def asked_places(places: Sequence[Later], problem: Problem) -> Iterator[Mark]:
    """Points of round bodies that have turned, where something of them is asked for later: nothing else shows it."""
    told = set[tuple[str, Spot]]()
    for find in problem.find:
        asked = find.found.what
        if not isinstance(asked, Quantity) or asked.word not in MOVING or not asked.things:
            continue
        name, p = asked.things[0], next((p for p in places[1:] if asked.at in p.states), None)
        if p is None or p.first is not None or name not in p.there.scene.points or any(p.shift):
            continue
        owner, spot = p.there.scene.owner(name), p.there.spot(p.there.scene.points[name])
        if owner not in p.there.scene.bodies or spot is None or math.dist(spot, p.at(owner)) < TINY:
            continue
        if p.is_round(owner) and (name, spot) not in told:
            told.add((name, spot))
            yield Symbol("place", spot)
            yield Tag(spot, line(Name(f"{name}__{asked.at}")))


def _lies(p: Later, name: str, angle: float) -> float:
    """The direction of the line on which a block stands in a position; `angle`: of that on which it stood."""
    scene = p.there.scene
    for joint in scene.problem.joints if p.first is None else ():
        named = between(joint)
        for surface in scene.problem.surfaces if name in named else ():
            along = p.there.angle(scene.surface_direction(surface)) if isinstance(surface.shape, Line) else None
            if surface.name in named and along is not None:
                return along if math.cos(along - angle) > 0 else along + math.pi
    return angle


def _apart(p: Later, names: Sequence[str], places: Sequence[Later]) -> list[str]:
    """One of each group of bodies that hang together, as the name of the state stands beside it once: not where it
    would stand on a wheel in another position.
    """
    others = [q for q in places if q is not p]
    groups = _hanging(p, names, by_axles=True)
    return [next((n for n in g if not any(_is_on_a_wheel(p.at(n), q) for q in others)), g[0]) for g in groups]


def _is_on_a_wheel(spot: Spot, q: Later) -> bool:
    round_ = (n for n in q.spots if q.is_round(n) and n in q.there.scene.bodies)
    return any(math.dist(spot, q.at(n)) < _own(q.there, n) / 2 for n in round_)


def _hanging(p: Later, names: Sequence[str], by_axles: bool = False) -> list[list[str]]:
    """The bodies in groups whose outlines have places in common, as ends at a pin. `by_axles`: or one of which ends at
    the centre of another that is round.
    """
    groups: list[tuple[list[str], set[Spot]]] = []
    for name in names:
        places = [s for m in p.marks(name) for s in spots_of(m)]
        places += [p.at(name)] if by_axles and p.is_round(name) else []
        own = {(round(x, 6), round(y, 6)) for x, y in places}
        joined = [g for g in groups if g[1] & own]
        groups = [g for g in groups if g not in joined]
        groups.append(([*(n for g in joined for n in g[0]), name], own.union(*(g[1] for g in joined))))
    return [names for names, _ in groups]


def _moved(name: str, a: Later, b: Later) -> bool:
    """Is a body seen elsewhere? That a disk has turned in its place is not to be seen."""
    if name not in a.spots or name not in b.spots:
        return False
    turned = not _same_way(a.angles.get(name), b.angles.get(name)) and not a.is_round(name)
    return math.dist(a.spots[name], b.spots[name]) > TINY or turned


def _ways(places: Sequence[Later], motion: MotionTrace | None, run: Run | None) -> Iterator[Mark]:
    where, before = {state: p for p in places for state in p.states}, dict[str, Sequence[Spot]]()
    states = motion.states if motion is not None else tuple(s.name for s in run.problem.states) if run else ()
    for since, until in pairwise(s for s in states if s in where):
        a, b = where[since], where[until]
        # That of a link of a mechanism says nothing.
        links = {n for g in _hanging(a, list(a.spots)) if len(g) > 1 for n in g if not a.is_round(n) and n in a.angles}
        bodies = a.there.scene.bodies
        for name in [n for n in a.spots if n not in links or not bodies[n].rigid] if a is not b else ():
            if name not in b.spots or math.dist(a.spots[name], b.spots[name]) < TINY:
                continue
            way = path_of(motion, run, name, since, until) if motion else followed_path(run, name, since, until)
            way = way or round_a_tie(b.there, name, (a.spots[name], b.spots[name]), before.get(name, ()))
            before[name] = way
            if a.shift != b.shift:
                yield from _broken((a.at(name), b.at(name)), way)
            elif not any(a.shift) and len(way) > 1:
                drawn = lowered(way, b.lower) if any(b.lower) else way
                yield shifted(Polyline(drawn, "way"), a.there.beside.moves.get(name, NOWHERE))


def _broken(ends: tuple[Spot, Spot], way: Sequence[Spot]) -> Iterator[Mark]:
    """The way to a place that is drawn too near, in its shape, with the sign of a break."""
    places = in_shape(way, ends) or ends
    half = len(places) // 2
    (x, y), (u, v) = (places[half - 1], places[half]) if len(places) == 2 else (places[half - 1], places[half + 1])
    yield Polyline(places, "way")
    yield Symbol("break", ((x + u) / 2, (y + v) / 2), math.atan2(v - y, u - x))


def _own(drawn: Drawn, name: str) -> float:
    """The size of a body, m."""
    return extent_of([s for m in body_marks(drawn, drawn.scene.bodies[name]) for s in spots_of(m)])


def _reach(p: Later, first: Later) -> float:
    return max((math.dist(spot, first.spots[n]) for n, spot in p.spots.items() if n in first.spots), default=0.0)


def _same_way(a: float | None, b: float | None) -> bool:
    """Are two angles the same, but for whole turns?"""
    return a is None or b is None or abs(math.remainder(a - b, 2 * math.pi)) < NEAR
