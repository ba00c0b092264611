"""How components read. A further one of a vector that two bodies share stands behind its own words:

(4)  likewise v_D along x:   0.4 ω_QD - 0.2 ω_AB + 0.2 ω_slab = 0.8

One of a vector that the file calls by a letter has that letter: R_x = 12 N, J_floor,y = m v; of a word it is `push, x`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from planar_cli.greek import GREEK
from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, Text, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.notation.names import plain_name

LIKEWISE = "Likewise "
SHORT = 24
"""Characters of such words."""
AXES = {", x": "x", ", y": "y"}
"""What stands behind the name of a vector before its component is given."""


def with_components_beside(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page with the short words before an equation in one line with it, where no vector equation goes
    on below it, and with components by the letters of their vectors.
    """
    blocks = _by_letter(blocks)
    found: list[Block] = []
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        last = found[-1] if found else None
        goes_on = isinstance(after, Equation) and after.number is None and not after.lead
        if isinstance(last, Paragraph) and isinstance(block, Equation) and not goes_on and _leads(last, block):
            found[-1] = replace(block, lead=line(*last.line[1:]))
        else:
            found.append(block)
    return found


def _leads(words: Paragraph, equation: Equation) -> bool:
    """Is it `Likewise v_D along x:`, right before the equation?"""
    if equation.number is None or equation.lead or words.line[0] != Text(LIKEWISE):
        return False
    said = as_text(words.line)
    return len(said) <= SHORT and said.endswith(":") and " along " in said


def _by_letter(blocks: Sequence[Block]) -> Sequence[Block]:
    """R_x for `R, x`, where neither R_x nor R_y is something else on the page."""
    names = {name for b in blocks if (name := _component(b)[0]) and _is_letter(name)}
    if not names:
        return blocks
    used = {text for b in blocks for piece in pieces_of(b) for text in _names(piece)}
    free = {n for n in names if used.isdisjoint(plain_name(_of_axis(n, axis)) for axis in AXES.values())}
    return [_lettered(b) if _component(b)[0] in free else b for b in blocks]


def _component(block: Block) -> tuple[str, str]:
    """The vector and the axis of `R, x = ...`; empty where an equation gives something else."""
    side = block.sides[0] if isinstance(block, Equation) else ()
    match [p for p in side if p != Text("")] if isinstance(side, tuple) else []:
        case [Name(name), Text(text)] if text in AXES:
            return name, AXES[text]
    return "", ""


def _lettered(block: Block) -> Block:
    assert isinstance(block, Equation)
    return replace(block, sides=(line(Name(_of_axis(*_component(block)))), *block.sides[1:]))


def _of_axis(name: str, axis: str) -> str:
    """R_x of R, in the state that R has."""
    own, state, at = name.partition("__")
    return f"{own}_{axis}{state}{at}"


def _is_letter(name: str) -> bool:
    """R, F_A or J_floor, which are no words and no components themselves."""
    stem, *pieces = name.partition("__")[0].split("_")
    return (len(stem) == 1 or stem in GREEK) and not {*AXES.values()} & {*pieces}


def _names(piece: Any) -> list[str]:
    """The names in a piece of a page as they are printed."""
    if isinstance(piece, Name):
        return [plain_name(piece.name)]
    return [plain_name(s.name) for s in getattr(getattr(piece, "expr", None), "free_symbols", ())]
