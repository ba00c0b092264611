"""Moments of one group of bodies after the other, each of which holds the one before: the first ones are told, and of
the others what is added each time, and about which point. In numbers, their rows stand where they are solved.

CD, DE, moments about C:
  (12)  ↺ ΣM_C:   …
Likewise with BC as well, about B; then AB about A; then OA about O: (13) to (15), collected further down.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import chain, pairwise

from planar_cli.report.document.blocks import Block, Line, Name, Paragraph, line
from planar_cli.report.equations.results import LIKEWISE, numbered
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written

TOLD, LEAST = 2, 3
"""So many equations are told, if there are at least so many others."""


def grown(block: SolvedBlock, stage: Stage) -> tuple[Written, ...]:
    """The equations of a block that are told by the first ones."""
    written = block.equations
    if len(written) < TOLD + LEAST or len(block.letters) < 2:
        return ()
    if any(w.law != "moment" or w.lead in stage.centres for w in written):
        return ()
    return written[TOLD:] if all(set(a.bodies) < set(b.bodies) for a, b in pairwise(written)) else ()


def told_groups(
    written: Sequence[Written],
    stage: Stage,
    tell: Callable[[Written, Stage], Sequence[Block]],
    number: Callable[[Stage, int], int],
    is_row: Callable[[Written, Stage], bool] | None,
) -> Iterator[Block]:
    """The blocks that tell equations, with one sentence in place of those that are told by the ones before them.
    `is_row`: does an equation stand collected in numbers further down? None: all stay in letters.
    """
    alike = {w.number for b in stage.blocks for w in grown(b, stage) if is_row is None or is_row(w, stage)}
    added: list[Line] = []
    numbers: list[int] = []
    for before, w in zip((None, *written), written, strict=False):
        if w.number in alike and before is not None:
            new = " and ".join(b for b in w.bodies if b not in before.bodies)
            head = line("; then ", new) if added else line(f"{LIKEWISE}with ", new, " as well,")
            added.append(line(*head, " about ", Name(w.lead)))
            numbers.append(number(stage, w.number))
            continue
        yield from _likewise(added, numbers, is_row is not None)
        added, numbers = [], []
        yield from tell(w, stage)
    yield from _likewise(added, numbers, is_row is not None)


def _likewise(added: Sequence[Line], numbers: Sequence[int], rows: bool) -> Iterator[Block]:
    if added:
        below = ", collected further down" if rows else ""
        yield Paragraph(line(*chain.from_iterable(added), f": {numbered(numbers)}{below}."))
