"""Why an instant has no solution, by name: what contradicts what and by how much, what is open and what would close it."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.scene import Find
from planar_cli.solve.instant import Instant, Trial


def explain_failure(instant: Instant, rejected: list[Trial], finds: tuple[Find, ...]) -> NoSolution:
    """No choice of modes holds: say why for each, the first assumption in detail."""
    mark = finds[0].mark if finds else instant.scene.problem.bodies[0].mark
    clash = next((t for t in rejected if t.objection in ("velocities", "contradiction")), None)
    if clash is not None and all(t.objection in ("velocities", "contradiction") for t in rejected):
        return NoSolution(
            [Diagnostic(mark, "PL602", _clash(clash), "leave one of these out, or make its value an unknown")]
        )
    reasons = "; ".join(dict.fromkeys(t.objection for t in rejected))
    return NoSolution(
        [
            Diagnostic(
                mark, "PL601", f"no consistent case: {reasons}", "rigid bodies with dry friction may have no solution"
            )
        ]
    )


def _clash(trial: Trial) -> str:
    """The statements that contradict each other, and the remainder."""
    if trial.objection == "velocities":
        found = next(v.conflict for v in trial.velocities if v.conflict is not None)
        texts = list(dict.fromkeys(c.text for c, _ in found[0]))
        return f"these contradict each other: {'; '.join(texts)} (they differ by {_short(found[1])})"
    outcome = trial.outcomes[0]
    assert outcome.solved.conflict is not None
    factors, rest = outcome.solved.conflict
    texts = list(dict.fromkeys(s for s, f in zip(outcome.assembly.sources, factors, strict=True) if f))
    return f"these contradict each other: {'; '.join(texts)} (they differ by {_short(rest)})"


def _short(value: Decimal) -> str:
    return f"{abs(value):.4g}"
