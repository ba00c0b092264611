"""Which telling of numbers a stage of equations gets: that of an instant, or of a motion in which nothing varies."""

from __future__ import annotations

from collections.abc import Collection

from planar_cli.report.equations.numeric import NumericTelling
from planar_cli.report.in_numbers.spelled import is_spelled
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage


def numeric_telling(phrases: Phrases, constants: Phrases | None, stages: Collection[Stage]) -> NumericTelling:
    """Where nothing in the equations of a motion varies, and letters would hide units, they have numbers as those of an
    instant do. `constants`: speaks of what has a number all the time.
    """
    if constants is None or not lasts(stages, constants):
        return NumericTelling(phrases, stages)
    if is_spelled(stages, phrases):
        return NumericTelling(phrases, stages, constants)
    return NumericTelling(constants, stages)


def lasts(stages: Collection[Stage], constants: Phrases) -> bool:
    """Are all symbols in the equations that are told of a motion the same all the time?"""
    blocks = [b for s in stages for b in s.blocks]
    told = [w.residual for b in blocks for w in b.equations] + [x.formula for b in blocks for x in b.lines]
    told += [x.expression for s in stages for x in s.lines]
    return bool(told) and all(constants.value.known(x) is not None for e in told for x in e.free_symbols)
