"""Where bodies are in later states, dashed beside the position in which the file draws them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.shapes import body_marks
from planar_cli.problem.scene import Particle, Round
from planar_cli.report.blocks import line
from planar_cli.report.marks import Arc, Mark, Polyline, Spot, Symbol, Tag
from planar_cli.solve.between.trace import MotionTrace

MOST, FAR, NEAR = 3, 3.0, 0.03
"""So many further positions at most; none that would make the scene so many times larger, or is as near to another one
in parts of its size.
"""


def position_marks(drawn: Drawn, motion: MotionTrace, states: Sequence[str], size: float) -> Iterator[Mark]:
    """The bodies that move, in each state in which they are somewhere else. `size`: that of the scene as drawn, m."""
    scene = drawn.scene
    before = [{name: spot for name, body in scene.bodies.items() if (spot := drawn.spot(body.center)) is not None}]
    turned = [{name: drawn.number(body.theta) for name, body in scene.bodies.items()}]
    count = 0
    for state in states:
        there = Drawn.in_state(motion, state)
        if there is None:
            continue
        spots = {name: there.spot(there.scene.bodies[name].center) for name in before[0]}
        angles = {name: there.number(there.scene.bodies[name].theta) for name in before[0]}
        if any(s is None for s in spots.values()) or count == MOST:
            continue
        found = {name: s for name, s in spots.items() if s is not None}
        known = any(
            all(math.dist(found[n], spot) < NEAR * size for n, spot in old.items())
            and all(_same_way(angles[n], turn) for n, turn in ways.items())
            for old, ways in zip(before, turned, strict=True)
        )
        if known or _reach(found, before[0]) > FAR * size:
            continue
        before.append(found)
        turned.append(angles)
        count += 1
        yield from _dashed(there, found, before[0], angles, turned[0], state)


def _dashed(
    there: Drawn,
    found: dict[str, Spot],
    first: dict[str, Spot],
    angles: dict[str, float | None],
    ways: dict[str, float | None],
    state: str,
) -> Iterator[Mark]:
    for name, spot in found.items():
        body = there.scene.bodies[name]
        # That a disk has turned in its place is not to be seen.
        if spot == first[name] and (isinstance(body.shape, Round) or _same_way(angles[name], ways[name])):
            continue
        if isinstance(body.shape, Particle):
            yield Symbol("place", spot)
        else:
            yield from (m for m in body_marks(there, body, "hidden") if isinstance(m, Arc | Polyline))
        yield Tag(spot, line(state.replace("_", " ")))


def _reach(found: dict[str, Spot], first: dict[str, Spot]) -> float:
    return max((math.dist(spot, first[name]) for name, spot in found.items()), default=0.0)


def _same_way(a: float | None, b: float | None) -> bool:
    """Are two angles the same, but for whole turns?"""
    return a is None or b is None or abs(math.remainder(a - b, 2 * math.pi)) < NEAR
