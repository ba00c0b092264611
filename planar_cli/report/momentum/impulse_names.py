"""Impulses by short letters, where nothing else on the page is meant by them: J for the only J_N,hit, J_N and J_F for
J_N,ball and J_F,ball, J_Ax for J_Ax,2.
"""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.document.blocks import Answer, Block, Math, Name, Note
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.notation.names import plain_name
from planar_cli.report.words.one_name import OPENING, letter_of_answer, renamed

IMPULSE = "J"
KINDS = ("N", "F", "T")
"""Of normal forces, of friction, and of what pulls."""


def with_short_impulses(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page."""
    used = _letters([b for b in blocks if not isinstance(b, Note) or b.kind not in OPENING])
    own = sorted(x for x in used if x.split("_")[0] == IMPULSE and x != IMPULSE)
    names = _without_joint(_without_state({x: x for x in own}))
    if len(set(names.values())) == 1 and next(iter(names.values())).partition("__")[0] in {f"J_{k}" for k in KINDS}:
        names = dict.fromkeys(names, IMPULSE)
    # What an answer is told to be may have the name under which it is asked for.
    asked = {b.name for b in blocks if isinstance(b, Answer) and names.get(letter_of_answer(b.line)) != b.name}
    others = {plain_name(x) for x in (*used, *asked) if x not in names}
    distinct = len(set(names.values())) == len({*own})
    if not distinct or others & {plain_name(n) for n in names.values()}:
        return list(blocks)
    return renamed(blocks, {x: n for x, n in names.items() if n != x})


def _letters(blocks: Sequence[Block]) -> set[str]:
    """The names of all letters."""
    pieces = [p for b in blocks for p in pieces_of(b)]
    return {s.name for p in pieces if isinstance(p, Math) for s in p.expr.free_symbols} | {
        p.name for p in pieces if isinstance(p, Name)
    }


def _without_state(names: dict[str, str]) -> dict[str, str]:
    """Without the state of all of them, where it is one."""
    states = {n.partition("__")[2] for n in names.values()}
    return {x: n.partition("__")[0] for x, n in names.items()} if len(states) == 1 else names


def _without_joint(names: dict[str, str]) -> dict[str, str]:
    """Without the name of the only joint of which there are a normal impulse, a friction impulse, or one that pulls."""
    of_joints = {x: n.split("_") for x, n in names.items()}
    kinds = {x: p for x, p in of_joints.items() if len(p) > 2 and p[1] in KINDS and "" not in p}
    joints = {tuple(p[2:]) for p in kinds.values()}
    return {x: "_".join(p[:2]) if x in kinds and len(joints) == 1 else names[x] for x, p in of_joints.items()}
