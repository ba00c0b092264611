"""Forces and sums of forces near an equilibrium, to the first order in the deviation δ: all that is needed of a motion
of which only small oscillations are asked.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Line, Math, Paragraph, Text, line
from planar_cli.report.equations.steps import SOLVING
from planar_cli.report.instant.telling import Telling
from planar_cli.report.kinetics.actions import onward
from planar_cli.report.oscillation.linearised import DEVIATION
from planar_cli.report.oscillation.near_rest import SECOND_ORDER, near_the_rest, sides_near, swung, turned_off
from planar_cli.report.oscillation.oscillation import RATES
from planar_cli.report.oscillation.restoring_arms import rocking
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import LinearPart
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

ORDER = "to the first order in δ"


def in_small_deviations(
    blocks: list[Block], motion: MotionTrace, instant: InstantSolution, telling: Telling, phrases: Phrases
) -> list[Block]:
    """With the pulls and sums of a general position in their linear parts, and without the step that solves them; as
    they are where something else rests on this position, or nothing in it is long.
    """
    if not is_of_small_deviations(motion, instant):
        return swung(blocks, motion, instant)
    linear, near = {p.of: p for o in motion.oscillations for p in o.linear}, motion.oscillations[0].near
    by_number = _sums(telling, linear)
    whole = {} if near is None else sides_near(telling, near, DEVIATION)
    blocks = turned_off(blocks, motion, instant) if near is None else near_the_rest(blocks, near, instant, phrases)
    rocks = None if near is None else rocking(near, instant, phrases, telling.solving.constants)
    found: list[Block] = []
    for block in _unsolved(blocks):
        if isinstance(block, Equation) and block.number in by_number:
            found[-1:] = [_aside(found[-1])]
            sides = (phrases.math(by_number[block.number]), *block.sides[1:])
            found.append(replace(block, sides=sides, note=()))
        elif isinstance(block, Equation) and block.number in whole:
            found[-1:] = [*(() if rocks is None else rocks.told), _aside(found[-1])]
            left, right = whole[block.number]
            sides = (left, right if rocks is None or rocks.right is None else rocks.right)
            found.append(replace(block, sides=tuple(map(phrases.math, sides)), note=()))
        elif isinstance(block, Equation) and (pull := _pull(block, linear)) is not None:
            told = phrases.math(pull.constant + _varying(pull))
            found.append(replace(block, sides=(block.sides[0], told), lead=_first_order(block.lead), note=()))
        else:
            found.append(block)
    kind = Forces if near is None else Heading
    drawn = [i for i, b in enumerate(found) if isinstance(b, kind)]
    # Up to which order the accelerations go is said before them.
    last = -1 if not drawn else drawn[-1] if near is None else drawn[0]
    state, order = motion.oscillations[0].state, "" if near is None else SECOND_ORDER
    name = line(phrases.math(DEVIATION), f": a small deviation from the equilibrium {state}{order}")
    return [*found[: last + 1], Paragraph(name), *found[last + 1 :]]


def is_of_small_deviations(motion: MotionTrace, instant: InstantSolution) -> bool:
    """Is a general position told in its linear parts?"""
    at_rest_only = all(since == stop for since, stop in motion.regime(instant).stretches)
    linear = [o for o in motion.oscillations if o.linear or o.near is not None]
    inertial = instant.instant.principle.inertia_as_force
    return bool(linear) and len(motion.oscillations) == 1 and at_rest_only and not inertial


def _sums(telling: Telling, linear: Mapping[sp.Expr, LinearPart]) -> dict[int | None, sp.Expr]:
    """The linear left sides of sums of forces and moments, by the number that they have on the page."""
    found: dict[int | None, sp.Expr] = {}
    for stage in telling.stages:
        for w in (w for block in stage.blocks for w in block.equations):
            if w.law in ("force", "moment") and w.left in linear:
                part = _varying(linear[w.left])
                found[telling.number(stage, w.number)] = part if onward(w).left == w.left else -part
    return found


def _varying(part: LinearPart) -> sp.Expr:
    return part.slope * DEVIATION + part.damping * RATES[0]


def _pull(block: Equation, linear: Mapping[sp.Expr, LinearPart]) -> LinearPart | None:
    """The linear part of the force that a line names."""
    letter = block.sides[0]
    named = isinstance(letter, Math) and letter.expr.is_Symbol and bool(block.lead) and block.number is None
    return linear.get(letter.expr) if named and isinstance(letter, Math) else None


def _aside(block: Block) -> Block:
    """The words before a sum, with how far it goes."""
    return replace(block, line=_first_order(block.line)) if isinstance(block, Paragraph) else block


def _first_order(words: Line) -> Line:
    *parts, last = words
    if not isinstance(last, Text):
        return line(*words, f", {ORDER}")
    return line(*parts, f"{last.text.removesuffix(':')}, {ORDER}:")


def _unsolved(blocks: list[Block]) -> list[Block]:
    """Without the step that solves the equations."""
    start = next((i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == SOLVING), len(blocks))
    after = next((i for i, b in enumerate(blocks) if i > start and isinstance(b, Heading)), len(blocks))
    return [*blocks[:start], *blocks[after:]]
