"""Impulses of a blow that are zero: by the file, as a line before the equations that do without them, or as nothing
acts along them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution


def in_blow(found: SpanIntegral) -> bool:
    """Is it all of one blow, so that no time runs?"""
    return bool(found.pieces) and all(p.how == "blow" for p in found.pieces)


def nil_of_blow(found: SpanIntegral) -> sp.Symbol | None:
    """The impulse of a blow that the file says is zero; None: it says something else."""
    (piece, *more) = found.pieces or (None,)
    if piece is None or more or not in_blow(found) or found.number != 0:
        return None
    return piece.integrand if piece.integrand.is_Symbol else None


def nil_impulses(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """What the file says of a blow: the hands feel none, so that the impulse at the grip is zero."""
    for impulse, since, until in said_nil(found):
        lead = line(f"no impulse in the blow from {since} to {until}, as given:")
        yield Equation((phrases.math(impulse), line("0")), None, lead)


def said_nil(found: MotionTrace) -> Iterator[tuple[sp.Symbol, str, str]]:
    """The impulses that the file says are zero, with the states before and after their blow."""
    asked = {p for r in found.requests for p in r.parts}
    # An impulse that follows from the laws of the blow was not given.
    derived = {s for leg in found.route.steps if not leg.is_datum for s in leg.unknowns}
    for span in found.spans:
        if (impulse := nil_of_blow(span)) is not None and span.symbol not in asked and impulse not in derived:
            yield impulse, span.pieces[0].since, span.pieces[0].until


def nil_beside(solution: InstantSolution, stage: Stage, used: Collection[sp.Symbol]) -> set[sp.Symbol]:
    """The impulses that are zero, as nothing else acts along them, and that are in no equation. `used`: the letters of
    all equations of blows, and of what is asked.
    """
    reactions = solution.trial.system.reactions
    assert reactions is not None
    inside = {s for block in stage.blocks for w in block.equations for s in w.residual.free_symbols} | {*used}
    return {e for _, e in reactions.pushes if e.is_Symbol and e not in inside and solution.value.known(e) == 0}
