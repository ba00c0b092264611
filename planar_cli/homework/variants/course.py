"""Which course the physics of a solved problem takes: its modes and events one after the other, as data to compare.

Two variants with the same finds and the same signs may still be different problems: one rolls and the other slips.
"""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.simulate.run import Simulation
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution, Solution

Course = tuple[object, ...]


def course_of(solution: Solution) -> Course:
    """Of the file and of its cases: equal where the same modes hold in the same order."""
    return tuple((part.case, *_of_part(part)) for part in solution.parts)


def _of_part(part: PartSolution) -> Iterator[object]:
    if part.followed is not None:
        yield from _followed(part.followed)
    elif part.motion is not None:
        yield from _of_motion(part.motion)
    else:
        yield from ((i.state, _modes(i)) for i in part.instants)


def _of_motion(motion: MotionTrace) -> Iterator[object]:
    """Regimes between states, and those after the last state on which an answer rests."""
    for regime in motion.regimes:
        if regime.asked or any(stop for _, stop in regime.stretches):
            yield regime.stretches, _modes(regime.solution)
    yield from (turning.state for turning in motion.turnings)


def _modes(solution: InstantSolution) -> tuple[object, ...]:
    modes = solution.trial.system.modes
    return tuple((joint, m.name, m.words, m.direction, m.side, m.where) for joint, m in sorted(modes.items()))


def _followed(simulation: Simulation) -> Iterator[object]:
    """Changes of mode and impacts; a contact that is only just touched changes nothing."""
    trajectory = simulation.run.trajectory
    yield from ((t.kind, t.joints, t.new) for t in trajectory.transitions if t.kind != "graze")
    yield trajectory.missed, trajectory.outcome.kind
