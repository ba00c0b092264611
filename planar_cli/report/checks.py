"""What was checked, in short phrases: residuals, the independent road, the assumptions of contacts."""

from __future__ import annotations

from planar_cli.report.blocks import Check, Line, Math, Relation, Value, line
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.worked import unknowns_of

MOST_PRESSES = 4


def check_blocks(instant: InstantSolution, phrases: Phrases) -> list[Check]:
    """The checks of one instant, each a phrase."""
    found = [Check(line(text)) for text in instant.checks.get("lines", ())]
    return [*found, *(Check(p) for p in _presses(instant, phrases))] if found else []


def _presses(instant: InstantSolution, phrases: Phrases) -> list[Line]:
    """N > 0 of each contact, and |F| against its limit where a contact sticks."""
    if not instant.trial.outcomes:
        return []
    system, outcome = instant.trial.system, instant.trial.outcomes[0]
    if phrases.symbolic or not any(b.mass != 0 for b in system.scene.bodies.values()):
        return []
    values = {**unknowns_of(system, outcome), **instant.value.values}
    found: list[Line] = []
    for mode in system.modes.values():
        rolling = any(j.rolling is not None for j in mode.facts.joinings)
        for push in mode.facts.pushes:
            symbol = system.symbols.get(push.name)
            if symbol is None or symbol not in values or not (mode.tests or rolling):
                continue
            column = outcome.assembly.columns.get(push.name)
            if column is None or not outcome.solved.unique(column):
                continue
            if push.kind == "normal" and values[symbol] > 0:
                found.append(
                    line(Relation(Math(symbol), "=", Value(values[symbol], push.unit, phrases.figures)), " > 0")
                )
    return found[:MOST_PRESSES]
