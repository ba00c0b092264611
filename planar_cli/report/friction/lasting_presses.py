"""That bodies stay in contact through a part of a motion, as their constant force pushes: N_ram = m_1 (g + a_P) > 0."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.friction.presses import sum_of_forces
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import parse_unit

STAY = "stay in contact"
"""Ends what is assumed of two bodies that may part."""


def lasting_presses(instants: Sequence[InstantSolution], phrases: Phrases) -> Iterator[Line]:
    """The normal forces of such contacts, where they are constant. `phrases`: of the motion, in which constants have
    values.
    """
    for instant in instants:
        system = instant.trial.system
        for mode in system.modes.values():
            for push in mode.facts.pushes if mode.tests and mode.words.endswith(STAY) else ():
                symbol = system.symbols.get(push.name)
                formula = next(sum_of_forces(instant, push, symbol), None) if symbol is not None else None
                varies = formula is None or bool(formula.free_symbols & phrases.lettered)
                number = None if varies else phrases.value.known(formula)
                if formula is not None and push.kind == "normal" and number is not None and number > 0:
                    shown = phrases.of_dimension(number, parse_unit(push.unit).dimension)
                    yield line(Math(symbol), " = ", phrases.math(formula), " = ", shown, " > 0")
