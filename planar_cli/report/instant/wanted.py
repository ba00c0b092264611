"""The unknowns of an instant of which the derivation is told."""

from __future__ import annotations

from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def needed_of(part: PartSolution, instant: InstantSolution, why: str | None) -> frozenset[str] | None:
    """The unknowns of an instant that are told: of a motion only those on which it rests. `why`: the name of the find
    for which alone it is told.
    """
    if part.motion is None:
        return letters_asked(part, why)
    from planar_cli.report.instant.at_state import is_told_at_states

    regime = part.motion.regime(instant)
    return regime.resting if is_told_at_states(part.motion, regime) else regime.wanted


def letters_asked(part: PartSolution, why: str | None) -> frozenset[str] | None:
    """The names of the symbols that the wanted find rests on directly; None: everything."""
    if why is None:
        return None
    found = next(f for f in part.found if f.name == why)
    return frozenset(s.name for e in found.asked for s in e.free_symbols)
