"""A corner between two surfaces that a body passes over: rounded, so that it keeps its speed.

Where one surface ends and another begins, what slides or rolls over the corner is turned round by normal forces alone;
they do no work. As long as there is one way left to move, its kinetic energy tells the speed beyond the corner:

    Σ m v² is the same before and after,  v after along the one way that the joints leave

A wheel goes on turning as it did: no normal force of its rim turns it. Where several ways are left along which normal
forces act, or nothing goes on along the new surface, nothing is rounded. A blow at a corner is a state
`just after`.

Reference: An Introduction to Planar Dynamics, 3.3: ideal constraints do no work.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from planar_cli.joints.base import Joint
from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.dense import null_space
from planar_cli.motion.terms.layout import Column
from planar_cli.motion.terms.source import compiled
from planar_cli.motion.trajectory.automaton import Choice, Corner
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.scene import GROUND

MISSED = 1e-9
"""A velocity that the new surface leaves as it is up to this part of the speeds is not turned."""
STUCK = 1e-6
"""What rolls on beyond the corner misses that by less than this part of the speeds."""
ONWARD = 1e-6
"""Where less than this part of the energy is that of a motion along the new surface, the body runs against it."""

Vectors = Sequence[Sequence[float]]


def passing_over(before: HybridModel, after: HybridModel, begun: Sequence[Joint], ended: Sequence[Joint]) -> list[str]:
    """The joints that guide on a body which another one has guided up to now, by name."""
    left = {body for joint in ended if joint.guides for body in _guided(before, joint)}
    return [joint.name for joint in begun if joint.guides and _guided(after, joint) & left]


def _guided(model: HybridModel, joint: Joint) -> set[str]:
    """Which bodies a joint guides."""
    joinings = (j for mode in model.modes[joint.name] for j in mode.facts.joinings)
    return {body for j in joinings for body in (j.mover, j.base)} - {GROUND}


def corner(
    model: HybridModel, choice: Choice, begun: Sequence[str], left: Sequence[Column], t: float, y: Sequence[float]
) -> Corner | None:
    """A corner that is passed over; None: nothing is turned there, or it is not told how. `begun`: the joints that
    guide from there on; `left`: how the normal forces act of those that end there.
    """
    velocities = _beyond(model, choice, begun, left, t, y)
    return None if velocities is None else Corner(tuple(begun), (*y[: model.layout.count], *velocities))


def normals(model: HybridModel, joints: Iterable[Joint]) -> list[Column]:
    """How the forces of joints that guide act, all but friction: along what they forbid where nothing sticks."""
    found = []
    for joint in joints:
        held = model.held(joint, _sliding(model.modes[joint.name], 0))
        found += [held.columns[p.name] for p in held.pushes if p.kind != "friction"]
    return found


def _beyond(
    model: HybridModel, choice: Choice, begun: Sequence[str], left: Sequence[Column], t: float, y: Sequence[float]
) -> list[float] | None:
    """The velocities there; None: nothing is turned, or they are not told."""
    held = list(_held(model, choice, begun))
    begins = normals(model, [j for j in model.joints if j.name in begun])
    masses, moving, rows = _numbers(model, held, [*(c.row for c in held), *begins, *left], t, y)
    if any(moving):
        # A surface that moves does work.
        return None
    whole, ahead, behind = rows[: len(held)], rows[len(held) : len(rows) - len(left)], rows[len(rows) - len(left) :]
    within = sorted(_linked(model, whole, [c.joint in begun for c in held]))

    def own(rows: Iterable[Sequence[float]]) -> list[list[float]]:
        return [[row[i] for i in within] for row in rows if any(row[i] for i in within)]

    keeps = [row for row, c in zip(whole, held, strict=True) if c.joint not in begun] + ahead
    velocities, weights = list(y[model.layout.count :]), [masses[i] for i in within]
    now = [velocities[i] for i in within]
    if not _forbidden(own(keeps), now, MISSED):
        return None
    turned = _turned(now, weights, null_space(own(keeps), len(within)), null_space(own([*keeps, *behind]), len(within)))
    if turned is None or _forbidden(own(whole), turned, STUCK):
        # What does not roll yet, and is to roll there, needs more than normal forces.
        return None
    for i, v in zip(within, turned, strict=True):
        velocities[i] = v
    return velocities


def _turned(
    velocities: Sequence[float], weights: Sequence[float], ways: Vectors, untouched: Vectors
) -> list[float] | None:
    """The velocities once normal forces have turned them; None: they are not told. `ways`: along which it may move
    beyond the corner; `untouched`: those of them along which no normal force acts on the way round it.
    """

    def product(a: Sequence[float], b: Sequence[float]) -> float:
        return sum(m * p * q for m, p, q in zip(weights, a, b, strict=True))

    def split(v: Sequence[float]) -> tuple[list[float], list[float]]:
        """What of it goes along the ways that are left alone, and the rest."""
        along = [0.0] * len(v)
        for way in alone:
            share = product(v, way)
            along = [a + share * w for a, w in zip(along, way, strict=True)]
        return along, [a - b for a, b in zip(v, along, strict=True)]

    alone: list[list[float]] = []
    if len(ways) != len(untouched) + 1:
        return None
    for vector in untouched:
        rest = split(vector)[1]
        size = product(rest, rest)
        if size <= 0.0:
            return None
        alone.append([x / math.sqrt(size) for x in rest])
    stays, rest = split(velocities)
    energy = product(rest, rest)
    way = max((split(w)[1] for w in ways), key=lambda w: product(w, w))
    size, onward = product(way, way), product(rest, way)
    if size <= 0.0 or onward**2 <= ONWARD * size * energy:
        return None
    speed = math.copysign(math.sqrt(energy / size), onward)
    return [a + speed * b for a, b in zip(stays, way, strict=True)]


def _held(model: HybridModel, choice: Choice, begun: Sequence[str]) -> Iterator[Constraint]:
    """What the joints keep beyond the corner; those that begin there keep what they keep of what slides."""
    indices = model.chosen(choice)
    for joint in model.joints:
        modes = model.modes[joint.name]
        index = _sliding(modes, indices[joint.name]) if joint.name in begun else indices[joint.name]
        yield from model.held(joint, index).constraints
    yield from model.drives


def _sliding(modes: Sequence[Mode], otherwise: int) -> int:
    """The mode in which it slides; else the other one."""
    return next((i for i, m in enumerate(modes) if m.direction and not m.parted), otherwise)


def _numbers(
    model: HybridModel, held: Sequence[Constraint], columns: Sequence[Column], t: float, y: Sequence[float]
) -> tuple[list[float], list[float], list[list[float]]]:
    """The masses, what moves of what is held, and these columns, each for every velocity."""
    terms = [*(s.mass for s in model.layout.slots), *(c.moving for c in held)]
    terms += [x for column in columns for x in column.values()]
    numbers = iter(compiled(terms, model.layout.state, model.layout.time).function(t, y))
    count = model.layout.count
    masses, moving = [next(numbers) for _ in range(count)], [next(numbers) for _ in held]
    rows: list[list[float]] = []
    for column in columns:
        row = [0.0] * count
        for i in column:
            row[i] = next(numbers)
        rows.append(row)
    return masses, moving, rows


def _linked(model: HybridModel, rows: Sequence[Sequence[float]], begun: Sequence[bool]) -> set[int]:
    """The velocities of the bodies that what begins there guides, and of all that joints link with them."""
    frames = model.layout.frames.values()
    groups = [{i for i in (f.x, f.y, f.theta) if i is not None} for f in frames]
    linked = [{i for i, x in enumerate(row) if x} for row in rows]
    inside: set[int] = {i for row, here in zip(linked, begun, strict=True) if here for i in row}
    while more := {i for group in (*groups, *linked) if group & inside for i in group} - inside:
        inside |= more
    return inside


def _forbidden(rows: Vectors, velocities: Sequence[float], least: float) -> bool:
    """Does anything that the joints keep forbid the velocities, by more than this part of them?"""
    for row in rows:
        parts = [a * v for a, v in zip(row, velocities, strict=True)]
        reach = math.hypot(*row) * math.hypot(*velocities)
        if abs(sum(parts)) > least * reach:
            return True
    return False
