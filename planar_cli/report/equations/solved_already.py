"""Which equations of an instant solve themselves: data, zeros at sight, unknown = formula."""

from __future__ import annotations

from planar_cli.report.equations.numeric import DIFFERENTIATED
from planar_cli.report.notation.notation import plain
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written


def is_given(block: SolvedBlock) -> bool:
    """Is the block nothing but a datum of the file? One that tells an unknown by something else has to be solved."""
    return all(w.given for w in block.equations) and set(block.unknowns) <= {w.left for w in block.equations}


def is_told(block: SolvedBlock, stage: Stage) -> bool:
    """Has a relation said at sight that the unknown of the block is zero?"""
    return set(block.unknowns) <= set(stage.zero)


def is_written(w: Written, found: SolvedLine, phrases: Phrases) -> bool:
    """Does an equation stand as unknown = formula?"""
    solved = (found.symbol, phrases.neat(found.formula))
    either = [phrases.writer.sides(s * w.left, s * w.right, w.source == DIFFERENTIATED) for s in (1, -1)]
    if any(solved in (sides, sides[::-1]) for sides in either):
        return True
    # The same formula may be put together in two ways that read alike.
    read = [side for sides in either for one, side in (sides, sides[::-1]) if one == found.symbol]
    return any(plain(side) == plain(solved[1]) for side in read)
