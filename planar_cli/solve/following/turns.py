"""How often the direction to a place has turned round since the first state, counted along the motion that is followed.

Where a place is written with an angle that goes on, its turns are in it. Elsewhere, as of a particle in x and y, the
direction alone tells no turns: (x, y) is looked at along the way, near enough that nothing turns by a radian between.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import sympy as sp

from planar_cli.equation.setup import has_quantity
from planar_cli.errors import Diagnostic, NoSolution, Undecided
from planar_cli.problem.expression import Quantity, Relation, Statement
from planar_cli.problem.scene import State
from planar_cli.solve.between.events import FollowedSegment, scale_of
from planar_cli.solve.between.solved_motion import SolvedMotion
from planar_cli.solve.regimes.regime import number_function
from planar_cli.solve.regimes.timeline import Reader, is_place_angle

LOOKS, DEEPEST, MOST = 8, 30, 100_000
"""So many looks in a characteristic time, halved so often where more happens; and so many on one stretch."""


def count_turns(found: SolvedMotion) -> None:
    """Put the whole turns into the angles of places that finds and states ask for at other states.

    NoSolution: a state gives such an angle, and the direction is reached after other turns.
    """
    if found.followed is None:
        return
    for reader in found.course.distinct_readers():
        for symbol, q in reader.winding.items():
            other, state, value = reader.pending[symbol]
            angle = _angle(found, q, state)
            turns = round((angle - math.remainder(angle, 2 * math.pi)) / (2 * math.pi))
            reader.pending[symbol] = other, state, value + 2 * sp.pi * turns
        reader.winding.clear()
    for later in found.course.states[1:]:
        for relation in later.relations:
            _demand_turns(found, later, relation)


def _demand_turns(found: SolvedMotion, state: State, relation: Statement) -> None:
    """NoSolution: an angle of a place that a state gives is not the one that was reached."""
    if not isinstance(relation, Relation) or relation.operator != "=":
        return
    reader = found.course.readers[state.name]
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if not is_place_angle(side) or side.at is not None or has_quantity(other):
            continue
        stated = float(found.value(reader.at(found.course.stops[state.name], reader.number(other))))
        angle = _angle(found, side, state.name)
        if abs(angle - stated) > 1:
            reached = f"{math.degrees(angle):.4g} deg"
            text = f"state {state.name}: `{relation.text}` holds up to whole turns only: there it is {reached}"
            hint = "angles of places count turns from the first state: give the angle that is reached"
            raise NoSolution([Diagnostic(relation.mark, "PL621", text, hint)])


def _angle(found: SolvedMotion, q: Quantity, state: str) -> float:
    """The direction to a place at a state, with its turns from the first state on."""
    assert found.followed is not None
    course = found.course
    until = float(found.value(course.stops[state].t))
    angle: float | None = None
    for segment in found.followed.segments:
        reader = next((r for r in course.distinct_readers() if r.regime is segment.regime), None)
        if reader is None or (angle is not None and segment.t0 >= until):
            break
        direction = _direction(found, reader, q, segment)
        angle = direction(segment.t0) if angle is None else angle
        angle += _turned(direction, segment, min(until, segment.t1))
    return angle or 0.0


def _direction(found: SolvedMotion, reader: Reader, q: Quantity, segment: FollowedSegment) -> Callable[[float], float]:
    """The direction of a place as a function of time along a segment, between -180 and 180 deg."""
    regime = segment.regime
    f = number_function([regime.closed(reader.number(q))], regime.letters, found.value)

    def at(t: float) -> float:
        here = segment.at(t)
        return f(*(here[s] for s in regime.letters))[0]

    return at


def _turned(direction: Callable[[float], float], segment: FollowedSegment, until: float) -> float:
    """By which angle a direction turns along a segment."""
    steps = math.ceil(LOOKS * (until - segment.t0) / scale_of(segment)) + LOOKS
    if steps > MOST:
        raise Undecided("the turns of a place are too many to be counted")
    times = [segment.t0 + (until - segment.t0) * k / steps for k in range(steps + 1)]
    angles = [direction(t) for t in times]
    return sum(_between(direction, times[k], angles[k], times[k + 1], angles[k + 1]) for k in range(steps))


def _between(
    direction: Callable[[float], float], a: float, at_a: float, b: float, at_b: float, depth: int = 0
) -> float:
    """The same between two times, halved until it is small."""
    small = math.remainder(at_b - at_a, 2 * math.pi)
    if abs(small) <= 1 or depth == DEEPEST:
        return small
    middle = (a + b) / 2
    at_middle = direction(middle)
    first = _between(direction, a, at_a, middle, at_middle, depth + 1)
    return first + _between(direction, middle, at_middle, b, at_b, depth + 1)
