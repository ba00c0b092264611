"""A motion that begins with an infinite acceleration, as it is divided by a speed that is zero: constant power from
rest. It is followed from a slight speed, of which what follows knows nothing: the square of it is below all rounding.
"""

from __future__ import annotations

from dataclasses import replace

from planar_cli.motion.follow.stages import SceneStages
from planar_cli.motion.follow.transition import Moment, Resolved, resolve
from planar_cli.motion.regime.model import Model
from planar_cli.motion.terms.source import compiled
from planar_cli.motion.trajectory.automaton import Start
from planar_cli.motion.trajectory.trajectory import Trajectory

UNBOUNDED = "PL719"
DEPARTS = 1e-6
"""The slight speed, in parts of the scale of speeds."""
UNLIKE = 0.7
"""Coordinates depart the less the later they stand, so that no two of them cancel."""
WORDS = "an acceleration is infinite at the start; it is followed from a slight speed"


def begins_unbounded(trajectory: Trajectory) -> bool:
    """Is the motion refused at its very beginning, as an acceleration is infinite there?"""
    return trajectory.outcome.code == UNBOUNDED and not trajectory.segments


def departing(stages: SceneStages, model: Model, start: Start, first: str, tolerance: float) -> Start | None:
    """The start with slight speeds to the side to which it is driven: it gains speed, and no magnitude of a force is
    negative; where both sides will do, along the axes. None: it gains speed on neither.
    """
    automaton, half, t = stages.automaton((first,)), model.layout.count, start.t
    magnitudes = [w.magnitude for wrenches in model.wrenches.values() for w in wrenches if w.kind == "force"]
    sizes = compiled(magnitudes, model.layout.state, model.layout.time).function
    usual = model.scale[half:]
    found: list[tuple[bool, Start]] = []
    for sense in (1, -1):
        speeds = [
            v + sense * DEPARTS * s * UNLIKE**i for i, (v, s) in enumerate(zip(start.y[half:], usual, strict=True))
        ]
        choice = start.choice or (0,) * len(automaton.choices)
        beside = tuple(model.regime().project(t, [*start.y[:half], *speeds]))
        stages.begin(t, beside)
        there = resolve(Moment(automaton, t, beside, choice, "", tolerance))
        if not isinstance(there, Resolved):
            continue
        rates = automaton.regime(there.choice).rates(t, there.state)[half:]
        gains = sum(v * a / s**2 for v, a, s in zip(there.state[half:], rates, usual, strict=True))
        if gains > 0:
            pushed = all(size >= 0 for size in sizes(t, there.state))
            found.append((pushed, replace(start, y=there.state, assumed=(*start.assumed, WORDS))))
    return next((s for pushed, s in found if pushed), found[0][1] if found else None)
