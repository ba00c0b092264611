"""Small oscillations whose linear equation an earlier case had: neither drawn nor derived again.

case light:  θ̈ + 3 c θ̇/(4 m) + 3 k θ/m = 0
As in case light, with c = 0 and δ a small deviation from the equilibrium rest:
             δ̈ + 3 k δ/m = 0
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, identically_zero
from planar_cli.report.document.as_printed import read_alike
from planar_cli.report.document.blocks import Block, Equation, Heading, Line, Math, Paragraph, Text, Value, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.equations.steps import KINETICS
from planar_cli.report.oscillation.linearised import DEVIATION
from planar_cli.report.oscillation.near_rest import SOLVED
from planar_cli.report.oscillation.oscillation import CRITICAL
from planar_cli.report.oscillation.small_motion import LINEAR
from planar_cli.report.repeats.repeats import CASE
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solved_problem import PartSolution

CITED = re.compile(r"\(\d+\)")
KINEMATICS, STEP = "Kinematic analysis", "STEP"
SUFFIX = "_ddot"
FIRST = "in the first part"


def with_equation_above(own: list[Block], before: Sequence[Block], part: PartSolution) -> list[Block]:
    """The blocks of a case with that equation alone; as they are, where no earlier part had it. `before`: these."""
    motion = part.motion
    if motion is None or len(motion.oscillations) != 1 or not before or len(motion.oscillations[0].motion) != 1:
        return own
    at = next((i for i, b in enumerate(own) if isinstance(b, Paragraph) and b.line[:1] == (Text(SOLVED),)), None)
    steps = [i for i, b in enumerate(own[:at]) if isinstance(b, Heading) and b.label.startswith(STEP)]
    if at is None or not steps or not _only_derives(own, steps, at) or _is_renewed(own[steps[0] : at], before):
        return own
    equation, rest = own[at + 1], own[at + 2 :]
    every = (_as_there(e, name, place, equation, motion) for e, name, place in _linear(before))
    led = next((words for words in every if words), ())
    if not isinstance(equation, Equation) or not led:
        return own
    heading = own[steps[-1]]
    assert isinstance(heading, Heading)
    told: list[Block] = [Paragraph(led), replace(equation, lead=())]
    return [*own[: steps[0]], replace(heading, label=f"{STEP} 1"), *own[steps[-1] + 1 : at], *told, *rest]


def _only_derives(own: Sequence[Block], steps: Sequence[int], at: int) -> bool:
    """Do the steps before it serve the equation alone, and is nothing else told after it?"""
    titles, rest = [b.text for i in steps[:-1] if isinstance(b := own[i], Heading)], own[at + 2 :]
    cites = any(isinstance(p, Text) and CITED.search(p.text) for b in rest for p in pieces_of(b))
    more = any(isinstance(b, Heading | Paragraph) and b != Paragraph(line(CRITICAL)) for b in rest)
    return not cites and not more and all(title in (KINEMATICS, KINETICS) for title in titles)


def _is_renewed(derived: Sequence[Block], before: Sequence[Block]) -> bool:
    """Has something another value than before, as a moment of inertia of another size?"""
    said = {read_alike(replace(b, number=None)) for b in before if isinstance(b, Equation)}
    valued = (b for b in derived if isinstance(b, Equation) and isinstance(b.sides[-1], Value))
    return any(read_alike(replace(b, number=None)) not in said for b in valued)


def parts_of_page(before: Sequence[Block]) -> Iterator[tuple[str, Sequence[Block]]]:
    """The first part and each case, with the words that say where something stands."""
    cases = [(i, b.text) for i, b in enumerate(before) if isinstance(b, Heading) and b.label == CASE]
    words, starts = [FIRST, *(f"in case {name}" for _, name in cases)], [i for i, _ in cases]
    for place, begin, stop in zip(words, [0, *starts], [*starts, len(before)], strict=True):
        yield place, before[begin:stop]


def _linear(before: Sequence[Block]) -> Iterator[tuple[Equation, str, str]]:
    """The linear equations of earlier parts with the name of their deviation and the words that say where they are."""
    for place, blocks in parts_of_page(before):
        led = False
        for block in blocks:
            if isinstance(block, Paragraph):
                led = Text(LINEAR) in block.line or block.line[:1] == (Text(SOLVED),) or led
            elif isinstance(block, Heading):
                led = False
            elif led and isinstance(block, Equation) and (name := _deviation(block)):
                yield block, name, place
                led = False


def _deviation(equation: Equation) -> str:
    """`theta` of θ̈ + … = 0; "" of another equation."""
    first = equation.sides[0] if len(equation.sides) == 2 and equation.sides[1] == Math(sp.S.Zero) else ()
    symbol = first[0].expr if isinstance(first, tuple) and first and isinstance(first[0], Math) else None
    name = symbol.name if isinstance(symbol, sp.Symbol) else ""
    return name.removesuffix(SUFFIX) if name.endswith(SUFFIX) else ""


def _as_there(there: Equation, name: str, place: str, here: Block, motion: MotionTrace) -> Line:
    """`As in case light, with c = 0, …:`; (): it is another equation."""
    old, new = _sum(there), _sum(here) if isinstance(here, Equation) else None
    swing, value = motion.oscillations[0], motion.value
    if old is None or new is None or (name != DEVIATION.name and not _is_nought(name, swing.state, motion)):
        return ()
    # A letter that is zero in one case alone is another symbol there.
    mine = {**motion.ledger.symbols, **{s.name: s for s in new.free_symbols}}
    names = {s: DEVIATION.name + s.name.removeprefix(name) if _of(s, name) else s.name for s in old.free_symbols}
    old = old.xreplace({s: mine.get(own, sp.Symbol(own, real=True)) for s, own in names.items()})
    zeros = {s: sp.S.Zero for s in by_name(old.free_symbols - new.free_symbols) if value.known(s) == 0}
    if not identically_zero(old.xreplace(zeros) - new):
        return ()
    told = [line(Math(s), " = 0") for s in zeros]
    small = line(Math(DEVIATION), f" a small deviation from the equilibrium {swing.state}")
    told += [] if name == DEVIATION.name else [small]
    joined = (p for i, one in enumerate(told) for p in (" and " if i else ", with ", *one))
    return line(f"As {place}", *joined, ":")


def _of(symbol: sp.Symbol, name: str) -> bool:
    """Is it the deviation or a rate of it?"""
    return symbol.name in (name, f"{name}_dot", f"{name}{SUFFIX}")


def _is_nought(name: str, state: str, motion: MotionTrace) -> bool:
    """Is a coordinate zero in the equilibrium, so that it counts the deviation from there?"""
    roles = motion.ledger.roles
    places = [s for s, role in roles.items() if role.at == state and role.of is not None and role.of.name == name]
    return any(motion.value.known(s) == 0 for s in places)


def _sum(equation: Equation) -> sp.Expr | None:
    """The left side as one expression; None: numbers stand in it, or it is told otherwise."""
    side = equation.sides[0]
    total: sp.Expr = sp.S.Zero
    sign = 1
    for piece in side if isinstance(side, tuple) else ():
        if isinstance(piece, Math) and not piece.values:
            total, sign = total + sign * piece.expr, 1
        elif isinstance(piece, Text) and piece.text.strip() in ("+", "-"):
            sign = -1 if piece.text.strip() == "-" else 1
        else:
            return None
    return total
