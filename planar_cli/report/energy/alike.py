"""What is the same of several bodies is told once: moments of inertia, energies and weights of equal rods, and the
accelerations of bodies that move together, a_A = a_B = a_G = R α = 0.3651 m/s².
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from sympy import Expr

from planar_cli.report.document.blocks import Answer, Block, Equation, Text, Value, line
from planar_cli.report.document.said import letter_of
from planar_cli.report.notation.names import plain_name

OF_BODY = re.compile(r"moments? of inertia of ([\w, ]+?)(| about .*):")
"""The lead of a moment of inertia: its bodies, and about which point it is."""
SPRING, POINT = "spring ", re.compile(r"[A-Z]\d?")
WEIGHT, WEIGHTS = "weight of ", "weights of "
FULL = 4
"""So many sides has a line letter = formula = numbers = value."""


def with_equals_together(blocks: Iterable[Block]) -> list[Block]:
    """Moments of inertia that follow each other and have one formula and value stand in one line; so do other letters
    with one formula, numbers and value, but for those of answers.
    """
    blocks = list(blocks)
    told = [b for b in blocks if isinstance(b, Answer)]
    answers = frozenset(n for a in told for n in (plain_name(a.name), letter_of(a.line[:1])))
    found: list[Block] = []
    for block in blocks:
        merged = _together(found[-1], block) or _of_one_value(found[-1], block, answers) if found else None
        if merged is None:
            found.append(block)
        else:
            found[-1] = merged
    return found


def told_of_each(parts: Sequence[tuple[str, Expr | None]]) -> dict[int, str]:
    """Which of several parts are told, and of whom: those with one formula once, of each. None: a part of its own."""
    found: dict[int, str] = {}
    for i, (_, own) in enumerate(parts):
        same = [] if own is None else [k for k, (_, e) in enumerate(parts) if e == own]
        if i == min(same, default=i):
            names = ", ".join(parts[k][0] for k in same or [i])
            found[i] = f"{names}, each" if len(same) > 1 else names
    return found


def weights_of_each(sources: Sequence[tuple[str, Expr]]) -> dict[int, str]:
    """The same of what does work: `weights of AB, BC, each`, and every other source by itself."""
    own = [(w.removeprefix(WEIGHT), e if w.startswith(WEIGHT) else None) for w, e in sources]
    found = told_of_each(own)
    springs = [i for i, (w, _) in enumerate(sources) if w.startswith(SPRING)]
    if len(springs) == 1 and POINT.fullmatch(found.get(springs[0], "").removeprefix(SPRING)):
        # The only one is not called after its point.
        found[springs[0]] = SPRING.strip()
    return {
        i: names if own[i][1] is None else f"{WEIGHTS if names.endswith(', each') else WEIGHT}{names}"
        for i, names in found.items()
    }


def _together(one: Block, other: Block) -> Equation | None:
    """I_AB = I_BC = formula = value; None: they are not of one kind, or not alike."""
    if not isinstance(one, Equation) or not isinstance(other, Equation):
        return None
    mine, theirs = _of(one), _of(other)
    if mine is None or theirs is None or mine[2] != theirs[2]:
        return None
    same = len(other.sides) - 1
    if one.sides[-same:] != other.sides[1:] or one.sides[0] == other.sides[0]:
        return None
    lead = line(f"moments of inertia of {mine[1]}, {theirs[1]}{mine[2]}:")
    return replace(one, sides=(*one.sides[:-same], other.sides[0], *other.sides[1:]), lead=lead)


def _of_one_value(one: Block, other: Block, answers: frozenset[str]) -> Equation | None:
    """a_A = a_B = formula = numbers = value; None: they differ, or an answer looks for one of them."""
    if not isinstance(one, Equation) or not isinstance(other, Equation) or len(other.sides) < FULL:
        return None
    own, rest = letter_of(other.sides[0]), other.sides[1:]
    before, bare = one.sides[: -len(rest)], (None, (), ())
    if not own or not before or one.sides[-len(rest) :] != rest or not isinstance(rest[-1], Value):
        return None
    if any((b.number, b.lead, b.note) != bare for b in (one, other)):
        return None
    letters = [*map(letter_of, before), own]
    if not all(letters) or len({*letters}) < len(letters) or not answers.isdisjoint(letters):
        return None
    return replace(one, sides=(*before, *other.sides))


def _of(block: Equation) -> re.Match[str] | None:
    (lead, *more) = block.lead or (None,)
    if more or not isinstance(lead, Text) or block.number is not None or len(block.sides) < 2:
        return None
    return OF_BODY.fullmatch(lead.text)
