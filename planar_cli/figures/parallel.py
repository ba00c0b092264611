"""Ropes all of whose parts run in one direction, `along: 90 deg`: their pulleys are drawn so wide, and what hangs on
them so far aside, that the parts are parallel. The file leaves the sizes of such pulleys out: nothing rests on them.

Across that direction every part of a rope is at one place: where it leaves a stop is where it comes to the next one.
These equations are solved with the least change of what the file draws.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from dataclasses import fields, replace

import sympy as sp

from planar_cli.figures.drawn import AS_WRITTEN, Beside, Drawn
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.rings import extent_of
from planar_cli.joints.base import Joint
from planar_cli.motion.scene.carried import Place
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Line, Round
from planar_cli.problem.scene.sketches import Cord, Slide
from planar_cli.records import record
from planar_cli.report.document.marks import Spot

FIRM, ALIKE, SHEAVE = 1e4, 2.0, 0.1
"""How much more than to move a body it costs to bend a rope; to have pulleys of unlike sizes; to have one of several
wheels of a body aside.
"""
LEAST, NEAR = 0.03, 1e-4
"""The least radius of a pulley in parts of the scene; how far off a rope may run, in the same."""


@record
class _Stop:
    """A stop of a rope. `base`: its place across the rope in the file, m; `side`: on which side of its centre the rope
    comes (0: it ends here, or runs straight on); `owner`: the body or fixed point with which it moves; `sheave`: by
    which name its wheel stands beside that, where a rope runs over several of one body; `radius`: if it has one.
    """

    base: float
    owner: str
    side: int = 0
    sheave: tuple[str, int] | None = None
    radius: float | None = None


@record
class _Rope:
    """`across`: the direction in which places across it are told."""

    name: str
    across: float
    stops: tuple[_Stop, ...]


def with_parallel_ropes(drawn: Drawn, joints: Sequence[Joint]) -> Drawn:
    """The scene with what hangs on such ropes drawn beside its place. `joints`: those of the whole file."""
    return drawn_beside(drawn, parallel(drawn, joints))


def parallel(drawn: Drawn, joints: Sequence[Joint]) -> Beside:
    """By how much what hangs on such ropes is drawn beside its place."""
    ropes = [rope for joint in joints if (rope := _rope(drawn, joint)) is not None]
    beside = AS_WRITTEN
    for across in sorted({r.across for r in ropes}):
        alike = [r for r in ropes if r.across == across]
        size = extent_of(drawn.everything()) or 1.0
        held = _held(drawn, [*joints, *drawn.scene.problem.loads], {r.name for r in alike}, across)
        firm = held | {s.owner for r in alike for s in r.stops if _is_fixed(drawn, s.owner)}
        found = _solved(alike, firm, size) or _solved(alike, held, size)
        if found is not None:
            way = (math.cos(across), math.sin(across))
            moves = {name: (m * way[0], m * way[1]) for name, m in found[0].items() if abs(m) > NEAR * size}
            sheaves = {name: (m * way[0], m * way[1]) for name, m in found[1].items()}
            beside = Beside({**beside.moves, **moves}, {**beside.sheaves, **sheaves})
    return beside


def drawn_beside(drawn: Drawn, beside: Beside) -> Drawn:
    """A position with bodies and fixed points so far beside their places."""
    if not beside.moves:
        return replace(drawn, beside=beside) if beside is not AS_WRITTEN else drawn
    scene = copy(drawn.scene)
    by = {name: Vec(*(sp.Rational(f"{part:.9g}") for part in move)) for name, move in beside.moves.items()}
    owners = {name: drawn.scene.owner(name) for name in scene.points}
    keys = {name: name if owner == GROUND else owner for name, owner in owners.items()}
    scene.points = {n: p + by[k] if (k := keys[n]) in by else p for n, p in scene.points.items()}
    scene.bodies = {n: replace(b, center=b.center + by[n]) if n in by else b for n, b in scene.bodies.items()}
    return Drawn(scene, drawn.value, drawn.here, beside)


def moving_beside(scene: MovingScene, beside: Beside) -> MovingScene:
    """A scene that moves with bodies and fixed points so far beside their places."""
    if not beside.moves:
        return scene
    found, names = copy(scene), [p.name for p in scene.problem.points if scene.owner(p.name) == GROUND]
    fixed = {n: scene.point(n) + Vec(*map(scene.graph.number, beside.moves[n])) for n in names if n in beside.moves}
    found.places = {n: _moved(scene, place, beside.moves.get(n)) for n, place in scene.places.items()}
    # What goes with bodies is told anew by their places.
    found._points = {**{n: scene.point(n) for n in names}, **fixed}
    return found


def _moved(scene: MovingScene, place: Place, by: Spot | None) -> Place:
    return place if by is None else replace(place, x=place.x + by[0], y=place.y + by[1])


def _rope(drawn: Drawn, joint: Joint) -> _Rope | None:
    """A rope with one direction, in numbers; None: it has none, or nobody knows where it is."""
    for cord in sketch_of(drawn, joint):
        along = drawn.angle(cord.along) if isinstance(cord, Cord) and cord.along is not None else None
        if not isinstance(cord, Cord) or along is None:
            continue
        spots = [drawn.spot(s.rim or s.center) for s in cord.stops]
        places = [s for s in spots if s is not None]
        if len(places) < len(spots):
            return None
        across = round(math.remainder(along - math.pi / 2, math.pi), 9)
        aside = [x * math.cos(across) + y * math.sin(across) for x, y in places]
        ahead = [y * math.cos(across) - x * math.sin(across) for x, y in places]
        owners = [s.name if s.body == GROUND else s.body for s in cord.stops]
        stops = []
        for i, owner in enumerate(owners):
            turns = 0 < i < len(owners) - 1 and (ahead[i - 1] - ahead[i]) * (ahead[i + 1] - ahead[i]) > 0
            side = _side(aside, i) if turns else 0
            sheave = (joint.name, i) if turns and owners[1:-1].count(owner) > 1 else None
            stops.append(_Stop(aside[i], owner, side, sheave, _radius(drawn, owner) if turns else None))
        return _Rope(joint.name, across, tuple(stops))
    return None


def _side(aside: Sequence[float], i: int) -> int:
    """On which side of a wheel a rope comes to it: on that of the stop before, if the one after is not there too."""
    ahead = aside[i + 1] - aside[i - 1] or aside[-1] - aside[0]
    return -1 if ahead >= 0 else 1


def _radius(drawn: Drawn, owner: str) -> float | None:
    body = drawn.body(owner)
    return drawn.length(body.shape.radius) if body is not None and isinstance(body.shape, Round) else None


def _is_fixed(drawn: Drawn, owner: str) -> bool:
    return drawn.body(owner) is None


def _held(drawn: Drawn, entries: Sequence[Entry], ropes: set[str], across: float) -> set[str]:
    """The bodies and fixed points that cannot be drawn elsewhere: something else than these ropes, and tracks that are
    parallel to them, is there.
    """
    scene, found = drawn.scene, set[str]()
    for entry in entries:
        slides = [s for s in sketch_of(drawn, entry) if isinstance(s, Slide)]
        ways = [drawn.angle(s.along) for s in slides if s.grounded and not s.drawn]
        parallel = bool(ways) and all(w is not None and abs(math.cos(w - across)) < NEAR for w in ways)
        if entry.name not in ropes and not parallel:
            found |= {n if (owner := scene.owner(n)) == GROUND else owner for n in _named(entry)}
    found |= {s.shape.through for s in scene.problem.surfaces if isinstance(s.shape, Line)}
    return found


def _named(entry: Entry) -> Iterator[str]:
    """The names in the keys of a joint or load."""
    for own in fields(entry):
        value = getattr(entry, own.name)
        for part in value if isinstance(value, tuple) else (value,):
            told = (part, getattr(part, "name", None), getattr(part, "body", None))
            yield from (n for n in told if isinstance(n, str) and n)


def _solved(
    ropes: Sequence[_Rope], held: set[str], size: float
) -> tuple[Mapping[str, float], Mapping[tuple[str, int], float]] | None:
    """By how much bodies and points are drawn aside, and sheaves beside their bodies; None: parts of a rope cannot be
    parallel so.
    """
    tight: set[int] = set()
    while True:
        system = _System(ropes, held, LEAST * size, frozenset(tight))
        found = system.solution()
        narrow = {k for k in system.wheels if found[k] < LEAST * size * (1 - NEAR)} - tight
        if not narrow:
            return system.told(found) if system.is_met(found, NEAR * size) else None
        tight |= narrow


class _System:
    """The equations, row by row, in the moves of owners, the places of sheaves and the radii of wheels."""

    def __init__(self, ropes: Sequence[_Rope], held: set[str], least: float, tight: frozenset[int]) -> None:
        self.ropes = ropes
        self.places: dict[object, int] = {}
        self.wheels: list[int] = []
        self.rows: list[tuple[dict[int, float], float, float]] = []
        moving = dict.fromkeys(s.owner for r in ropes for s in r.stops if s.owner not in held)
        for owner in moving:
            self._row({self._at(owner): 1.0}, 0.0, 1.0)
        mean = self._at("mean radius")
        for rope in ropes:
            for i, stop in enumerate(rope.stops):
                if stop.side:
                    self._wheel(stop, self._at((rope.name, i, "radius")), mean, least, tight)
        for owner in dict.fromkeys(s.owner for r in ropes for s in r.stops if s.sheave is not None):
            self._balanced(owner)
        self.links = [self._link(r, i) for r in ropes for i in range(len(r.stops) - 1)]
        self.rows += [(row, value, FIRM) for row, value in self.links]

    def _at(self, name: object) -> int:
        return self.places.setdefault(name, len(self.places))

    def _row(self, row: dict[int, float], value: float, weight: float) -> None:
        self.rows.append((row, value, weight))

    def _wheel(self, stop: _Stop, own: int, mean: int, least: float, tight: frozenset[int]) -> None:
        self.wheels.append(own)
        if stop.radius is not None or own in tight:
            self._row({own: 1.0}, least if stop.radius is None else stop.radius, FIRM)
        else:
            self._row({own: 1.0, mean: -1.0}, 0.0, ALIKE)
        if stop.sheave is not None:
            self._row({self._at(stop.sheave): 1.0, **self._moves(stop.owner, -1.0)}, 0.0, SHEAVE)

    def _balanced(self, owner: str) -> None:
        """A body with several wheels is in their middle."""
        stops = [s for r in self.ropes for s in r.stops if s.sheave is not None and s.owner == owner]
        middle = {self._at(s.sheave): 1.0 / len(stops) for s in stops}
        self._row({**middle, **self._moves(owner, -1.0)}, 0.0, FIRM / 10)

    def _moves(self, owner: str, factor: float) -> dict[int, float]:
        return {self.places[owner]: factor} if owner in self.places else {}

    def _link(self, rope: _Rope, i: int) -> tuple[dict[int, float], float]:
        """Where a part of a rope leaves its stop less where it comes to the next one is 0."""
        row, value = dict[int, float](), 0.0
        for k, sign, comes in ((i, 1.0, -1), (i + 1, -1.0, 1)):
            stop = rope.stops[k]
            value -= sign * stop.base
            place = {self.places[stop.sheave]: sign} if stop.sheave is not None else self._moves(stop.owner, sign)
            wheel = {self._at((rope.name, k, "radius")): sign * comes * stop.side} if stop.side else {}
            for part in (place, wheel):
                row |= {key: row.get(key, 0.0) + factor for key, factor in part.items()}
        return row, value

    def solution(self) -> list[float]:
        """The unknowns, by least squares."""
        import numpy as np

        matrix, right = np.zeros((len(self.rows), len(self.places))), np.zeros(len(self.rows))
        for i, (row, value, weight) in enumerate(self.rows):
            right[i] = weight * value
            for key, factor in row.items():
                matrix[i, key] = weight * factor
        return [float(x) for x in np.linalg.lstsq(matrix, right, rcond=None)[0]]

    def is_met(self, found: Sequence[float], near: float) -> bool:
        """Does every part of a rope run straight, with wheels of some size?"""
        off = (abs(sum(found[k] * f for k, f in row.items()) - value) for row, value in self.links)
        return all(o < near for o in off) and all(found[k] > 0 for k in self.wheels)

    def told(self, found: Sequence[float]) -> tuple[Mapping[str, float], Mapping[tuple[str, int], float]]:
        """The moves of owners, and how far sheaves are beside them."""
        moves = {o: found[k] for o, k in self.places.items() if isinstance(o, str) and o != "mean radius"}
        sheaves = {
            s.sheave: found[self.places[s.sheave]] - moves.get(s.owner, 0.0)
            for r in self.ropes
            for s in r.stops
            if s.sheave is not None
        }
        return moves, sheaves
