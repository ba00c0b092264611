"""The whole orbit of a particle that is drawn to a point at rest by the inverse square of its distance: an ellipse with
that point at its focus.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from planar_cli.figures.motions_in_states import moving_in
from planar_cli.figures.shapes import moved
from planar_cli.figures.smooth import smooth
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.marks import Mark, Polyline, Spot
from planar_cli.solve.solved_problem import PartSolution

STEPS = 120
NEAR = 1e-6
LONGEST = 0.97
"""An ellipse with a greater eccentricity is far larger than what a scene shows of it."""
SAME = 0.01
"""What is nearer to an orbit, in parts of its size, is on it."""
APART = 0.01
"""Distances that differ by less tell no law."""


def on_orbits(marks: Sequence[Mark], part: PartSolution) -> Iterator[Mark]:
    """The marks of a scene with the orbits of all particles in all states of a motion, each once and whole, in place of
    the ways that are parts of them.
    """
    drawn: list[tuple[Spot, ...]] = []
    motion = part.motion
    for name in [b.name for b in motion.problem.bodies if b.is_particle] if motion is not None else ():
        for state in motion.states if motion is not None else ():
            way = orbit(part, name, state)
            if way and not any(_is_on(way, other) for other in drawn):
                drawn.append(way)
    for mark in marks:
        if not (isinstance(mark, Polyline) and mark.style == "way" and any(_is_on(mark.places, o) for o in drawn)):
            yield mark
    yield from (Polyline(way, "way") for way in drawn)


def _is_on(way: Sequence[Spot], orbit_: Sequence[Spot]) -> bool:
    """Does a way run along an orbit?"""
    near = SAME * max(math.dist(orbit_[0], s) for s in orbit_)
    return all(min(_beside(s, a, b) for a, b in pairwise(orbit_)) < near for s in way[:: max(len(way) // 12, 1)])


def _beside(spot: Spot, start: Spot, end: Spot) -> float:
    """How far a place is from a short piece of a curve."""
    around = math.dist(spot, start) + math.dist(spot, end) - math.dist(start, end)
    return math.sqrt(max(around * math.dist(start, end), 0.0) / 2)


def orbit(part: PartSolution, name: str, state: str) -> tuple[Spot, ...]:
    """Places along the orbit on which a particle is in a state; none: it is on none, or it does not come back."""
    here, found = _seen(part, name, state), _attraction(part, name)
    if here is None or found is None:
        return ()
    (at, (vx, vy), _), ((cx, cy), strength) = here, found
    x, y = at[0] - cx, at[1] - cy
    far, turn = math.hypot(x, y), x * vy - y * vx
    # The vector that points to the pericentre; its size is the eccentricity.
    ex, ey = vy * turn / strength - x / far, -vx * turn / strength - y / far
    e, along = math.hypot(ex, ey), math.atan2(ey, ex)
    if e > LONGEST or abs(turn) < NEAR * far * math.hypot(vx, vy):
        return ()
    parameter = turn**2 / strength

    def there(share: float) -> Spot:
        way = 2 * math.pi * share
        return moved((cx, cy), way, parameter / (1 + e * math.cos(way - along)))

    return smooth(there, STEPS)


def _seen(part: PartSolution, name: str, state: str) -> tuple[Spot, Spot, Spot] | None:
    """Place, velocity and acceleration of a particle in a state; None: nothing tells them."""
    moving = moving_in(part, state)
    body = moving.drawn.scene.bodies.get(name) if moving is not None else None
    if moving is None or body is None:
        return None
    at, v, a = moving.drawn.spot(body.center), moving.vector("v", name), moving.vector("a", name)
    return (at, v, a) if at is not None and v is not None and a is not None else None


def _attraction(part: PartSolution, name: str) -> tuple[Spot, float] | None:
    """The centre, and the acceleration at the distance one [m³/s²]; None: it does not fall with the square of the
    distance in all states, or nothing tells that.
    """
    motion = part.motion
    loads = [load for load in motion.problem.loads if load.kind == "force"] if motion is not None else []
    pulls = [str(getattr(load, "towards", "")) for load in loads]
    first = moving_in(part, motion.states[0]) if motion is not None and len(pulls) == 1 else None
    centre = first.drawn.named(pulls[0]) if first is not None and pulls[0] in first.drawn.scene.points else None
    if motion is None or first is None or centre is None or first.drawn.scene.owner(pulls[0]) != GROUND:
        return None
    strengths, distances = [], []
    for state in motion.states:
        here = _seen(part, name, state)
        if here is None:
            continue
        (x, y), (ax, ay) = (here[0][0] - centre[0], here[0][1] - centre[1]), here[2]
        far, size = math.hypot(x, y), math.hypot(ax, ay)
        if abs(x * ay - y * ax) > NEAR * far * size or x * ax + y * ay >= 0:
            return None
        strengths.append(size * far**2)
        distances.append(far)
    apart = bool(distances) and max(distances) > (1 + APART) * min(distances)
    return (centre, strengths[0]) if apart and max(strengths) < (1 + NEAR) * min(strengths) else None
