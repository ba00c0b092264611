"""Where a body that moves is drawn: in a position of its motion, not far from where that begins.

Forces and accelerations that turn with a body are printed with an arrow. That of a ball which slides down the right
side of a dome is not that of one on its left side: the position must be one that the body passes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

WAY = Decimal("0.41")
"""So much of the way from one state to the next: half-way a body may be in a special position."""
TURN = Decimal("0.35")
"""Nothing is drawn turned by more than this, rad: the figure stays like the one of the file."""

Place = Mapping[sp.Symbol, Decimal]


def place_drawn(motion: MotionTrace, instant: InstantSolution) -> Valuation | None:
    """The numbers of a position between the first two states of a regime that differ; None: there are none."""
    units, project = motion.ledger.units, instant.instant.scene.ledger.project
    for since, stop in motion.regime(instant).stretches:
        start, end = _at(motion, since), _at(motion, stop)
        both = [s for s in start if s in end]
        moved = [s for s in both if start[s] != end[s] and units[s].text not in ("s", "m/s", "rad/s")]
        if since == stop or not moved:
            continue
        angles = [abs(end[s] - start[s]) for s in moved if units[s].angle]
        way = min([WAY, *(TURN / angle for angle in angles)])
        value = instant.value.extended(motion.value.values)
        value = value.extended({s: start[s] + way * (end[s] - start[s]) for s in both})
        if project is None:
            return value
        try:
            return value.extended(project(value))
        except ArithmeticError:
            return None
    return None


def place_of_rest(motion: MotionTrace, instant: InstantSolution) -> Valuation:
    """The numbers of an equilibrium, in which is drawn what is told of small deviations from it: a spring pulls along
    the line in which it lies there.
    """
    ((state, _),) = set(motion.regime(instant).stretches)
    return place_at(motion, instant, state)


def place_at(motion: MotionTrace, instant: InstantSolution, state: str) -> Valuation:
    """The numbers of one state."""
    return instant.value.extended(motion.value.values).extended(_at(motion, state))


def _at(motion: MotionTrace, state: str) -> Place:
    """The numbers of the general position at a state."""
    return dict(_numbers(motion, state))


def _numbers(motion: MotionTrace, state: str) -> Iterator[tuple[sp.Symbol, Decimal]]:
    roles, followed = motion.ledger.roles, motion.followed or {}
    for own, general in motion.general.items():
        if roles[own].at != state:
            continue
        number = motion.value.known(own)
        if number is None and own in followed:
            number = Decimal(followed[own])
        if number is not None and number.is_finite():
            yield general, number
