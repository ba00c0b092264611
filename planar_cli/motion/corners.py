"""A corner between two surfaces that a body passes over: rounded, so that it keeps its speed.

Where one surface ends and another begins, what slides or rolls over the corner is turned round by normal forces alone;
they do no work. As long as there is one way left to move, its kinetic energy tells the speed beyond the corner:

    Σ m v² is the same before and after,  v after along the one way that the joints leave

Where several ways are left, or nothing goes on along the new surface, nothing is rounded. A blow at a corner is a state
`just after`.

Reference: An Introduction to Planar Dynamics, 3.3: ideal constraints do no work.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.joints.base import Joint
from planar_cli.motion.automaton import Choice, Corner
from planar_cli.motion.constraints import Constraint
from planar_cli.motion.dense import null_space
from planar_cli.motion.hybrid import HybridModel
from planar_cli.motion.source import compiled
from planar_cli.problem.facts import Mode
from planar_cli.problem.scene import GROUND

MISSED = 1e-9
"""A velocity that the new surface leaves as it is up to this part of the speeds is not turned."""
ONWARD = 1e-6
"""Where less than this part of the energy is that of a motion along the new surface, the body runs against it."""


def passing_over(before: HybridModel, after: HybridModel, begun: Sequence[Joint], ended: Sequence[Joint]) -> list[str]:
    """The joints that guide on a body which another one has guided up to now, by name."""
    left = {body for joint in ended if joint.guides for body in _guided(before, joint)}
    return [joint.name for joint in begun if joint.guides and _guided(after, joint) & left]


def _guided(model: HybridModel, joint: Joint) -> set[str]:
    """Which bodies a joint guides."""
    joinings = (j for mode in model.modes[joint.name] for j in mode.facts.joinings)
    return {body for j in joinings for body in (j.mover, j.base)} - {GROUND}


def corner(model: HybridModel, choice: Choice, begun: Sequence[str], t: float, y: Sequence[float]) -> Corner | None:
    """A corner that is passed over; None: nothing is turned there, or it is not told how. `begun`: the joints that
    guide from there on.
    """
    velocities = _beyond(model, choice, begun, t, y)
    return None if velocities is None else Corner(tuple(begun), (*y[: model.layout.count], *velocities))


def _beyond(
    model: HybridModel, choice: Choice, begun: Sequence[str], t: float, y: Sequence[float]
) -> list[float] | None:
    """The velocities there; None: nothing is turned, or they are not told."""
    held = list(_held(model, choice, begun))
    numbers = iter(_numbers(model, held, t, y))
    count = model.layout.count
    masses = [next(numbers) for _ in range(count)]
    rows: list[list[float]] = []
    for constraint in held:
        row = [0.0] * count
        for i in constraint.row:
            row[i] = next(numbers)
        rows.append(row)
    if any(next(numbers) for _ in held):
        # A surface that moves does work.
        return None
    within = sorted(_linked(model, rows, [c.joint in begun for c in held]))
    own = [[row[i] for i in within] for row in rows if any(row[i] for i in within)]
    velocities = list(y[count:])
    ways = null_space(own, len(within))
    if len(ways) != 1 or not _forbidden(own, [velocities[i] for i in within]):
        return None
    way, weights = ways[0], [masses[i] for i in within]
    energy = sum(m * velocities[i] ** 2 for i, m in zip(within, weights, strict=True))
    size = sum(m * n * n for m, n in zip(weights, way, strict=True))
    onward = sum(m * n * velocities[i] for i, m, n in zip(within, weights, way, strict=True))
    if size <= 0.0 or onward**2 <= ONWARD * size * energy:
        return None
    speed = math.copysign(math.sqrt(energy / size), onward)
    for i, n in zip(within, way, strict=True):
        velocities[i] = speed * n
    return velocities


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


def _numbers(model: HybridModel, held: Sequence[Constraint], t: float, y: Sequence[float]) -> Sequence[float]:
    terms = [s.mass for s in model.layout.slots]
    terms += [x for c in held for x in c.row.values()]
    terms += [c.moving for c in held]
    found: Sequence[float] = compiled(terms, model.layout.state, model.layout.time).function(t, y)
    return found


def _linked(model: HybridModel, rows: Sequence[Sequence[float]], begun: Sequence[bool]) -> set[int]:
    """The velocities of the bodies that what begins there guides, and of all that joints link with them."""
    frames = model.layout.frames.values()
    groups = [{i for i in (f.x, f.y, f.theta) if i is not None} for f in frames]
    linked = [{i for i, x in enumerate(row) if x} for row in rows]
    inside: set[int] = {i for row, here in zip(linked, begun, strict=True) if here for i in row}
    while more := {i for group in (*groups, *linked) if group & inside for i in group} - inside:
        inside |= more
    return inside


def _forbidden(rows: Sequence[Sequence[float]], velocities: Sequence[float]) -> bool:
    """Does anything that the joints keep forbid the velocities?"""
    for row in rows:
        parts = [a * v for a, v in zip(row, velocities, strict=True)]
        reach = math.hypot(*row) * math.hypot(*velocities)
        if abs(sum(parts)) > MISSED * reach:
            return True
    return False
