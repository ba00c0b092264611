"""What begins to slide at this instant, in a direction that only its motion would tell."""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.equation.kinematics.moving import open_direction
from planar_cli.errors import undecided_at
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.scene.scene import Find
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.regimes.after import CONTINUOUS


def demand_direction(trial: Trial, finds: Iterable[Find]) -> None:
    """Undecided: what is asked rests on friction whose direction is not told. That it slides is told, as places and
    velocities are.
    """
    system = trial.system
    skids = system.skids()
    asked = [f for f in finds if any(q.word not in {*CONTINUOUS, "mode"} for q in quantities_in(f.found.what))]
    if not skids or not asked or system.motion is None:
        return
    words = open_direction(system.scene, system.motion, trial.outcomes[0].value, skids)
    if words:
        raise undecided_at(asked[0].mark, words)
