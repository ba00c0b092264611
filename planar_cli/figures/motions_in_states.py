"""Positions, velocities and accelerations in one state, of what was worked out at an instant or as a motion."""

from __future__ import annotations

from planar_cli.errors import NoValue
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.given_motion import Found
from planar_cli.figures.polygons import with_all_numbers
from planar_cli.report.instant.at_state import placed
from planar_cli.solve.solved_problem import PartSolution


def moving_in(part: PartSolution, state: str) -> Found | None:
    """The motion in a state, with the numbers of all that is found there; "": the first one."""
    motion = part.motion
    if motion is None:
        instant = next((i for i in part.instants if i.state == state), None)
        whole = with_all_numbers(instant) if instant is not None else None
        return Found.of(Drawn.as_in_the_file(whole), (whole,)) if whole is not None else None
    state = state or motion.states[0]
    for end in (1, 0):
        for regime in motion.regimes:
            if any(stretch[end] == state for stretch in regime.stretches):
                try:
                    here = placed(regime.solution, motion, state)
                except NoValue:
                    continue
                return Found.of(Drawn(here.instant.scene, here.value, {}), (here,))
    return None
