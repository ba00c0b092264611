"""A terminal speed before the data that the file gives by it: v_end, then v_t = v_end and v_nearly = 0.95 v_t."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.solve.between.trace.trace import RouteStep
from planar_cli.solve.law import Law


def terminal_first(
    given: Sequence[RouteStep], derived: Sequence[RouteStep]
) -> tuple[tuple[RouteStep, ...], Law | None]:
    """The data that the terminal speed rests on, and a law that has it; nothing where no datum is told by it."""
    laws = (e.law for leg in derived for e in leg.relations if e.law is not None)
    law = next((own for own in laws if own.terminal is not None), None)
    if law is None or law.terminal is None:
        return (), None
    letter, formula, _ = law.terminal
    if not any(r.formula is not None and r.formula.has(letter) for leg in given for r in leg.results):
        return (), None
    return tuple(leg for leg in given if leg.unknowns == (formula,)), law
