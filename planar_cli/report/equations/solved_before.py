"""An equation that an earlier part of a motion has solved, with the same result, is its result, with where it stands:

(10)  ↑ ΣF_y:   N = 29.72 N               as (4)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from planar_cli.report.document.blocks import Block, Equation, Math, Text, Value, line


def solved_before(blocks: Sequence[Block], before: Iterable[Block]) -> list[Block]:
    """The blocks of a part. `before`: those of earlier ones, as they were before this was done to them."""
    earlier = dict(reversed([(_written(e), (e, r)) for e, r in _solved(list(before))]))
    known = {id(e): (r, earlier[_written(e)]) for e, r in _solved(blocks) if _written(e) in earlier}
    again = {own: (r, e) for own, (r, (e, first)) in known.items() if r.sides == first.sides}
    gone = {id(r) for r, _ in again.values()}
    found: list[Block] = []
    for block in blocks:
        if id(block) in again and isinstance(block, Equation):
            result, first = again[id(block)]
            sides = result.sides[0], result.sides[-1]
            found.append(replace(block, sides=sides, note=line(f"as ({first.number})")))
        elif id(block) not in gone:
            found.append(block)
    return found


def _solved(blocks: Sequence[Block]) -> Iterator[tuple[Equation, Equation]]:
    """Equations with their only results: one letter by each alone, with its value."""
    by_lead = {_lead(b): b for b in blocks if isinstance(b, Equation) and b.number is None and b.lead}
    for block in blocks:
        if isinstance(block, Equation) and block.number is not None and not block.note:
            result = by_lead.get(f"({block.number}):")
            if result is not None and not result.note and _is_value(result):
                yield block, result


def _is_value(result: Equation) -> bool:
    first, last = result.sides[0], result.sides[-1]
    return isinstance(first, Math) and first.expr.is_Symbol and isinstance(last, Value) and len(result.sides) > 2


def _written(equation: Equation) -> str:
    """What it says, whatever its number."""
    return repr(replace(equation, number=None))


def _lead(equation: Equation) -> str:
    return "".join(p.text if isinstance(p, Text) else "?" for p in equation.lead)
