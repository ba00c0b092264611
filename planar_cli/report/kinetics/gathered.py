"""The parts of m a_G along one axis as one arrow, where a diagram has more than two: what is the same but for its sign
is one letter there too. Of two equal rods that fold alike, with α_BC = -α_AB and ω_BC = -ω_AB, in line

    BC:  …  =  1/2 m l α_AB ↑ at G_BC,  3/2 m l ω_AB² ← at G_BC,  I_BC α_AB ↻
    ↺ ΣM_B:   N_C l - 1/2 m g l = 1/2 m l α_AB · l/2 - I_BC α_AB = 1/6 m l² α_AB
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Block, Equation, Forces, Line, Math, Name, Text, line
from planar_cli.report.kinetics.entries import BETWEEN, listed
from planar_cli.report.kinetics.raw_moments import MINUS, PLUS
from planar_cli.report.words.words import Phrases

OPPOSITE = {"↑": "↓", "→": "←", "↺": "↻"} | {"↓": "↑", "←": "→", "↻": "↺"}
MOST, TIMES = 2, " · "
"""Of so few arrows each stays by itself."""
TURNS = "↺↻"
Known = Mapping[sp.Symbol, sp.Expr]


def gathered(blocks: Sequence[Block], known: Known, phrases: Phrases) -> list[Block]:
    """The blocks with such rows, and with the sums of moments in which these parts stand. `known`: α_BC = -α_AB."""
    if not known:
        return list(blocks)
    rows = {b.body: _row(b, known, phrases) for b in blocks if isinstance(b, Forces)}
    if all(rows[b.body] == b for b in blocks if isinstance(b, Forces)):
        return list(blocks)
    return [rows[b.body] if isinstance(b, Forces) else _equation(b, known, phrases) for b in blocks]


def _row(row: Forces, known: Known, phrases: Phrases) -> Forces:
    entries = _entries(row.right)
    if entries is None or len([e for e in entries if e[1].text.strip()[:1] not in TURNS]) <= MOST:
        return row
    found: list[tuple[sp.Expr, Text]] = []
    for size, arrow in ((expr.xreplace(dict(known)), arrow) for expr, arrow in entries):
        place = next((i for i, (_, a) in enumerate(found) if _sense(a, arrow)), None)
        if place is None:
            found.append((size, arrow))
        else:
            sum_, own = found[place]
            found[place] = (simplified(sum_ + _sense(own, arrow) * size), own)
    signed = (_positive(size, arrow) for size, arrow in found if size != 0)
    return replace(row, right=listed((phrases.math(size), arrow) for size, arrow in signed))


def _entries(side: Line) -> list[tuple[sp.Expr, Text]] | None:
    """Sizes with their arrows; None: the row is told otherwise."""
    pieces = [p for p in side if p != BETWEEN]
    pairs = zip(pieces[::2], pieces[1::2], strict=False)
    plain = [(size.expr, arrow) for size, arrow in pairs if isinstance(size, Math) and isinstance(arrow, Text)]
    return plain if 2 * len(plain) == len(pieces) else None


def _sense(one: Text, other: Text) -> int:
    """1 for arrows along one axis at one place, -1 for opposite ones; 0: they are not along one axis."""
    first, *rest = one.text.split()
    second, *others = other.text.split()
    if first not in OPPOSITE or rest != others:
        return 0
    # Of a group of bodies each has a couple of its own.
    if first in TURNS and one.way is not None and other.way is not None and one.way.place != other.way.place:
        return 0
    return 1 if first == second else -1 if OPPOSITE[first] == second else 0


def _positive(size: sp.Expr, arrow: Text) -> tuple[sp.Expr, Text]:
    """The opposite arrow for what has a minus."""
    told = arrow.text.split()[0]
    if not size.could_extract_minus_sign() or told not in OPPOSITE:
        return size, arrow
    way = arrow.way
    if way is not None and way.direction is not None:
        way = replace(way, direction=-way.direction)
    return -size, replace(arrow, text=arrow.text.replace(told, OPPOSITE[told]), way=way)


def _equation(block: Block, known: Known, phrases: Phrases) -> Block:
    """A sum of moments with the terms of equal arms together."""
    if not isinstance(block, Equation) or len(block.sides) < MOST + 1:
        return block
    if not any(isinstance(p, Name) and p.name.startswith("ΣM") for p in block.lead):
        return block
    left, middle, *rest = block.sides
    terms = _terms(middle) if isinstance(middle, tuple) else None
    if terms is None:
        return block
    arms: dict[sp.Expr, sp.Expr] = {}
    for force, arm in terms:
        arms[arm] = arms.get(arm, sp.S.Zero) + force.xreplace(dict(known))
    kept = {arm: simplified(force) for arm, force in arms.items()}
    # Couples of equal bodies that turn opposite ways are nothing together.
    kept = {a: f for a, f in kept.items() if a != 1 or simplified(f.xreplace(dict(phrases.ledger.definitions))) != 0}
    return replace(block, sides=(left, _sum([(f, a) for a, f in kept.items() if f != 0], phrases), *rest))


def _terms(side: Line) -> list[tuple[sp.Expr, sp.Expr]] | None:
    """Forces, signed, with their arms, as a sum of moments is put together; None: it is told otherwise."""
    found: list[tuple[sp.Expr, sp.Expr]] = []
    sign, arm = 1, False
    for piece in side:
        if isinstance(piece, Text) and piece.text in (PLUS, MINUS, "-"):
            sign, arm = (1 if piece.text == PLUS else -1), False
        elif isinstance(piece, Text) and piece.text.startswith(TIMES):
            arm = True
        elif isinstance(piece, Math) and piece.values is None:
            found = [*found[:-1], (found[-1][0], piece.expr)] if arm else [*found, (sign * piece.expr, sp.S.One)]
        elif not (isinstance(piece, Text) and piece.text in (")", "")):
            return None
    return found


def _sum(terms: Sequence[tuple[sp.Expr, sp.Expr]], phrases: Phrases) -> Line:
    told: list[Any] = []
    # What is positive comes first.
    for force, arm in sorted(terms, key=lambda t: t[0].could_extract_minus_sign()):
        negative = force.could_extract_minus_sign()
        told += [MINUS if negative and told else "-" if negative else PLUS if told else ""]
        told.append(phrases.math(-force if negative else force))
        if arm != 1:
            told += [" · (", phrases.math(arm), ")"] if arm.is_Add else [TIMES, phrases.math(arm)]
    return line(*(t for t in told if t != ""))
