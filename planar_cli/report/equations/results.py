"""How results of one instant are led in: the numbers of their equations, and the roots that were not taken."""

from __future__ import annotations

import re
from collections.abc import Sequence
from decimal import Decimal
from itertools import chain
from typing import Any

from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.problem.implied.not_negative import distances
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.friction.assumed import broken_by
from planar_cli.report.words.sides import said
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.instant import OPPOSED
from planar_cli.solve.solution import InstantSolution

SIGNS = {">=": "≥", "<=": "≤"}
"""Inequalities in the notation of the page; all others as they are written."""
OTHER_ROOTS, BEFORE_REASON = "other roots: ", " ("
LIKEWISE, NUMBERED, RUN = "Likewise ", re.compile(r"\((\d+)\)"), re.compile(r"\((\d+)\) to \((\d+)\)")
"""Begins a sentence that stands for equations; a number of one; the first and the last of several."""
SAME = Decimal("1e-20")
"""Roots of one equation, found twice with sixty digits, agree to this part of them."""


def other_roots(instant: InstantSolution, x: SolvedLine, phrases: Phrases) -> list[Block]:
    """The roots that were not taken, with the reason. Of a direction that is given, that a root would turn it round is
    not worth saying.
    """
    sought = instant.sought
    choice = next((c for c in sought.branch.choices if c.symbol == x.symbol), None) if sought is not None else None
    if choice is None or len(choice.roots) < 2:
        return []
    left = [r for i, r in enumerate(choice.roots) if i != choice.taken]
    if phrases.symbolic:
        return _formulas(instant, x, left, choice, phrases)
    own = choice.roots[choice.taken].value
    free = not any(c.objection for c in instant.left_out if _root_of(c, x) == 1 - choice.taken)
    if len(left) == 1 and left[0].value == -own and free and _is_speed(instant, x):
        return [_opposite(phrases.shown(x.symbol, left[0].value), own > 0)]
    reason = _reason(instant, choice, phrases)
    if not reason:
        return []
    parts: list[Any] = [OTHER_ROOTS]
    for i, root in enumerate(left):
        parts += [", " if i else "", phrases.shown(x.symbol, root.value)]
    return [Paragraph(line(*parts, BEFORE_REASON, reason, ")"))]


def _is_speed(instant: InstantSolution, x: SolvedLine) -> bool:
    return x.symbol in instant.trial.system.tree.velocity_unknowns()


def _root_of(other: Any, x: SolvedLine) -> int | None:
    """Which root a branch takes."""
    return next((c.taken for c in other.branch.choices if c.symbol == x.symbol), None)


def _opposite(other: Any, positive: bool) -> Paragraph:
    """Nothing tells the two senses of a motion apart."""
    told = "; the positive one is taken" if positive else ""
    return Paragraph(line("The other root, ", other, f", is the same motion the opposite way{told}."))


def _formulas(instant: InstantSolution, x: SolvedLine, left: list[Any], choice: Any, phrases: Phrases) -> list[Block]:
    """Of letters only the speed of a motion the other way is said."""
    if not _is_speed(instant, x) or len(left) != 1 or left[0].expression is None:
        return []
    if not identically_zero(left[0].expression + x.formula):
        return []
    return [_opposite(phrases.math(left[0].expression), choice.roots[choice.taken].value > 0)]


def _reason(instant: InstantSolution, choice: Any, phrases: Phrases) -> Line:
    """What rules the other roots out, each by the branch that is like the one taken but for this root. The branches of
    another limit, or of the same limit on the other side, have roots of their own.
    """
    taken = {c.symbol: c.taken for c in instant.sought.branch.choices} if instant.sought is not None else {}
    nearest: dict[int, tuple[int, Line]] = {}
    for other in instant.left_out:
        roots = {c.symbol: c for c in other.branch.choices}
        own = _same_root(choice, roots.get(choice.symbol))
        apart = sum(c.taken != taken.get(s) for s, c in roots.items())
        if own is not None and own != choice.taken and (own not in nearest or apart < nearest[own][0]):
            turned = other.objection.endswith(OPPOSED)
            nearest[own] = (apart, () if turned else _objection(other, phrases) or _of_size(instant, choice, own))
    lost = {i for i in range(len(choice.roots)) if i != choice.taken} - nearest.keys()
    reasons = sorted({why for _, why in nearest.values() if why}, key=str)
    reasons += [line("with it the other equations have no solution")] * bool(lost)
    return line(*(part for i, why in enumerate(reasons) for part in ("; " if i else "", why)))


def _same_root(choice: Any, other: Any) -> int | None:
    """Which of the roots another branch takes; None: one of its own."""
    if other is None:
        return None
    value = other.roots[other.taken].value
    near = (abs(r.value - value) <= SAME * max(abs(r.value), abs(value)) for r in choice.roots)
    return next((i for i, agrees in enumerate(near) if agrees), None)


def _of_size(instant: InstantSolution, choice: Any, own: int) -> Line:
    """Why a root is left out against which nothing in the file speaks: a distance is not negative; else how the one
    that is taken differs from it.
    """
    taken, other = (choice.roots[i].value for i in (choice.taken, own))
    if other < 0 < taken and choice.symbol.name in distances(instant.instant.scene.problem):
        return line("a distance is not negative")
    if taken * other < 0:
        return line(f"it holds as well; the {'positive' if taken > 0 else 'negative'} one is taken")
    return line(f"it holds as well; the {'smaller' if abs(taken) < abs(other) else 'larger'} one is taken")


def _objection(other: Any, phrases: Phrases) -> Line:
    """Why a branch is left out; an inequality of the file in the notation of the page."""
    if not other.objection:
        return ()
    broken = other.trial.broken
    if other.trial.tests and other.objection == other.trial.objection:
        return broken_by(other.trial, phrases) or line(other.objection)
    if broken is None or broken.words != other.objection:
        return line(other.objection)
    left, right = said(broken.relation.left, phrases.figures), said(broken.relation.right, phrases.figures)
    if left is None or right is None:
        return line(other.objection)
    return line("given: ", left, f" {SIGNS.get(broken.relation.operator, broken.relation.operator)} ", right)


def numbered(numbers: Sequence[int]) -> str:
    """Equations by their numbers: (1), (3); of three or more in a row (2) to (5)."""
    runs: list[list[int]] = []
    for n in sorted(numbers):
        if runs and n == runs[-1][-1] + 1:
            runs[-1].append(n)
        else:
            runs.append([n])
    told = [f"({r[0]}) to ({r[-1]})" if len(r) > 2 else ", ".join(f"({n})" for n in r) for r in runs]
    return ", ".join(told)


def told_by_others(block: Block) -> list[int]:
    """The numbers of the equations for which a sentence stands: `Likewise the components of a_C, a_D: (5) to (8).`"""
    first = block.line[0] if isinstance(block, Paragraph) and block.line else None
    if not isinstance(block, Paragraph) or not isinstance(first, Text) or not first.text.startswith(LIKEWISE):
        return []
    said = "".join(p.text for p in block.line if isinstance(p, Text))
    within = [range(int(low), int(high) + 1) for low, high in RUN.findall(said)]
    return sorted({*map(int, NUMBERED.findall(said)), *chain.from_iterable(within)})


def value_told(block: Block) -> Line:
    """`U of the weight = 3.924 J`: what an equation tells, without the way; (): it tells no value of a letter."""
    if not isinstance(block, Equation) or len(block.sides) < 2 or block.relation != "=":
        return ()
    first, last = (side if isinstance(side, tuple) else (side,) for side in (block.sides[0], block.sides[-1]))
    named = isinstance(first[0], Name) if first else False
    letter = len(first) == 1 and isinstance(first[0], Math) and getattr(first[0].expr, "is_Symbol", False)
    unit = (" ", *block.note) if block.note and getattr(block.note[0], "text", "").startswith("in ") else ()
    return line(first, " = ", last, *unit) if named or letter else ()
