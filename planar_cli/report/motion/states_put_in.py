"""States that the solution puts in: until when an assumption holds, or what happens there.

Up to t_taut = 1.749 s (state taut) the spring cord is not stretched; there l - s = 0.
Up to state free the spring from S to A is compressed; there its length is l_0.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.report.document.blocks import Block, Line, Math, Paragraph, Text, line
from planar_cli.report.document.mentioned import names_in
from planar_cli.report.notation.notation import plain
from planar_cli.report.oscillation.half_swings import ends_a_swing, goes_on
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.state_words import HAPPENS
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace

UP_TO = "Up to "
STATE_BEGINS = " (state "
WIDEST = 106
"""A sentence with a formula of more signs would break inside it."""


def turning_blocks(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """States that were put in: until when an assumption holds, or what happens there."""
    for turning_point in found.turnings:
        t, expr = turning_point.time, turning_point.expr
        if all(term.could_extract_minus_sign() for term in sp.Add.make_args(expr)):
            expr = -expr
        words = turning_point.words.replace(" within its", " is within its")
        if words in HAPPENS and goes_on(found, turning_point.state, expr):
            words = "it turns round"
        # Of half swings each takes the same time, which is told with them.
        t = None if ends_a_swing(found, turning_point.state) else t
        when = line(f"state {turning_point.state}")
        if t is not None:
            when = line(Math(t), " = ", phrases.shown(t), f"{STATE_BEGINS}{turning_point.state})")
        if words in HAPPENS:
            later = "" if turning_point.before.endswith("infinity") else turning_point.before
            said = line(f"{words[:1].upper()}{words[1:]} at ", *when, f", before {later}: " if later else ": ")
            yield Paragraph(line(*said, Math(expr), " = 0."))
            continue
        said = line(UP_TO, *when, " ", *spoken(words, found.ledger.symbols), "; there ")
        relaxed = _relaxed(expr, found) if words.startswith("the spring") and _is_wide(words, expr) else ()
        yield Paragraph(line(*said, *(relaxed or (Math(expr), " = 0")), "."))


def _is_wide(words: str, expr: sp.Expr) -> bool:
    return len(words) + len(plain(expr)) > WIDEST - len("Up to state ; there = 0.")


def _relaxed(expr: sp.Expr, found: MotionTrace) -> Line:
    """`its length is l_0`, in the place of l_0 - √(…) = 0, where the root, the distance of the ends of a spring, is all
    that changes in the motion; () of another formula.
    """
    terms = sp.Add.make_args(expr)
    changing = [term for term in terms if term.free_symbols & found.varying]
    if len(changing) != 1 or _unsigned(changing[0]).as_base_exp()[1] != sp.Rational(1, 2):
        return ()
    length = expr - changing[0]
    return line("its length is ", Math(_unsigned(length))) if _unsigned(length).is_Symbol else line("it is relaxed")


def _unsigned(expr: sp.Expr) -> sp.Expr:
    """A letter or its opposite without the sign."""
    return -expr if expr.could_extract_minus_sign() else expr


def without_unused_times(blocks: Sequence[Block]) -> list[Block]:
    """Blocks in which the time up to which something holds stands only where something else speaks of it: where the
    file asks for none, it comes from nothing on the page.
    """
    if not any(isinstance(b, Paragraph) and b.line[:1] == (Text(UP_TO),) for b in blocks):
        return list(blocks)
    spoken_of = Counter(name for block in blocks for name in names_in(block))
    return [_without_time(block, spoken_of) for block in blocks]


def _without_time(block: Block, spoken_of: Counter[str]) -> Block:
    match block:
        case Paragraph(line=(Text(text="Up to "), Math(expr=t), _, _, Text(text=state), *rest)) if (
            state.startswith(STATE_BEGINS) and t.is_Symbol and spoken_of[t.name] == 1
        ):
            return Paragraph(line(UP_TO, state.removeprefix(" (").removesuffix(")"), *rest))
        case _:
            return block
