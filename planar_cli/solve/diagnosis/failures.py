"""Why an instant has no solution, by name: what contradicts what and how much, what is open and what would close it."""

from __future__ import annotations

from planar_cli.errors import Diagnostic, Mark, NoSolution
from planar_cli.problem.scene.scene import Find
from planar_cli.solve.diagnosis.cases import no_case
from planar_cli.solve.diagnosis.clash import BLAMED, clash
from planar_cli.solve.diagnosis.open_data import at_change_point, at_dead_centre, open_velocities
from planar_cli.solve.diagnosis.placed import not_held_at
from planar_cli.solve.diagnosis.words import false_words
from planar_cli.solve.instant.inequalities import Broken
from planar_cli.solve.instant.instant import OPEN, Instant, Trial


def place(instant: Instant, finds: tuple[Find, ...]) -> Mark:
    """Where a diagnosis points when nothing nearer is to blame."""
    return finds[0].mark if finds else instant.scene.problem.bodies[0].mark


def explain_failure(instant: Instant, rejected: list[Trial], finds: tuple[Find, ...]) -> NoSolution:
    """No choice of modes holds: say why."""
    mark = place(instant, finds)
    still_open = next((t for t in rejected if t.objection == OPEN), None)
    if still_open is not None:
        return NoSolution([open_velocities(instant, still_open, mark)])
    false = [t.broken for t in rejected if t.broken is not None]
    if false:
        return NoSolution([_false(instant, false)])
    blamed = [t for t in rejected if t.objection in BLAMED]
    if blamed and len(blamed) == len(rejected):
        trial = blamed[0]
        found = at_dead_centre(instant, trial, mark) if trial.objection == "velocities" else None
        found = found or at_change_point(instant, trial, mark)
        if found is None and (lack := not_held_at(instant, trial)) is not None:
            return lack
        return NoSolution([found or clash(instant, trial, mark)])
    return NoSolution([no_case(instant, rejected, mark)])


def _false(instant: Instant, found: list[Broken]) -> Diagnostic:
    """Everything would hold, but for inequalities of the file."""
    text = "; ".join(dict.fromkeys(false_words(instant, f.relation, f.left, f.right) for f in found))
    return Diagnostic(found[0].relation.mark, "PL617", text, "leave it out, or change what its sides rest on")


def singular_position(instant: Instant, rejected: list[Trial], finds: tuple[Find, ...]) -> None:
    """Raise at a change point, where the velocities alone do not say how the linkage goes on."""
    trial = next((t for t in rejected if t.objection == OPEN), None)
    found = None if trial is None else at_change_point(instant, trial, place(instant, finds))
    if found is not None:
        raise NoSolution([found])
