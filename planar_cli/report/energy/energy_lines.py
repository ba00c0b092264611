"""Which lines of energies and works stand before their balance: none that only repeats one of its terms, as the balance
comes in letters and with every term as a number; none that was told before of the same states.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Text
from planar_cli.solve.between.trace.trace import BalanceTrace

UNIT = "in "
"""Begins the unit in which an amount counts."""
Told = tuple[tuple[str, str], tuple[Inline | Line, ...]]
"""The states of a line, and what it says."""
FEWEST = 3
"""A line of so many sides has a formula, its numbers and its value."""


def comes_at_once(blocks: Sequence[Block], letters: Sequence[Math], told: Equation) -> bool:
    """Does a balance need no lines before it? `letters`: its sides in letters, where it starts from rest and has
    numbers as well, `told`.
    """
    return bool(letters) and all(_is_one_term(b) for b in blocks) and _has_every_term(letters, told)


def needed_lines(blocks: Sequence[Block], balance: BalanceTrace, at_once: bool, before: list[Told]) -> Iterator[Block]:
    """The lines before a balance, which may come `at_once`; `before`: what was told of which states, which grows."""
    span = (balance.since, balance.stop)
    for block in blocks:
        if isinstance(block, Equation) and len(block.sides) > FEWEST and _is_energy(block, balance):
            own = (span, block.sides[1:])
            if own in before:
                continue
            before.append(own)
        if not at_once or _is_nought(block):
            yield block


def _is_nought(block: Block) -> bool:
    return isinstance(block, Equation) and isinstance(block.sides[-1], Math) and block.sides[-1].expr == 0


def _is_energy(block: Equation, balance: BalanceTrace) -> bool:
    """Does it tell a kinetic energy or a work?"""
    first = block.sides[0]
    name = first[0] if isinstance(first, tuple) and first and not block.lead else None
    return isinstance(name, Name) and name.name.partition("__")[0] in (balance.law.letter, balance.law.bring)


def _is_one_term(block: Block) -> bool:
    """Is it an energy or a work with its formula and value, and no line of a speed, a height or a stretch?"""
    if not isinstance(block, Equation) or block.lead or not isinstance(block.sides[0], tuple):
        return False
    last = block.sides[-1]
    if isinstance(last, Math) and last.expr.has(sp.Add):
        return False
    return all(isinstance(p, Text) and p.text.startswith(UNIT) for p in block.note)


def _has_every_term(letters: Sequence[Math], told: Equation) -> bool:
    """Have both sides as many terms with numbers as with letters, and more than two in all?"""
    sides = [side for side in told.sides if isinstance(side, Math)]
    counts = [[len(sp.Add.make_args(side.expr)) for side in whole] for whole in (letters, sides)]
    return counts[0] == counts[1] and sum(counts[0]) > FEWEST
