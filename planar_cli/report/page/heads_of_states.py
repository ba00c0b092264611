"""One heading over what is told of a state: `At launch:` once over both components of a velocity, and the condition of
a state over all that is told there, which else stood once without it and once with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import takewhile

from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, Text

AT = "At "


def with_states_headed_once(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part."""
    return _with_shared_leads(_with_one_condition(blocks))


def _with_shared_leads(blocks: Sequence[Block]) -> list[Block]:
    """`At launch:` before each of several lines that follow each other as a heading over them."""
    found: list[Block] = []
    i = 0
    while i < len(blocks):
        block = blocks[i]
        lead = block.lead if isinstance(block, Equation) and block.number is None else ()
        run = list(_alike(blocks[i:], lead))
        if len(run) > 1 and _is_of_state(lead):
            found += [Paragraph(lead), *(replace(b, lead=()) for b in _by_axes(run))]
            i += len(run)
        else:
            found.append(block)
            i += 1
    return found


def _alike(blocks: Sequence[Block], lead: Line) -> Iterator[Equation]:
    """The lines with which blocks begin that have this before them, and no number."""
    for block in blocks:
        if not isinstance(block, Equation) or block.number is not None or block.lead != lead:
            return
        yield block


def _by_axes(run: Sequence[Equation]) -> Sequence[Equation]:
    """Two components of one vector, that along x first."""
    names = [b.sides[0].expr.name if isinstance(b.sides[0], Math) and b.sides[0].expr.is_Symbol else "" for b in run]
    one, other = names if len(names) == len("xy") else ("", "")
    stem, axis, state = one.partition("y_" if "y_" in one else "y")
    return run[::-1] if axis and f"{stem}{axis.replace('y', 'x')}{state}" == other else run


def _with_one_condition(blocks: Sequence[Block]) -> list[Block]:
    """`At parallel:`, some lines, and `At parallel, v_y = -3/4 v_x:` as the second alone, over all of them."""
    found = list(blocks)
    for i, block in enumerate(blocks):
        state = _state(block)
        if not state:
            continue
        stop = next((k for k in range(i + 1, len(found)) if not _is_result(found[k])), len(found))
        if stop < len(found) and stop > i + 1 and _words(found[stop]).startswith(f"{AT}{state}, "):
            found[i : stop + 1] = [found[stop], *found[i + 1 : stop]]
            return _with_one_condition(found)
    return found


def _state(block: Block) -> str:
    """The state of a heading that says nothing else; "" of any other block."""
    words = _words(block)
    return words[len(AT) : -1] if words.startswith(AT) and words.endswith(":") and "," not in words else ""


def _is_result(block: Block) -> bool:
    return isinstance(block, Equation) and block.number is None


def _words(block: Block) -> str:
    """The words with which a sentence begins; "" of any other block."""
    line = block.line if isinstance(block, Paragraph) else ()
    return "".join(p.text for p in takewhile(lambda p: isinstance(p, Text), line) if isinstance(p, Text))


def _is_of_state(lead: Line) -> bool:
    return bool(lead) and isinstance(lead[0], Text) and lead[0].text.startswith(AT)
