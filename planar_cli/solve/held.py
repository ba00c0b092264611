"""The outcome of one instant that holds, worked out; where several do, all of them are told."""

from __future__ import annotations

from planar_cli.problem.scene.scene import Find
from planar_cli.solve.diagnosis.any_mass import demand_cancelled
from planar_cli.solve.diagnosis.cases import several_cases
from planar_cli.solve.diagnosis.clash import demand_drawn
from planar_cli.solve.diagnosis.failures import place
from planar_cli.solve.diagnosis.open_data import demand_determined, demand_passable
from planar_cli.solve.instant.drawn_senses import in_evident_sense, turning_as_loaded
from planar_cli.solve.instant.finish import Finisher
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.solution import Found, InstantSolution


def outcome_that_holds(
    instant: Instant,
    held: list[Trial],
    rejected: tuple[Trial, ...],
    finds: tuple[Find, ...],
    units: dict[str, str],
    state: str,
) -> tuple[InstantSolution, list[Found]]:
    """The one outcome that holds, worked out; of several all are reported."""
    demand_determined(instant, held[0], finds)
    demand_passable(instant, held[0], finds)
    solutions = []
    if len(held) == 1:
        turned = turning_as_loaded(instant, held[0])
        held = [in_evident_sense(instant, turned, Finisher(instant, turned, (), units, state).asked(finds))]
    for trial in held:
        try:
            solutions.append(Finisher(instant, trial, rejected, units, state).solve(finds))
        except Disagreement:
            demand_drawn(instant, trial)
            raise
    if len(held) > 1:
        raise several_cases(instant, held, [found for _, found in solutions], place(instant, finds))
    demand_cancelled(instant.scene, finds, solutions[0][1])
    return solutions[0]
